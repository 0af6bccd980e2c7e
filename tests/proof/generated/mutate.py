"""mutate.py - wrong answers in C, made by slips of the pen in every answer that is known.

    mutate.py SEED MOST ERRORS PREPROCESSED... >MUTANTS.c

The sources are a stem's solution, known mistakes and right answers in other forms, as the preprocessor prints them. A
mutant is a line: the answer and its helpers, as far as they lead to what was changed. There are two kinds:
every plain slip in a solution, which a test must notice; and one slip or two in any answer, at most about MOST for each
exercise, chosen at random.
ERRORS is the compiler's output about an earlier result: the lines that it names are left out.
"""
import random
import re
import sys

TOKEN = re.compile(r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\'|[A-Za-z_]\w*|\.?\d(?:[eEpP][+-]|[\w.])*|\.\.\.|<<=|>>='
                   r'|->|\+\+|--|[-+*/%&|^<>=!]=|<<|>>|&&|\|\||\S')
ANSWERS = re.compile(r"(?:\./)?(solutions/.*|tests/\d[^/]*/(?:exact|wrong|right)\.c)$")
REFERENCE = "reference_"
SOLUTION, RIGHT = "the solution", "a right answer"  # labels; others are the names of mistakes
HEADS = """// Made by tests/proof/generated/mutate.py.
#include "tests/exercises.def"
#include "tests/judge/known.h"
#include <stdlib.h>
#include <string.h>
"""

# A word becomes another of its family. The first are members of structs.
MEMBERS = ("origin right up forward", "distance width height", "width height", "column row",
           "upper_left upper_right lower_left lower_right", "eye at up", "width aspect", "origin direction", "a b c",
           "x y", "s t", "diffuse specular shine", "ambient background color", "center position",
           "sphere_count light_count")
WORDS = ("< <= > >=", "== !=", "+= -=", "*= /=", "fmin fmax", "sin cos tan", "RIGHT_HANDED LEFT_HANDED",
         "LIGHT_POINT LIGHT_DISTANT", "floor ceil round",
         "CAMERA_NO_DISTANCE CAMERA_NO_WIDTH CAMERA_NO_HEIGHT CAMERA_NOT_FINITE CAMERA_NO_RECTANGLE CAMERA_OFF_AXIS "
         "CAMERA_NO_DIRECTION CAMERA_UP_ALONG_VIEW")
# Calls that may be forgotten, and results that may lose their sign.
FORGOTTEN = "sqrt fabs vec3_unit copysign floor exponent pow isfinite".split()
MAY_BE_NEGATIVE = ("vec3_dot", "reference_hit_sphere")
REAL = set("origin right up forward distance direction a b c x y s t radius center position color ambient background "
           "diffuse specular shine eye at aspect upper_left upper_right lower_left lower_right".split())


def is_name(word):
    return word[0].isalpha() or word[0] == "_"


def is_number(word):
    return word[0].isdigit() or (word[0] == "." and word[1:2].isdigit())


# ---- a source -------------------------------------------------------------------------------------

class Item:
    """A function, a declaration or a table at the top level: its tokens, and its name."""

    def __init__(self, name, start, body, end):
        self.name, self.start, self.body, self.end = name, start, body, end  # body: its {, or 0


class Source:
    def __init__(self, path):
        self.path, self.tokens, self.lines = "", [], []
        self.read(path)
        self.match = self.brackets()
        self.items = self.find_items()
        self.named = {}
        for item in self.items:  # of a function that is declared first, the definition
            if item.body or item.name not in self.named:
                self.named[item.name] = item
        self.calls = {item: self.find_calls(item) for item in self.items}
        self.reaches = {item: self.reached(item) for item in self.items}
        self.entries = self.find_entries()

    def read(self, path):
        wanted, line = False, 0
        for text in open(path, encoding="utf-8"):
            marker = re.match(r'# (\d+) "([^"]*)"', text)
            if marker:
                answer = ANSWERS.match(marker[2])
                wanted, line = answer, int(marker[1])
                self.path = self.path or (answer[1] if answer else "")
                continue
            if wanted and text[0] != "#":
                found = TOKEN.findall(text)
                self.tokens += found
                self.lines += [line] * len(found)
            line += 1

    def brackets(self):
        match, opened = {}, []
        for i, word in enumerate(self.tokens):
            if word in "([{":
                opened.append(i)
            elif word in ")]}":
                match[i] = opened.pop()
                match[match[i]] = i
        return match

    def find_items(self):
        items, start = [], 0
        while start < len(self.tokens):
            end, body = start, 0
            while end < len(self.tokens) and self.tokens[end] != ";":
                if self.tokens[end] == "{" and self.tokens[end - 1] == ")":
                    body = end
                end = self.match.get(end, end) if self.tokens[end] in "([{" else end
                if body:
                    break
                end += 1
            items.append(Item(self.name_of(start, end + 1), start, body, end + 1))
            start = end + 1
        return items

    def name_of(self, start, end):
        """The name before the ( of a function; the last name before [, = or ; of a table or a type."""
        name, i = "", start
        while i < min(end, len(self.tokens)):
            word = self.tokens[i]
            if word in ("__attribute__", "__typeof__"):
                i = self.match[i + 1]
            elif word == "{":
                i = self.match[i]
            elif word[0] in "(=[;" and name:
                break
            elif is_name(word):
                name = word
            i += 1
        return name

    def is_member(self, i):
        return self.tokens[i - 1] in (".", "->")

    def item_at(self, item, i):
        """The item that a token of an item names, or None."""
        named = self.named.get(self.tokens[i])
        declared = self.tokens[item.start] == "typedef" and self.tokens[i + 1] in "; , [ )".split() and i < item.end - 2
        return None if named is None or declared or self.is_member(i) else named

    def find_calls(self, item):
        return {called for i in range(item.body, item.end) for called in [self.item_at(item, i)]
                if called and called.body} if item.body else set()

    def reached(self, item):
        """The item itself, and all that it calls, directly or through others."""
        found, new = {item}, [item]
        while new:
            for called in self.calls[new.pop()] - found:
                found.add(called)
                new.append(called)
        return found

    def find_entries(self):
        """Answers: (exercise, label, function). An entry has strings, one the exercise, and (AnyFunction *)(f)."""
        entries, strings = [], []
        for i, word in enumerate(self.tokens):
            if word == "{":
                strings = []
            elif word[0] == '"':
                strings.append(word[1:-1])
            elif word == "AnyFunction":
                name = next(j for j in range(i + 3, i + 9) if is_name(self.tokens[j]))
                exercise = next((text for text in strings if text in EXERCISES), None)
                label = RIGHT if self.path.endswith("right.c") else "".join(strings).partition(exercise or "?")[0]
                if exercise and self.tokens[name] in self.named:
                    entries.append((exercise, label, self.named[self.tokens[name]]))
        return entries + [(item.name[len(REFERENCE):], SOLUTION, item) for item in self.items
                          if item.body and item.name.startswith(REFERENCE)]

    def is_of_a_table(self, item):
        return "KnownAnswer" in self.tokens[item.start:item.end]


# ---- slips ------------------------------------------------------------------------------------------

class Pen:
    """All slips of one function: PLAIN, FROM, TO, TEXT. Only tokens are looked at: the compiler finds what is not C."""

    def __init__(self, source, item):
        self.source, self.item = source, item
        self.slips = {}
        self.variables = self.find_variables()
        for i in range(item.body + 1, item.end - 1):
            self.between(i)
            self.instead(i)
            self.number(i)
            self.call(i)
            self.value(i)
            self.statement(i)
            if self.at(i) in ("-", "!") and not self.ends_value(i - 1):
                self.slip(i, i + 1, "", True)

    def at(self, i):
        return self.source.tokens[i] if self.item.start <= i < self.item.end else ";"

    def closing(self, i):
        return self.source.match.get(i, len(self.source.tokens) - 1)

    def words(self, start, end):
        return " ".join(self.at(i) for i in range(start, end))

    def slip(self, start, end, text, plain=False):
        """These tokens become that text. A plain slip is one that a test must notice."""
        old = self.words(start, end)
        balanced = all(old.count(a) - old.count(b) == text.count(a) - text.count(b) for a, b in ("()", "{}", "[]"))
        if self.item.body < start < end < min(self.item.end, start + 60) and old != text.strip() and balanced:
            self.slips[start, end, text] = plain or self.slips.get((start, end, text), False)

    def each_of(self, i, words, plain=False):
        for word in words.split():
            self.slip(i, i + 1, word, plain)

    # Where values and terms begin and end.

    def ends_value(self, i):
        word = self.at(i)
        return is_number(word) or (is_name(word) and word != "return") or word in (")", "]", "}")

    def end_of_primary(self, i):
        while self.at(i) in "-!&*+":
            i += 1
        i = self.closing(i) + 1 if self.at(i) in ("(", "{") else i + 1
        if self.at(i) == "{":  # (Type){ ... }
            i = self.closing(i) + 1
        while True:
            if self.at(i) in ("(", "["):
                i = self.closing(i) + 1
            elif self.at(i) in (".", "->"):
                i += 2
            else:
                return i

    def start_of_primary(self, end):
        i = end - 1
        while True:
            if self.at(i) in (")", "]", "}"):
                i = self.closing(i)
            before = self.at(i - 1)
            if self.at(i) in ("(", "[", "{") and (is_name(before) or before in ("]", ")")) and before != "return":
                i -= 1
            elif before in (".", "->"):
                i -= 2
            else:
                break
        return i - 1 if self.at(i - 1) in ("-", "!") and not self.ends_value(i - 2) else i

    def end_of_term(self, i):
        i = self.end_of_primary(i)
        while self.at(i) in ("*", "/"):
            i = self.end_of_primary(i + 1)
        return i

    def start_of_term(self, end):
        i = self.start_of_primary(end)
        while self.at(i - 1) in ("*", "/") and self.ends_value(i - 2):
            i = self.start_of_primary(i - 1)
        return i

    def end_of_condition(self, i, way=1):
        """One side of && or ||, or one argument, from here on."""
        while self.at(i) not in ("&& || ? : ; , ) }" if way > 0 else "&& || ? : ; , ( { = return").split():
            i = (self.closing(i) if self.at(i) in ("([{" if way > 0 else ")]}") else i) + way
        return i

    def end_of_statement(self, i):
        while self.at(i) != ";":
            i = (self.closing(i) if self.at(i) in "([{" else i) + 1
        return i + 1

    # Each kind of slip.

    def between(self, i):
        """Signs with a side on either hand."""
        sign, words = self.at(i), self.words
        if not self.ends_value(i - 1):
            return
        if sign in ("+", "-"):
            start, end = self.start_of_term(i), self.end_of_term(i + 1)
            self.slip(i, i + 1, "-" if sign == "+" else "+", True)
            self.slip(i, end, "")
            self.slip(start, i if sign == "-" else i + 1, "")
            if sign == "-":
                self.slip(start, end, f"{words(i + 1, end)} - {words(start, i)}")
        elif sign in ("*", "/"):
            start, end = self.start_of_primary(i), self.end_of_primary(i + 1)
            self.slip(i, i + 1, "/" if sign == "*" else "*", True)
            self.slip(i, end, "")
            if sign == "*":
                self.slip(start, i + 1, "")
            else:
                self.slip(start, end, f"{words(i + 1, end)} / {words(start, i)}")
        elif sign in ("&&", "||"):
            self.slip(i, i + 1, "||" if sign == "&&" else "&&", True)
            self.slip(i, self.end_of_condition(i + 1), "")
            self.slip(self.end_of_condition(i - 1, -1) + 1, i + 1, "")

    def instead(self, i):
        """Another word of the family, or another variable of the type."""
        word, member = self.at(i), self.at(i - 1) in (".", "->")
        for family in MEMBERS if member else WORDS:
            if word in family.split():
                self.each_of(i, family, True)
        if not is_name(word) or member or is_name(self.at(i - 1)):
            return
        kind = self.variables.get(word)
        for other in self.variables:
            if kind and self.variables[other] == kind:
                self.slip(i, i + 1, other, True)

    def number(self, i):
        word = self.at(i)
        if not is_number(word):
            return
        if self.at(i - 1) == "[":
            self.each_of(i, "0 1 2", True)
            return
        if re.search("[.xeE]", word):
            self.each_of(i, "0 1 (1/2)", "x" not in word)
            for other in (f"({word} * 2)", f"({word} / 2)", f"(1 - {word})"):
                self.slip(i, i + 1, other)
        else:
            value = int(re.match(r"\d+", word)[0])
            self.each_of(i, "0 1 2 3")
            self.slip(i, i + 1, f"{value + 1}", value < 4)
            self.slip(i, i + 1, f"({value - 1})", 0 < value < 4)
        self.slip(i, i + 1, f"(-{word})")

    def call(self, i):
        """A call of this function of these arguments."""
        if not is_name(self.at(i)) or self.at(i + 1) != "(":
            return
        close, start = self.closing(i + 1), i + 2
        if self.at(i) in FORGOTTEN:
            self.slip(i, close + 1, f"({self.words(start, self.end_of_condition(start))})", True)
        if self.at(i) in MAY_BE_NEGATIVE:
            self.slip(i, close + 1, f"fabs({self.words(i, close + 1)})")
        while start < close:
            end = self.end_of_condition(start)
            if end < close:
                after = self.end_of_condition(end + 1)
                swapped = f"{self.words(end + 1, after)} , {self.words(start, end)}"
                self.slip(start, after, swapped, self.at(i) == "vec3_cross")
            start = end + 1

    def is_real(self, start, end):
        """A number or a vector, as far as can be seen without knowing types."""
        last = self.at(end - 1)
        if end - start == 1:
            return self.variables.get(last) in ("double", "vec3", "Color")
        if last in (")", "]"):
            return is_name(self.at(start))
        return last in REAL or (last in ("width", "height") and self.at(end - 3) not in ("screen", "size"))

    def value(self, i):
        """At the beginning of a value: another sign, another precision, another length."""
        word, before = self.at(i), self.at(i - 1)
        begins = is_name(word) or is_number(word) or word == "("
        if not begins or self.ends_value(i - 1) or before in (".", "->", "-"):
            return
        end = self.end_of_primary(i)
        if self.at(end) in ("=", "++", "{") or is_name(self.at(end)) or word in ("return", "for", "if", "while"):
            return
        if not self.is_real(i, end):
            return
        words = self.words(i, end)
        if before != "+":
            self.slip(i, end, f"-{words}")
        if end - i <= 4:
            for other in (f"(int)({words})", f"(float)({words})", f"vec3_unit({words})", f"(2 * {words})"):
                self.slip(i, end, other)

    def statement(self, i):
        word, at = self.at(i), self.at
        if word == "?":  # a ? b : c
            colon = self.end_of_condition(i + 1)
            end, start = self.end_of_condition(colon + 1), self.end_of_condition(i - 1, -1) + 1
            if at(colon) == ":":
                self.slip(i + 1, end, f"{self.words(colon + 1, end)} : {self.words(i + 1, colon)}")
                self.slip(start, i, "1")
                self.slip(start, i, "0")
        if word == "if":
            close = self.closing(i + 1)
            for other in (f"!({self.words(i + 2, close)})", "1", "0"):
                self.slip(i + 2, close, other)
            self.slip(i, self.closing(close + 1) + 1 if at(close + 1) == "{" else self.end_of_statement(i), ";")
        if at(i - 1) in (";", "{", "}") and is_name(word):
            sign = self.end_of_primary(i)
            if at(sign) in ("=", "+=", "-=", "*=", "/=") and at(i - 1) != ")":
                self.slip(i, self.end_of_statement(i), ";")
            if at(sign) in ("+=", "-=", "*=", "/="):
                self.slip(sign, sign + 1, "=")

    def find_variables(self):
        """TYPE [*] NAME followed by what ends a declaration: the type of each name."""
        variables = {}
        for i in range(self.item.start, self.item.end - 1):
            pointer = self.at(i - 1) == "*"
            kind = self.at(i - 1 - pointer)
            if is_name(self.at(i)) and self.at(i + 1) in ("=", ";", ",", ")", "[") and is_name(kind) and \
                    kind != "return" and (not pointer or self.at(i - 3) == "const"):
                variables[self.at(i)] = kind
        return variables


# ---- mutants ----------------------------------------------------------------------------------------

class Mutant:
    """An answer with slips: {FROM: (ITEM, TO, TEXT)}."""

    def __init__(self, number, entry, slips, plain=False):
        self.number, self.source = number, SOURCES[number]
        self.exercise, self.label, self.item = entry
        self.slips, self.plain = slips, plain
        self.changed = {item for item, _, _ in slips.values()}

    def leads_to_change(self, item):
        return not self.changed.isdisjoint(self.source.reaches[item])

    def function(self, mutant):
        """The functions on the way from the answer to what was changed, in a line."""
        copied = {item for item in self.source.reaches[self.item] if self.leads_to_change(item)}
        ordered = [item for item in self.source.items if item in copied]
        names = {item: f"_m{mutant}" for item in copied}
        return "".join([head_of(self.number, item, names) for item in ordered] +
                       [text_of(self.number, item, item.start, item.end, names, self) for item in ordered])

    def change(self):
        """The old statements, and the new ones."""
        return "; ".join(self.statement(start, *slip) for start, slip in self.slips.items())

    def statement(self, start, item, end, text):
        tokens = self.source.tokens
        first, last = start, end
        while first > item.body + 1 and start - first < 25 and tokens[first - 1][0] not in ";{}":
            first -= 1
        while last < item.end - 1 and last - end < 25 and tokens[last][0] not in ";{}":
            last += 1
        words = [*tokens[first:start], f"[[{' '.join(tokens[start:end])} => {text}]]", *tokens[end:last]]
        return f"{item.name}:{self.source.lines[start]}: {' '.join(words)}"

    def row(self, mutant):
        quoted = re.sub(r'(["\\])', r"\\\1", self.change())
        return f'{{"{self.exercise}", "{self.source.path}: {self.label}", "{quoted}", {int(self.plain)}, ' \
               f"(AnyFunction *){self.item.name}_m{mutant}}},"


def head_of(number, item, names):
    return text_of(number, item, item.start, item.body, names) + "; "


def text_of(number, item, start, end, names, mutant=None):
    """Tokens of an item. Items of the top level get other names: by their source's number, or by the mutant's."""
    source, words, i = SOURCES[number], [], start

    def renamed(word, named):
        return f"{word}{names.get(named, f'_{number}')}" if named else word
    if item.body and "static" not in source.tokens[item.start:item.body] and start == item.start:
        words.append("static")
    while i < end:
        if mutant and i in mutant.slips:
            _, i, text = mutant.slips[i]
            before = ""
            for word in TOKEN.findall(text):
                words.append(renamed(word, None if before in (".", "->") else source.named.get(word)))
                before = word
            continue
        else:
            words.append(renamed(source.tokens[i], source.item_at(item, i) if is_name(source.tokens[i]) else None))
        i += 1
    return " ".join(words)


def source_lines(number):
    """Everything of a source except its answers' tables: the declarations, then the functions."""
    source = SOURCES[number]
    items = [item for item in source.items if not source.is_of_a_table(item)]
    wholes = [text_of(number, item, item.start, item.end, {}) for item in items]
    return [head_of(number, item, {}) if item.body else whole for item, whole in zip(items, wholes)] + \
        [whole for item, whole in zip(items, wholes) if item.body]


# ---- choosing ---------------------------------------------------------------------------------------

def slips_of_entry(number, entry):
    """Slips in the answer and its helpers; another exercise that it calls has tests of its own."""
    source = SOURCES[number]
    return [(plain, item, start, end, text) for item in source.items
            if item.body and item in source.reaches[entry[2]] and
            (item is entry[2] or not item.name.startswith(REFERENCE))
            for (start, end, text), plain in Pen(source, item).slips.items()]


def mutants_of(number, entry, wanted):
    """Plain slips of a solution are all there; three of four others have one slip, and the rest two."""
    is_solution = entry[1] == SOLUTION
    slips = slips_of_entry(number, entry)
    for plain, item, start, end, text in slips:
        if is_solution and plain:
            yield Mutant(number, entry, {start: (item, end, text)}, plain=True)
    others = [slip for slip in slips if not (is_solution and slip[0])]
    for _, item, start, end, text in CHANCE.sample(others, min(len(others), wanted * 3 // 4)):
        yield Mutant(number, entry, {start: (item, end, text)})
    for _ in range(wanted // 4 if len(slips) > 1 else 0):
        one, two = sorted((CHANCE.choice(slips), CHANCE.choice(slips)), key=lambda slip: slip[2])
        if one[3] <= two[2]:
            yield Mutant(number, entry, {start: (item, end, text) for _, item, start, end, text in (one, two)})


def all_mutants(most):
    """A solution gets half of the room of an exercise; the other answers share the rest."""
    entries = [(number, entry) for number, source in enumerate(SOURCES) for entry in source.entries]
    for number, entry in entries:
        others = sum(other[0] == entry[0] and other[1] != SOLUTION for _, other in entries)
        share = most // 2 if entry[1] == SOLUTION else max(4, most // 2 // max(1, others))
        yield from mutants_of(number, entry, share)


def main(most, errors):
    bad = {int(found[1]) for found in re.finditer(r"\.c:(\d+):.*error:", open(errors, encoding="utf-8").read())}
    lines, rows = HEADS.splitlines(), []
    for number in range(len(SOURCES)):
        lines += source_lines(number)
    for i, mutant in enumerate(all_mutants(most)):
        lines.append("" if len(lines) + 1 in bad else mutant.function(i))
        if lines[-1]:
            rows.append(mutant.row(i))
    print("\n".join([*lines, "static const Generated generated[] = {", *rows, "{0}};", "OF_STEM(generated)"]))


EXERCISES = re.findall(r'EXERCISE\("[^"]*", [^,]*, (\w+),', open("tests/exercises.def", encoding="utf-8").read())
CHANCE = random.Random(int(sys.argv[1]))
SOURCES = [Source(path) for path in sys.argv[4:]]
main(int(sys.argv[2]), sys.argv[3])
