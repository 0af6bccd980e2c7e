"""comment.py - the comment for a student on one function; it is written only here.

Fields first (a label, words), which pages lay out by themselves; then the same as lines of 79
columns, as 'make exercises' prints them. Hidden inputs are described, never printed, whatever the
record holds.
"""
import unicodedata

# ---- columns of a terminal ----------------------------------------------------------------------


COLUMNS, LABEL = 79, 13  # as in tests/course/page.c
NO_BREAK = "\u00a0"  # the judge's ~: a blank at which no line ends


def width(text: str) -> int:
    """Columns on a terminal: East Asian characters take two, combining characters take none."""
    if text.isascii():
        return len(text)
    return sum(0 if unicodedata.combining(c) else 2 if unicodedata.east_asian_width(c) in "WF" else 1 for c in text)


def fitted(text: str, columns: int) -> str:
    """Cut or padded to exactly that number of columns."""
    text = text[: 4 * columns]
    if width(text) > columns:
        while width(text) > columns - 2:
            text = text[:-1]
        text += ".."
    return text + " " * (columns - width(text))


def words_of(text: str):
    """Split at blanks, but a vector stays in one piece where it fits."""
    word, depth = "", 0
    for part in text.split(" "):
        word += (" " if word else "") + part
        depth += part.count("(") - part.count(")")
        if depth <= 0:
            yield word
            word, depth = "", 0
        elif width(word) >= COLUMNS - LABEL:
            yield from word.split(" ")
            word, depth = "", 0
    if word:
        yield word


def wrapped(label: str, words: str, indent: int = LABEL) -> list:
    """A label, then words that wrap under each other."""
    lines, line = [], label.ljust(indent)
    for word in filter(None, words_of(words)):
        blank = " " if len(line) > indent else ""
        if blank and width(line) + 1 + width(word) > COLUMNS:
            lines.append(line)
            line, blank = " " * indent, ""
        line += blank + word
    return [line.replace(NO_BREAK, " ").rstrip() for line in lines + [line]]


# ---- the comment --------------------------------------------------------------------------------


def sentence(function: dict) -> str:
    return function["test"].replace("_", " ").strip()


def names(them: list) -> str:
    return them[0] if len(them) == 1 else ", ".join(them[:-1]) + " and " + them[-1]


def mistake_words(mistake: dict, partly: bool = False) -> str:
    """Behind the colon a sentence goes on: no capital, but for a letter that is a name."""
    why = mistake["why"]
    if why[1:2].islower() or why.startswith("A "):
        why = why[0].lower() + why[1:]
    besides = " (Something else is also not right yet.)" if partly else ""
    return f"{mistake['formula']}: {why}{besides}".replace("~", NO_BREAK)


def mistake_fields(mistake: dict, partly: bool) -> list:
    """The judge's words about a mistake, and about the second one, if there is one."""
    told = [("looks like", mistake_words(mistake, partly)), ("you'd see", mistake["picture"].replace("~", NO_BREAK))]
    if "also" in mistake:
        told.append(("and also", mistake_words(mistake["also"])))
    return told


def waiting_words(function: dict) -> str:
    others = function["waiting_for"] or ["another function of its chapter"]
    marks = "it has its marks" if function["score"] or not function["max"] else "it has no marks until then"
    return f"right once {names(others)} {'is' if len(others) == 1 else 'are'}; {marks}"


def what_to_try(stem: str, function: dict) -> str:
    # A crash or a loop is found by looking, not by thinking.
    command = "debug" if function["state"] in ("timed out", "crashed") or function["how"] else "hint"
    return f"make {command} EX={stem[:2]}"


def fields(stem: str, function: dict) -> list:
    """Pairs of label and words; the label is empty if the words need none. [] if the function is right."""
    state = function["state"]
    if state == "right":
        return []
    if state == "waiting":
        return [("", waiting_words(function))]
    if state == "unanswered":
        return [("asked", function["prompt"]), ("try", what_to_try(stem, function))]
    told = [("", sentence(function))]
    if function["hidden"]:
        told.append(("given", "inputs drawn at random for this run, which are not shown"))
    else:
        told += [(name, value.replace("~", NO_BREAK)) for name, value in function["given"]]
        if function["expected"]:
            told.append(("expected", function["expected"].replace("~", NO_BREAK)))
            if not function["how"]:
                told.append(("yours", function["yours"].replace("~", NO_BREAK)))
    if function["how"]:
        told.append(("it", function["how"]))
    elif function["mistake"]:
        told += mistake_fields(function["mistake"], function["partly"])
    elif function["law"] and not function["hidden"]:  # a law quotes the numbers that break it
        told.append(("but", function["law"].replace("~", NO_BREAK)))
    told.append(("try", what_to_try(stem, function)))
    return [(label, words) for label, words in told if words]


def function_lines(stem: str, function: dict) -> list:
    """As plain text; [] where there is nothing to say."""
    lines = []
    for label, words in fields(stem, function):
        lines += wrapped("  " + label, words, LABEL if label else 2)
    return lines


STEM_SAYS = {
    "missing": "no {file} was found",
    "twice": "there is more than one file called {file}, and which is meant is not guessed",
    "does not compile": "{file} does not compile",
    "cannot be linked": "{file} cannot be linked",
    "not judged": "{file} was not judged",
}


def stem_says(stem: dict) -> str:
    """Why a whole stem has no verdicts, in one line; '' where it was judged."""
    if stem["state"] == "judged":
        return ""
    return STEM_SAYS.get(stem["state"], "{file}: " + stem["state"]).format(file=stem["stem"] + ".c")


def stem_lines(stem: dict) -> list:
    says = stem_says(stem)
    if not says or not stem["words"]:
        return [says] if says else []
    return [says + ":"] + stem["words"].rstrip("\n").split("\n")
