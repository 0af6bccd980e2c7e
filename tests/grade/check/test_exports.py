"""test_exports.py - what learning platforms export, as they export it."""
import os

from grade.collect import submissions
from .packing import zipped
from .scratch import STEMS, Scratch

FIVE, ONE = "05-quadratic.c", "01-corners.c"


class Export(Scratch):
    def lay(self, *names, content=b"int a;\n"):
        for name in names:
            path = self.room / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)

    def all(self) -> dict:
        """name -> its answers' texts, in the order of the chapters"""
        found, others = submissions.find(self.room, STEMS)
        self.assertEqual(others, [name for name in ("submission_metadata.yml",) if (self.room / name).exists()])
        self.assertEqual(len({s.folder for s in found}), len(found))
        return {s.name: [answer.text for answer in submissions.collect(s, STEMS).answers.values()] for s in found}


class Canvas(Export):
    def test_loose_files_belong_to_their_user(self):
        self.lay(f"doejane_123_456_{ONE}", f"roejohn_LATE_124_459_{ONE}", content=b"x")
        self.lay(f"doejane_123_457_{FIVE}", f"müllerüte_126_460_{FIVE}", content=b"y")
        self.lay("poezoe_125_458_report.pdf")
        self.assertEqual(self.all(), {"doejane_123": [b"x", b"y"], "roejohn_124": [b"x", b""],
                                      "müllerüte_126": [b"", b"y"], "poezoe_125": [b"", b""]})

    def test_a_file_that_is_handed_in_again_counts_once_the_last(self):
        self.lay(f"doejane_123_456_{FIVE}", content=b"first")
        self.lay("doejane_LATE_123_1000_05-quadratic-2.c", content=b"third")
        self.lay("doejane_123_789_05-quadratic-1.c", content=b"second")
        self.assertEqual(self.all(), {"doejane_123": [b"", b"third"]})

    def test_one_that_was_only_handed_in_again_counts(self):
        self.lay("doejane_123_456_05-quadratic-1.c", content=b"x")
        self.assertEqual(self.all(), {"doejane_123": [b"", b"x"]})

    def test_archives_count_with_loose_files(self):
        self.lay("doejane_123_456_all.zip", content=zipped((FIVE, b"x"), (ONE, b"old")))
        self.lay(f"doejane_123_457_{ONE}", content=b"new")
        self.lay("roejohn_124_458_submission-1.zip", content=zipped((FIVE, b"y")))
        self.assertEqual(self.all(), {"doejane_123": [b"new", b"x"], "roejohn_124": [b"", b"y"]})

    def test_a_link_among_them_is_not_followed(self):
        (self.top / "secret").write_bytes(b"secret")
        (self.room / f"doejane_123_456_{FIVE}").symlink_to(self.top / "secret")
        self.assertEqual(self.all(), {f"doejane_123_456_{FIVE}": [b"", b""]})

    def test_names_that_only_look_alike_stay_apart(self):
        archive = zipped((FIVE, b"x"))
        for names in (("week_1_2_anna.zip", "week_1_2_ben.zip"), ("ws_2025_1_anna.zip", "ws_2025_2_ben.zip"),
                      ("a_1_2_x.zip", "b_1_3_x.zip")):
            self.lay(*names, content=archive)
            self.assertEqual(self.all(), {name: [b"", b"x"] for name in names})
            for name in names:
                (self.room / name).unlink()

    def test_a_name_that_only_looks_alike_spoils_nobody_else(self):
        self.lay(f"doejane_123_456_{ONE}", f"doejane_123_457_{FIVE}", "week_1_2_anna.c", "week_1_2_ben.c", content=b"x")
        self.assertEqual(self.all(), {"doejane_123": [b"x", b"x"], "week_1_2_anna.c": [b"", b""],
                                      "week_1_2_ben.c": [b"", b""]})


class Moodle(Export):
    def test_a_folder_with_files_or_an_archive_is_a_submission(self):
        self.lay(f"Jane Doe_123_assignsubmission_file_/{FIVE}", content=b"x")
        self.lay("Jörg Roe_124_assignsubmission_file_/mine.zip", content=zipped(("a/" + FIVE, b"y")))
        self.lay("Zoë Poe_125_assignsubmission_file/all.zip", content=zipped(("inner.zip", zipped((ONE, b"z")))))
        self.assertEqual(self.all(), {"Jane Doe_123": [b"", b"x"], "Jörg Roe_124": [b"", b"y"],
                                      "Zoë Poe_125": [b"z", b""]})

    def test_text_and_files_of_one_person_are_one_submission(self):
        self.lay("Jane Doe_123_assignsubmission_onlinetext_/onlinetext.html")
        self.lay(f"Jane Doe_123_assignsubmission_file_/{FIVE}", content=b"x")
        self.lay("Joe Roe_124_assignsubmission_onlinetext_/onlinetext.html")
        self.assertEqual(self.all(), {"Jane Doe_123": [b"", b"x"], "Joe Roe_124": [b"", b""]})

    def test_loose_files_belong_to_their_participant(self):
        self.lay(f"Jane Doe_123_assignsubmission_file_{ONE}", content=b"x")
        self.lay(f"Jane Doe_123_assignsubmission_file_{FIVE}", content=b"y")
        self.lay("Joe_Roe_124_assignsubmission_file_all.zip", content=zipped((FIVE, b"z")))
        self.assertEqual(self.all(), {"Jane Doe_123": [b"x", b"y"], "Joe_Roe_124": [b"", b"z"]})

    def test_people_of_one_name_stay_apart(self):
        self.lay(f"Jane Doe_123_assignsubmission_file_/{FIVE}", content=b"x")
        self.lay(f"Jane Doe_124_assignsubmission_file_/{FIVE}", content=b"y")
        self.assertEqual(self.all(), {"Jane Doe_123": [b"", b"x"], "Jane Doe_124": [b"", b"y"]})


class Gradescope(Export):
    METADATA = """---
submission_1001:
  :submitters:
  - :name: Jane Doe
    :sid: '42'
    :email: jane@example.org
  - :name: 'O''Neill, Zoë'
    :sid: '43'
  :created_at: 2025-11-03 09:12:44.000000000 Z
  :score: 0.0
  :history:
  - :id: 7
    :name: nobody
submission_1002:
  :submitters:
  - :name: Jane Doe (submission_1003)
  :score: 1.0
"""

    def test_folders_have_the_names_of_their_people(self):
        for number in (1001, 1002, 1003):
            self.lay(f"submission_{number}/{FIVE}", content=b"%d" % number)
        (self.room / "submission_metadata.yml").write_text(self.METADATA, encoding="utf-8")
        self.assertEqual(self.all(), {"Jane Doe, O'Neill, Zoë (submission_1001)": [b"", b"1001"],
                                      "Jane Doe (submission_1003) (submission_1002)": [b"", b"1002"],
                                      "submission_1003": [b"", b"1003"]})
        self.assertEqual([s.folder for s in submissions.find(self.room)[0]],
                         ["submission_1001", "submission_1002", "submission_1003"])

    def test_no_name_is_anybody_else_s(self):
        self.lay(f"submission_1/{FIVE}", f"Ann (submission_1)/{FIVE}")
        (self.room / "submission_metadata.yml").write_text("submission_1:\n  :submitters:\n  - :name: Ann\n")
        self.assertEqual(set(self.all()), {"submission_1", "Ann (submission_1)"})

    def test_a_list_that_is_a_link_or_noise_is_no_list(self):
        self.lay(f"submission_1/{FIVE}", content=b"x")
        self.lay("submission_metadata.yml", content=os.urandom(5000))
        self.assertEqual(self.all(), {"submission_1": [b"", b"x"]})
        (self.room / "submission_metadata.yml").unlink()
        (self.room / "submission_metadata.yml").symlink_to("/dev/zero")
        self.assertEqual(self.all(), {"submission_1": [b"", b"x"]})


class Copies(Export):
    """A copy of the toolkit or of the handout, of which exercises/ counts."""
    ELSEWHERE = ["solutions", "tests/handout/replay/blanks", "tests/05-quadratic", "tests", "build/blanks", "build/x/y",
                 "chapters",
                 ".make", "common"]

    def copy(self, top="", exercises=(FIVE,)) -> list:
        members = [(f"{top}{place}/{FIVE}", place.encode()) for place in self.ELSEWHERE]
        members += [(f"{top}build/submission.zip", zipped((FIVE, b"old"))), (f"{top}Makefile", b""),
                    (f"{top}exercises/05-quadratic.h", b"")]
        return members + [(f"{top}exercises/{name}", b"mine") for name in exercises]

    def lay_out(self, members):
        for name, content in members:
            self.lay(f"anna/{name}", content=content)

    def test_as_a_folder(self):
        for top in ("", "ray-casting/", "week 3/ray-casting/"):
            self.lay_out(self.copy(top))
            self.assertEqual(self.all(), {"anna": [b"", b"mine"]})
            self.assertEqual(self.answer().words, "")
            (self.room / "anna").rename(self.top / f"done{len(top)}")

    def test_as_an_archive_in_any_order(self):
        import gzip
        from .packing import tarred
        for top in ("", "ray-casting/"):
            members = self.copy(top)
            for them in (members, members[::-1]):
                for name, pack in (("anna.zip", zipped), ("anna.tar.gz", lambda *m: gzip.compress(tarred(*m)))):
                    self.lay(name, content=pack(*them))
                    self.assertEqual(self.all(), {name: [b"", b"mine"]})
                    (self.room / name).unlink()

    def test_as_an_archive_in_a_folder(self):
        self.lay("Jane_1_assignsubmission_file_/x.zip", content=zipped(*self.copy("ray-casting/")))
        self.assertEqual(self.all(), {"Jane_1": [b"", b"mine"]})

    def test_an_answer_that_is_missing_is_not_taken_from_elsewhere(self):
        self.lay_out(self.copy(exercises=()))
        self.assertEqual(self.answer().state, "missing")

    def test_a_folder_of_one_s_own_beside_exercises_is_not_passed_over(self):
        self.lay_out([*self.copy(), (f"mine/{FIVE}", b"other")])
        self.assertEqual(self.answer().state, "twice")

    def test_folders_of_these_names_without_exercises_are_folders(self):
        for name in ("solutions", "tests", "build/mine", "chapters/common"):
            self.lay(f"{name.replace('/', '-')}/{name}/{FIVE}", content=b"x")
        self.assertEqual(set(map(tuple, self.all().values())), {(b"", b"x")})

    def test_clones_may_be_large(self):
        self.lay_out(self.copy())
        for i in range(300):
            self.lay(f"anna/build/{i}/{FIVE}", f"anna/.git/objects/{i}")
        from grade.collect import folders
        self.addCleanup(setattr, folders, "ENTRIES", folders.ENTRIES)
        folders.ENTRIES = 100
        self.assertEqual((self.answer().text, self.collect().words), (b"mine", ""))
