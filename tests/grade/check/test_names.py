"""test_names.py - names are shown and stored apart, whatever they are made of."""
import unicodedata
import unittest

from grade.collect import names
from grade.visible import brief, spelled


class Visible(unittest.TestCase):
    def test_plain_names_stay_as_they_are(self):
        for name in ("anna", "Zoë Müller-Łukasz", "李小龙", "week 3/05-quadratic.c", "-rf",
                     "it's \"so\""):
            self.assertEqual(spelled(name), name)

    def test_what_moves_or_hides_text_is_escaped(self):
        for raw, shown in ((b"a\nb", "a\\nb"), (b"\x1b[2J", "\\x1b[2J"), (b"\xff", "\\udcff"),
                           ("a\u202eb".encode(), "a\\u202eb"), ("\u2066".encode(), "\\u2066"),
                           ("\u200b".encode(), "\\u200b"), ("\u2028".encode(), "\\u2028"),
                           ("\u3164".encode(), "\\u3164"), (b"\x7f", "\\x7f"),
                           ("\U000e0041".encode(), "\\U000e0041"), (b"\r\t", "\\r\\t")):
            self.assertEqual(spelled(names.decoded(raw)), shown)

    def test_spaces_that_a_reader_would_lose_are_escaped(self):
        self.assertEqual(spelled(" a  b "), "\\x20a \\x20b\\x20")

    def test_what_looks_like_an_escape_is_not_one(self):
        self.assertEqual(spelled("a\\nb"), "a\\\\nb")

    def test_no_two_short_names_are_shown_alike(self):
        alphabet = [b"\\", b"n", b"\n", b" ", b"\xc3\xa9", b"e\xcc\x81", b"\xff", b"x20"]
        raws = {a + b + c for a in alphabet for b in alphabet for c in alphabet}
        self.assertEqual(len(set(names.shown(sorted(raws)))), len(raws))

    def test_two_codings_of_a_letter_are_shown_apart(self):
        self.assertEqual(names.shown(["é".encode(), "e\u0301".encode(), "ö".encode()]),
                         ["\\xe9", "e\\u0301", "ö"])

    def test_a_long_text_keeps_its_ends(self):
        cut = brief("a" * 500 + "b" * 500)
        self.assertEqual((len(cut), cut[0], cut[-1]), (160, "a", "b"))


class Folders(unittest.TestCase):
    def folders(self, *entries):
        suffixes = {"zip": 4, "gz": 7}
        return names.folders([(raw if isinstance(raw, bytes) else raw.encode(),
                               suffixes.get(str(raw).rsplit(".")[-1], 0)) for raw in entries])

    def test_an_archive_loses_its_suffix(self):
        self.assertEqual(self.folders("anna.zip", "bob.tar.gz", "carl"), ["anna", "bob", "carl"])

    def test_an_archive_keeps_its_suffix_beside_its_folder(self):
        self.assertEqual(self.folders("anna", "anna.zip"), ["anna", "anna.zip"])
        self.assertEqual(self.folders("anna.tar.gz", "anna.zip"), ["anna.tar.gz", "anna.zip"])

    def test_names_that_a_file_system_may_hold_stay(self):
        for name in ("-rf", " a b ", "a\nb", "it's \"so\"", "李小龙", "..a"[2:] + "..", "=1+1"):
            self.assertEqual(self.folders(name), [name])

    def test_no_folder_is_hidden_or_leads_elsewhere(self):
        for name in (".", "..", "..zip", ".zip", ".git", "...", "..tar.gz"):
            folder, = self.folders(name)
            self.assertFalse(folder.startswith(".") or folder == "" or "/" in folder, folder)

    def test_no_folder_takes_the_name_of_a_report(self):
        for name in ("grades.csv", "JUnit.XML", "grades.tap", "index.html", "ｉndex.html"):
            folder, = self.folders(name)
            self.assertNotIn(folder.lower(),
                             ("grades.csv", "junit.xml", "grades.tap", "index.html"))
        self.assertEqual(self.folders("index.html.zip"), ["index.html.zip"])

    def test_no_two_folders_are_one_where_case_and_coding_are_ignored(self):
        entries = ["anna", "ANNA", "Anna.zip", "anna.zip.zip", "é", "e\u0301", "É", "straße",
                   "STRASSE", "anna.ZIP", b"a\xff", "a%FF", "x" * 250, "x" * 251, "é" * 120]
        for _ in range(3):  # and somebody who knows what the others become
            entries = list(dict.fromkeys([*entries, *self.folders(*entries)]))
        folders = self.folders(*entries)
        self.assertEqual(len({unicodedata.normalize("NFD", folder.casefold())
                              for folder in folders}), len(entries))

    def test_a_folder_is_well_formed_and_not_long(self):
        for name in ("x" * 255, "é" * 127, "x" * 251 + ".zip", b"\xff" * 255):
            folder, = self.folders(name)
            self.assertLessEqual(len(folder.encode()), 200)

    def test_a_long_name_keeps_its_beginning(self):
        self.assertTrue(self.folders("x" * 255)[0].startswith("x" * 180))

    def test_a_name_depends_on_no_other_and_no_order(self):
        entries = ["anna", "ANNA", "bob.zip", "carl"]
        self.assertEqual(self.folders(*entries), self.folders(*entries[::-1])[::-1])
        self.assertEqual(self.folders("bob.zip"), self.folders(*entries)[2:3])
