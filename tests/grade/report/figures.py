"""figures.py - a class in figures: how the scores lie, and what went wrong most.

Everybody who handed in something and has a score counts.
"""
import statistics

from .comment import mistake_words, sentence
from .points import NOTHING

BINS = 10
MOST = 8  # that many are explained again


def stems_of(records: list) -> list:
    return sorted({stem["stem"] for record in records for stem in record["stems"]})


def circumstances(records: list) -> list:
    """Pairs of a label and words: what the class was marked with."""
    seeds = sorted({str(record["seed"]) for record in records})
    boxes = sorted({record["sandbox"] for record in records if record["sandbox"]})
    return [("seed", ", ".join(seeds)), ("sandbox", "; ".join(boxes) or "none")]


def scored(records: list) -> list:
    """Without those who handed in nothing or are excused, those that cannot be read, and those that the grader failed on."""
    return [record for record in records if record["score"] is not None and record["status"] != NOTHING]


def handed_in(records: list) -> list:
    return [record for record in records if record["status"] != NOTHING]


def how_many(records: list) -> str:
    nothing = len(records) - len(handed_in(records))
    if not any(record["person"] for record in records):
        return f"{len(records)} submissions."
    listed = sum(bool(record["person"]) for record in records)
    return f"{listed} on the list, {nothing} of whom handed in nothing." + \
        (f" {len(records) - listed} submissions of others." if listed < len(records) else "")


def percent(record: dict) -> float:
    return 100 * record["score"] / record["max"] if record["max"] > 0 else 0


def bins(records: list) -> list:
    """Pairs: '0-9', how many; the last is 90-100, in percent of what could be had."""
    count = [0] * BINS
    for record in scored(records):
        count[min(max(int(percent(record) / BINS), 0), BINS - 1)] += 1
    ends = [f"{10 * i}-{10 * i + 9 if i < BINS - 1 else 100}" for i in range(BINS)]
    return list(zip(ends, count))


def quartiles(records: list) -> tuple:
    """Lower quartile, median, upper quartile of the scores."""
    scores = [record["score"] for record in scored(records)]
    if len(scores) < 2:
        return tuple(scores * 3) if scores else (0, 0, 0)
    return tuple(statistics.quantiles(scores, n=4, method="inclusive"))


def trouble(function: dict):
    """The kind of failure, as a key and a sentence; None if nothing went wrong."""
    if function["state"] in ("timed out", "crashed"):
        how = function["how"] or sentence(function)
        said = how.startswith(function["state"])
        return function["state"], how if said else f"{function['state']}: {how}"
    if function["state"] != "wrong":
        return None
    if function["mistake"]:
        return "mistake " + function["mistake"]["id"], mistake_words(function["mistake"])
    return "test " + function["test"], "fails: " + sentence(function)


def made_by(records: list) -> dict:
    """Of each mistake, by what it is: stem, function, sentence, who (their records)."""
    made = {}
    for record in records:
        for stem in record["stems"]:
            if stem["state"] != "judged":
                continue
            for function in stem["functions"]:
                found = trouble(function)
                if found:
                    key = (stem["stem"], function["name"], found[0])
                    new = {"stem": stem["stem"], "function": function["name"], "sentence": found[1], "who": []}
                    made.setdefault(key, new)["who"].append(record)
    return made


def most_made(records: list) -> list:
    """These, the most frequent first."""
    made = made_by(records)
    # Of equals, those that have a name first: they can be explained.
    order = sorted(made, key=lambda key: (-len(made[key]["who"]), not key[2].startswith("mistake"), key))
    shared = [key for key in order if len(made[key]["who"]) > 1]
    return [made[key] for key in (shared or order)[:MOST]]


def sections(records: list) -> list:
    """Their names; [] if there is only one."""
    found = sorted({record["person"].get("section", "") for record in handed_in(records)})
    return found if len(found) > 1 else []


def of_section(records: list, section: str) -> list:
    return [record for record in records if record["person"].get("section", "") == section]


def by_exercise(records: list) -> list:
    """Of each function that was judged: its stem, its name, and pairs of how many have it right, of how many who handed in
    something; first of everybody, then of each section."""
    asked = dict.fromkeys((stem["stem"], function["name"]) for record in records for stem in record["stems"]
                          for function in stem["functions"])
    groups = [handed_in(group) for group in (records, *(of_section(records, section) for section in sections(records)))]

    def right(group: list, stem: str, name: str) -> int:
        return sum(function["state"] == "right" for record in group for one in record["stems"] if one["stem"] == stem
                   for function in one["functions"] if function["name"] == name)

    return [(stem, name, [(right(group, stem, name), len(group)) for group in groups]) for stem, name in sorted(
        asked, key=lambda pair: pair[0])]


def not_answered(records: list) -> list:
    """What ('06-ray-casting nearest_hit', or a stem without its file), and how many; in the end how many are not listed."""
    count = {}
    for record in records:
        for stem in record["stems"]:
            if stem["state"] == "missing" and stem["max"]:
                count[stem["stem"]] = count.get(stem["stem"], 0) + 1
            elif stem["state"] == "judged":
                for function in stem["functions"]:
                    if function["state"] == "unanswered":
                        what = f"{stem['stem']} {function['name']}"
                        count[what] = count.get(what, 0) + 1
    order = sorted(count.items(), key=lambda pair: (-pair[1], pair[0]))
    return [f"{what} ({number})" for what, number in order[:MOST]] + [f"and {len(order) - MOST} more"] * (len(order) > MOST)
