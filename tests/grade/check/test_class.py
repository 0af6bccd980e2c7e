"""test_class.py - who is in the class, and whose each submission is: 300 people on every platform, nobody lost or doubled."""
from grade.collect import submissions
from grade.people.matching import class_of
from grade.people.roster import Roster
from grade.people.sheets import Sheet, SheetError
from . import platforms
from .fixtures import WithFolder, lay

STEMS = ["01-corners", "05-quadratic"]


class Sheets(WithFolder):
    def sheet(self, raw: bytes) -> Sheet:
        path = self.work / "list.csv"
        path.write_bytes(raw)
        return Sheet(path)

    def test_a_file_that_nobody_filled_is_the_same_bytes(self):
        for raw in (b"name,id\r\nAnna,1\r\n", b"\xef\xbb\xbfname,id\nAnna,1", b'"name","id"\n"An ""x""\nna","1"\n',
                    "name\tid\r\nÄnne\t1\r\n".encode("utf-16"), "name;id\nA;\n".encode(), b"name,id\n\nAnna,1\n",
                    *(make(platforms.students(9)) for make, _, _ in platforms.PLATFORMS.values())):
            raw = raw.replace(b"\n\n", b"\n")   # empty lines are not kept
            self.assertEqual(self.sheet(raw).bytes(), raw)

    def test_only_the_cell_that_is_filled_changes(self):
        for raw, wanted in ((b"name,grade\r\nAnna,1\r\nBen,\r\n", b'name,grade\r\nAnna,"a, ""b"""\r\nBen,\r\n'),
                            (b'"name","grade"\n"Anna","1"', b'"name","grade"\n"Anna","a, ""b"""'),
                            (b"name,other,grade\nAnna\n", b'name,other,grade\nAnna,,"a, ""b"""\n')):
            sheet = self.sheet(raw)
            sheet.fill(sheet.rows[1], sheet.column("Grade"), 'a, "b"')
            self.assertEqual(sheet.bytes(), wanted)
        sheet = self.sheet(b'name,grade\nAnna,"1"\nBen,2\n')
        for row in sheet.rows[1:]:
            sheet.fill(row, 1, "5")
        self.assertEqual(sheet.bytes(), b'name,grade\nAnna,"5"\nBen,5\n')

    def test_no_cell_that_is_filled_is_run_by_a_spreadsheet(self):
        sheet = self.sheet(b"name,grade\nAnna,1\n")
        for text, wanted in (("=1+1", "'=1+1"), ("-2+3", "'-2+3"), ("@x", "'@x"), ("-2.5", "-2.5"), ("+3", "'+3")):
            sheet.fill(sheet.rows[1], 1, text)
            self.assertEqual(sheet.cell(sheet.rows[1], 1), wanted)

    def test_what_is_no_table_is_said_with_its_line(self):
        for raw, words in ((b"", "empty"), (b"\xff\xfe\x00", "not text"), (b"caf\xe9,x\n", "not text"),
                           (b'name,id\nAnna,"1\n', "list.csv:2: a quotation mark that does not end")):
            self.assertRaisesRegex(SheetError, words, self.sheet, raw)


class Lists(WithFolder):
    def roster(self, raw) -> Roster:
        path = self.work / "list.csv"
        path.write_bytes(raw if isinstance(raw, bytes) else raw.encode())
        return Roster(path)

    def test_everybody_is_on_each_platform_s_list_once(self):
        them = platforms.students()
        for platform, (make, _, _) in platforms.PLATFORMS.items():
            with self.subTest(platform):
                people = self.roster(make(them)).people
                self.assertEqual(len(people), len(them))
                for person, one in zip(people, them):
                    said = {"name": one.name, "id": one.id, "login": one.login, "mail": one.mail, "number": str(one.number)}
                    for field, value in said.items():
                        self.assertIn(getattr(person, field), {"", value} if field != "name" else {one.name, one.id})

    def test_a_list_that_is_wrong_is_said_with_its_line(self):
        for text, words in (("a,b\n1,2\n", ":1: no column is called name, id, login or mail"),
                            ("name,id\n", "nobody is on this list"),
                            ("name,id\nAnna,1\nBen,1\n", ":3: id 1 is also in line 2"),
                            ("name\nAnna\nBen\nAnna\n", ":2: Anna is there twice"),
                            ("name,id,section\nAnna,1,A\n,,B\n", ":3: nobody's name")):
            self.assertRaisesRegex(SheetError, words, self.roster, text)

    def test_people_of_one_name_are_shown_apart(self):
        self.assertEqual(list(self.roster("name,id\nKim Li,1\nKim Li,2\nBen,3\n").titles().values()), ["Kim Li (1)", "Kim Li (2)", "Ben"])


class Classes(WithFolder):
    def class_of(self, files: dict, roster) -> tuple:
        room, path = self.work / "class", self.work / "roster.csv"
        room.mkdir()
        lay(room, files)
        path.write_bytes(roster if isinstance(roster, bytes) else roster.encode())
        return class_of(room, path, STEMS)

    def texts(self, submission) -> bytes:
        return submissions.collect(submission, STEMS).answers["01-corners"].text if submission.parts else b""

    def test_nobody_is_lost_or_doubled_on_any_platform(self):
        for platform, (make, download, tells_apart) in platforms.PLATFORMS.items():
            with self.subTest(platform):
                them = platforms.students()
                if tells_apart:
                    them[7].name_then = "Somebody Else"
                else:   # two of one name are left alone, and named
                    them[0].texts = them[1].texts = []
                found = self.class_of(download(them), make(them))
                self.assertEqual([submission.person.name for submission in found.found if submission.person],
                                 [one.id if platform == "GitHub Classroom" else one.name for one in them])
                self.assertEqual([submission.unlisted for submission in found.found if not submission.person], [])
                for submission, one in zip(found.found, them):
                    self.assertEqual(self.texts(submission), one.answer)
                self.assertEqual(len({submission.folder for submission in found.found}), len(them))
            self.setUp()

    def test_the_last_attempt_counts_and_is_named(self):
        for download, words in ((platforms.canvas, "upload 29002"), (platforms.blackboard, "2025-11-15 23:59"),
                                (platforms.brightspace, "2025-11-15 00:01")):
            one = platforms.Student("Anna", "Abel", "1", "u1", 4000, texts=[b"first", b"second", b"third"])
            collected = submissions.collect(self.class_of(download([one]), platforms.own_list([one])).found[-1], STEMS)
            answer = collected.answers["01-corners"]
            self.assertEqual((answer.text, answer.words), (b"third", f"handed in 3 times; the last one counts: {words}"))
            self.setUp()

    ROSTER = "name,id,login,mail\nAnna Abel,1,anna,anna@x.org\nBen Baker,2,ben,ben@x.org\nKim Li,3,kli,\nKim Li,4,kim2,\n" \
             "Jan van Doe,5,jan,\n"

    def test_whose_a_folder_is(self):
        for name, person in (("anna", "1"), ("ANNA", "1"), ("1", "1"), ("anna@x.org", "1"), ("Abel, Anna", "1"), ("abel_anna", "1"),
                             ("AnnaAbel", "1"), ("Kim Li", ""), ("kim2", "4"), ("annna", ""), ("anna abel 2", ""), ("an", ""),
                             ("vandoejan_5_77_01-corners.c", "5"), ("jan van doe", "5"), ("week-1-anna", "")):
            with self.subTest(name):
                path = name if name.endswith(".c") else f"{name}/01-corners.c"
                found = self.class_of({path: b"x"}, self.ROSTER).found
                keys = [submission.person.key for submission in found if submission.person and submission.parts]
                self.assertEqual(keys, [person] if person else [])
            self.setUp()

    def test_a_name_does_not_overrule_the_platform_s_number(self):
        one = platforms.Student("Anna", "Abel", "1", "u1", 4000, texts=[b"x"])
        found = self.class_of({"Anna Abel_999_assignsubmission_file_/01-corners.c": b"x"}, platforms.moodle_worksheet([one])).found
        self.assertEqual([(bool(one.parts), one.unlisted) for one in found],
                         [(False, ""), (True, "it fits nobody on the list; closest: Anna Abel")])

    def test_users_of_blackboard_may_have_underscores(self):
        files = {f"HW_1_{user}_attempt_2025-11-14-23-59-59_01-corners.c": b"x" for user in ("a_doe", "b_doe", "b_roe")}
        room = self.work / "class"
        lay(room, files)
        self.assertEqual([one.name for one in class_of(room, None, STEMS).found], ["a_doe", "b_doe", "b_roe"])

    def test_what_fits_nobody_or_two_is_listed_with_the_closest(self):
        found = self.class_of({"annna/01-corners.c": b"x", "kim li/01-corners.c": b"y", "anna.zip": b"", "zzz/x": b""}, self.ROSTER).found
        self.assertEqual({one.name: one.unlisted for one in found if not one.person},
                         {"annna": "it fits nobody on the list; closest: Anna Abel",
                          "kim li": "it fits 2 people: Kim Li (3), Kim Li (4)", "zzz": "it fits nobody on the list"})

    def test_a_list_that_fits_no_submission_is_refused(self):
        files = {"anna/01-corners.c": b"x", "ben/01-corners.c": b"y"}
        with self.assertRaisesRegex(SheetError, "fits none of 2 submissions.*it has ID, Vorname"):
            self.class_of(files, "ID,Vorname\n901,Xenia\n902,Yuri\n")

    def test_a_word_that_fits_nobody_or_two_says_whom_it_may_mean(self):
        found = self.class_of({"anna/01-corners.c": b"x"}, self.ROSTER)
        self.assertEqual([found.fits(words) for words in ("Ana Abel", "kim li", "zzz")],
                         ["fits nobody of the class; closest: Anna Abel", "fits 2 people: Kim Li (3), Kim Li (4)", "fits nobody of the class"])

    def test_files_that_are_nobody_s_are_named_and_are_not_people(self):
        found = self.class_of({"Class list.xlsx": b"", "notes.txt": b"", "anna.pdf": b"", "ben/01-corners.c": b"x"}, self.ROSTER)
        self.assertEqual(found.others, ["Class list.xlsx", "notes.txt"])
        self.assertEqual([one.person.key for one in found.found if one.parts], ["1", "2"])

    def test_a_person_as_folder_and_archive_is_one(self):
        found = self.class_of({"anna/01-corners.c": b"x", "Anna Abel/05-quadratic.c": b"y", "1/01-corners.c": b"x"}, self.ROSTER).found
        answers = submissions.collect(found[0], STEMS).answers
        self.assertEqual([answer.text for answer in answers.values()], [b"x", b"y"])

    def test_each_of_a_group_has_its_submission(self):
        files = {"submission_1/01-corners.c": b"x", "submission_metadata.yml":
                 b"submission_1:\n  :submitters:\n  - :name: Anna Abel\n    :sid: '1'\n  - :name: B\n    :email: ben@x.org\n"}
        found = self.class_of(files, self.ROSTER).found
        self.assertEqual([one.person.key for one in found if one.parts], ["1", "2"])
        self.assertEqual(len({one.folder for one in found}), len(found))

    def test_a_key_that_no_folder_can_have_is_no_obstacle(self):
        found = self.class_of({"anna/01-corners.c": b"x", "ben/01-corners.c": b"x"}, "name,id\nAnna,1/2\0\nBen,..\n").found
        self.assertEqual([one.folder for one in found], ["1_2_", "~5ec1f7e700f3"])

    def test_a_folder_around_the_class_is_not_a_submission_but_a_student_s_is(self):
        for files, roster, keys in (({"all/anna/01-corners.c": b"x", "all/ben/x": b""}, self.ROSTER, ["1", "2"]),
                                    ({"x/y/Abel_Anna_anna_7/01-corners.c": b"x"}, self.ROSTER, ["1"]),
                                    ({"anna/week 1/01-corners.c": b"x", "anna/week 2/05-quadratic.c": b""}, self.ROSTER, ["1"]),
                                    ({"anna/ray-casting/exercises/01-corners.c": b"x"}, self.ROSTER, ["1"])):
            found = self.class_of(files, roster).found
            self.assertEqual([one.person.key for one in found if one.person and one.parts], keys)
            self.setUp()
