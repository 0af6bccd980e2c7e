"""test_similar.py - who agrees in an unusual way: what only two have is found, what everybody was given is not."""
import os
import shutil
import tempfile
import unittest
from pathlib import Path
from unittest.mock import patch

from grade.people.history import remember
from grade.people.similar import answers_in, pairs_of, report
from grade.report.files import keep_answers, write_submission
from .fixtures import WithFolder
from .records import MISTAKE, function, record, stem

STEM = "01-corners"
SOLUTION = Path("solutions", f"{STEM}.c").read_text()
LONG = "\n".join(f"    double part_{at} = {at} * thing + {at * at};" for at in range(30))


@unittest.skipUnless(shutil.which("sim_c"), "sim_c is missing: make setup FOR=instructor")
class Similar(WithFolder):
    def pairs(self, wrong: dict | None = None, **texts: str) -> list:
        """wrong: of some a function that is."""
        for who, one in (wrong or {}).items():
            write_submission(record(who, [stem(STEM, [one])], folder=who), str(self.work / who))
        remember([record(who, [], folder=who) for who in texts], self.work)
        for who, text in texts.items():
            keep_answers({STEM: text.encode()}, str(self.work), who)
        return pairs_of(answers_in(self.work, [STEM])[STEM])

    def ordinary(self, size: int = 30) -> dict:
        return {f"s{at:02}": f"{SOLUTION}\n// my own remark number {at}\ndouble helper_{at}(void);\n" for at in range(size)}

    def test_what_everybody_was_given_is_no_agreement(self):
        self.assertEqual(self.pairs(**self.ordinary()), [])

    def test_an_unusual_comment_and_helper_of_two_come_first(self):
        texts = self.ordinary()
        for who in ("s03", "s17"):
            texts[who] += "// the corners lie in the corner, obviously\ndouble halve_it(double x);\n"
        for who in ("s05", "s09"):
            texts[who] += "double thing_of(double x);\n"
        pairs = sorted(self.pairs(**texts), key=lambda pair: -pair.weight)
        self.assertEqual([(pair.one.who, pair.other.who) for pair in pairs], [("s03", "s17"), ("s05", "s09")])
        self.assertEqual(set(pairs[0].shared), {"// the corners lie in the corner, obviously", "halve_it"})

    def test_what_many_have_is_not_unusual(self):
        texts = {who: text + "// as we said in the tutorial\n" * (who < "s08") for who, text in self.ordinary().items()}
        self.assertEqual(self.pairs(**texts), [])

    def test_the_same_unusual_slip_comes_before_a_mistake_that_is_known(self):
        slip = {"state": "wrong", "test": "a_test", "yours": "(7, 7, 7)"}
        wrong = {"s03": function("upper_left", **slip), "s17": function("upper_left", **slip),
                 "s05": function("upper_left", **slip, mistake=MISTAKE), "s09": function("upper_left", **slip, mistake=MISTAKE),
                 "s11": function("upper_left", state="unanswered"), "s12": function("upper_left", state="unanswered")}
        pairs = sorted(self.pairs(wrong, **self.ordinary()), key=lambda pair: -pair.weight)
        self.assertEqual([(pair.one.who, pair.other.who, pair.shared) for pair in pairs],
                         [("s03", "s17", ["wrong result of upper_left: (7, 7, 7)"]),
                          ("s05", "s09", [f"mistake in upper_left: {MISTAKE['formula']}"])])

    def test_jplag_compares_if_its_jar_is_named(self):
        java = self.work / "java"
        java.write_text("#!/bin/sh\necho \"$@\" >../asked\nmkdir result\nprintf '%s\\n' submissionName1,submissionName2,"
                        "averageSimilarity,maximumSimilarity 4.c,2.c,0.6,0.8 1.c,0.c,0.9,0.3 >result/results.csv\n")
        java.chmod(0o755)
        with patch.dict(os.environ, PATH=f"{self.work}:{os.environ['PATH']}", JPLAG="jplag.jar", TMPDIR=str(self.work)), \
                patch.object(tempfile, "tempdir", None):
            pairs = self.pairs(**self.ordinary(6))
        self.assertEqual([(pair.one.who, pair.other.who, pair.percent) for pair in pairs], [("s02", "s04", 80)])
        self.assertIn("--language c", (self.work / "asked").read_text())

    def test_the_same_text_under_other_names_is_found(self):
        texts = self.ordinary()
        texts["s02"] += LONG
        texts["s11"] += LONG.replace("part_", "share_").replace("thing", "stuff")
        found = [pair for pair in self.pairs(**texts) if pair.percent]
        self.assertEqual([(pair.one.who, pair.other.who) for pair in found], [("s02", "s11")])
        self.assertGreater(found[0].percent, 80)

    def test_the_page_shows_text_as_text_and_warns(self):
        texts = self.ordinary()
        for who in ("s03", "s17"):
            texts[who] += "// </pre><script>alert(1)</script> \x1b[2J and \u202e more\ndouble halve_it(double x);\n"
        told = report(self.pairs(**texts), 30)
        self.assertNotIn("<script>", told)
        self.assertNotIn("\x1b", told)
        self.assertIn("In a function of three lines the same formula means nothing", told)
