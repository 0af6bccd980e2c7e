"""test_waiting.py - who calls whom by the object file's relocations, and who then has marks though it fails."""
import unittest

from grade.mark.waiting import calls_among, may_wait, read_relocations, waiting

# As objdump -r prints it, of code compiled with -ffunction-sections.
OBJDUMP = """
01-corners.o:     file format elf64-x86-64

RELOCATION RECORDS FOR [.text.upper_right]:
OFFSET           TYPE              VALUE
0000000000000012 R_X86_64_PLT32    upper_left-0x0000000000000004
0000000000000020 R_X86_64_PLT32    .text.helper+0x0000000000000010


RELOCATION RECORDS FOR [.text.helper]:
OFFSET           TYPE              VALUE
0000000000000012 R_X86_64_32S      table


RELOCATION RECORDS FOR [.data]:
OFFSET           TYPE              VALUE
0000000000000000 R_X86_64_64       image_plane_vector
"""


def judged(**states):
    return {name: {"state": state} for name, state in states.items()}


class Relocations(unittest.TestCase):
    def test_what_a_function_refers_to_is_read(self):
        refers = read_relocations(OBJDUMP)
        self.assertEqual(refers["upper_right"], {"VALUE", "upper_left", "helper"})
        self.assertEqual(refers["helper"], {"VALUE", "table"})

    def test_what_is_no_list_says_nothing(self):
        for text in ("", "\n\n", "RELOCATION RECORDS FOR", "a b", "\x00 \ufffd \u2028"):
            self.assertEqual(calls_among(read_relocations(text), ["a", "b"]), {"a": [], "b": []})

    def test_a_call_through_a_helper_is_a_call(self):
        refers = {"a": {"helper"}, "helper": {"b", "helper"}, "b": set()}
        self.assertEqual(calls_among(refers, ["a", "b", "c"]), {"a": ["b"], "b": [], "c": []})

    def test_two_that_call_each_other_do_not_excuse_each_other(self):
        refers = {"a": {"b"}, "b": {"c"}, "c": {"a", "d"}}
        self.assertEqual(calls_among(refers, ["a", "b", "c", "d"]), {"a": ["d"], "b": ["d"], "c": ["d"], "d": []})


class Marks(unittest.TestCase):
    def test_who_may_wait_for_whom(self):
        functions = judged(a="wrong", b="right", c="unanswered", d="waiting", e="wrong")
        self.assertEqual(may_wait(functions, {}), {"a": [], "d": ["a"], "e": ["a", "d"]})
        # A later one too, if the reference calls it in the same place.
        self.assertEqual(may_wait(functions, {"a": {"e"}}), {"a": ["e"], "d": ["a"], "e": ["a", "d"]})

    def test_only_an_attempt_is_worth_waiting_for(self):
        functions = judged(a="wrong", b="wrong", c="wrong", d="wrong")
        functions["a"]["mistake"] = "halves"
        self.assertEqual(waiting(functions, {"b": ["a"], "c": ["b"], "d": []}), {"b": ["a"], "c": ["b"]})
        functions["a"]["partly"] = "yes"
        self.assertEqual(waiting(functions, {"b": ["a"], "c": ["b"]}), {})

    def test_two_that_wait_for_each_other_have_none(self):
        functions = judged(a="wrong", b="wrong")
        self.assertEqual(waiting(functions, {"a": ["b"], "b": ["a"]}), {})
