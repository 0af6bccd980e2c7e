"""tables.py - the numbers of the benches: CSV files become Markdown tables, and the figure of chapter 08.

Usage: tables.py FOLDER [LESSON.md], or tables.py -f FOLDER

Reads rays-per-second.csv, ratios.csv and shaded-pictures.csv of the folder, each if it is there, and prints their
tables. With a lesson it prints the lesson instead, with each table in place of the lesson's table that has the same
first cell. With -f it prints the data of the figure (flat.gp): rays a second by one thread.
"""
import csv
import math
import re
import sys
from pathlib import Path

TITLES = {"embree-8": "Embree, its spheres", "embree-16": "Embree, its spheres",
          "embree-user": "Embree, 16-lane callback", "povray": "POV-Ray"}
LANES = {"embree-8": ", 8 rays at a time", "embree-16": ", 16 rays at a time"}
MANY_SPHERES = 50000  # with fewer, the time to build a hierarchy does not show


def rows_of(folder, name):
    path = Path(folder, name)
    return list(csv.DictReader(path.open())) if path.exists() else []


def values(rows, field):
    """Each value of a field once, in the order in which they come."""
    return list(dict.fromkeys(row[field] for row in rows))


def three_digits(number):
    """1094, 48.9, 0.0102; nothing for 0."""
    return f"{number:.{max(0, 2 - math.floor(math.log10(number) + 1e-9))}f}" if number > 0 else ""


def with_range(times, low, high, rounds):
    return three_digits(times) + (f" ({three_digits(low)} to {three_digits(high)})" if rounds > 1 else "")


def mean(numbers):
    """The geometric mean of those that are positive."""
    logs = [math.log(number) for number in numbers if number > 0]
    return math.exp(sum(logs) / len(logs)) if logs else 0


def table(first, head, rows):
    lines = [[first, *head], ["---", *["---:"] * len(head)], *rows]
    return "".join(("|" + "|".join(line) + "|" if line is lines[1] else "| " + " | ".join(line) + " |") + "\n" for line in lines)


def threads_row(what, threads, cells):
    return [f"**{what}, {threads} thread{'' if threads == '1' else 's'}**", *map(three_digits, cells)]


def engine_tables(rows):
    scenes, threads = values(rows, "scene"), values(rows, "threads")
    columns = list(dict.fromkeys(TITLES.get(engine, f"`{engine}`") for engine in values(rows, "engine")))

    def best(scene, column, count):
        """Embree's two kinds of packets are one column: the faster one."""
        same = [row for row in rows if row["scene"] == scene and row["threads"] == count
                and TITLES.get(row["engine"], f"`{row['engine']}`") == column]
        return max(same, key=lambda row: float(row["rays_per_second"]), default=None)

    def cell(row, field):
        return float(row[field]) if row else 0

    speeds = [[scene, *(three_digits(1e-6 * cell(best(scene, column, threads[0]), "rays_per_second")) for column in columns)]
              for scene in scenes]
    speeds += [threads_row("times Embree", count, [mean(cell(best(scene, column, count), "ratio") for scene in scenes)
                                                   for column in columns]) for count in threads]
    # A slow engine cast a smaller picture, so its time says nothing here.
    widest = max(int(row["width"]) for row in rows)
    firsts = []
    for scene in (row["scene"] for row in {row["scene"]: row for row in rows}.values() if int(row["spheres"]) >= MANY_SPHERES):
        found = [best(scene, column, threads[0]) for column in columns]
        firsts.append([scene, *(three_digits(cell(row, "first_frame_ms")) if row and int(row["width"]) == widest else ""
                                for row in found)])
    yield table("millions of rays a second", columns, speeds)
    yield table("milliseconds to the first picture", columns, firsts)


def ratio_table(rows):
    """`bins` beside each peer: the median of the ratios, and their quartiles."""
    rows = [row for row in rows if row["engine"] == "bins"]
    peers, threads = values(rows, "peer"), values(rows, "threads")
    found = {(row["scene"], row["threads"], row["peer"]): row for row in rows}
    lines = []
    for scene in values(rows, "scene"):
        cells = [found.get((scene, threads[0], peer)) for peer in peers]
        lines.append([scene, *(with_range(float(row["times"]), float(row["lower_quartile"]), float(row["upper_quartile"]),
                                          int(row["rounds"])) if row else "" for row in cells)])
    lines += [threads_row("mean", count, [mean(float(row["times"]) for row in rows
                                               if row["threads"] == count and row["peer"] == peer) for peer in peers])
              for count in threads]
    yield table("`bins`, times as fast as", [TITLES[peer] + LANES.get(peer, "") for peer in peers], lines)


def shaded_table(rows):
    renderers, samples, threads = values(rows, "renderer"), values(rows, "samples"), values(rows, "threads")
    found = {(row["scene"], row["renderer"], row["samples"], row["threads"]): row for row in rows}
    head, lines = [], []
    for number in samples:
        head.append(f"{number} sample{'' if number == '1' else 's'}")
        head += [f"{TITLES[peer].split(',')[0]}, times" for peer in renderers[1:]]
    for scene in values(rows, "scene"):
        cells = []
        for number in samples:
            for peer in renderers:
                row = found.get((scene, peer, number, threads[0]))
                if row is None:
                    cells.append("")
                elif peer == renderers[0]:
                    cells.append(three_digits(float(row["ms"])))
                else:
                    cells.append(with_range(float(row["times"]), float(row["least"]), float(row["most"]), int(row["rounds"])))
        lines.append([scene, *cells])
    lines += [threads_row("mean", count, [0 if peer == renderers[0] else
                                          mean(float(row["times"]) for row in rows if row["renderer"] == peer
                                               and row["samples"] == number and row["threads"] == count)
                                          for number in samples for peer in renderers]) for count in threads]
    yield table("milliseconds for a shaded picture", head, lines)


def figure_data(rows):
    """For each engine two blocks of data: the scenes with random spheres, and the others."""
    engines = values(rows, "engine")
    print(f'threads = 1\nengines = "{" ".join(engines)}"')
    for number, engine in enumerate(engines, 1):
        for random in (False, True):
            print(f"$engine{number}_{int(random)} << END")
            for row in rows:
                if row["engine"] == engine and row["threads"] == "1" and row["scene"].startswith("random") == random:
                    print(row["spheres"], row["rays_per_second"], row["lower_quartile"], row["upper_quartile"])
            print("END")


def lesson_with(path, tables):
    lesson = Path(path).read_text()
    for new in tables:
        first = new[:new.index("|", 1) + 1]
        old = re.compile(rf"(?:(?<=\n\n){re.escape(first)}.*\n(?:\|.*\n)*)")
        if not old.search(lesson):
            sys.exit(f"tables: {path} has no table that begins with {first}")
        lesson = old.sub(lambda _: new, lesson, count=1)
    return lesson


def main(arguments):
    draws = arguments[:1] == ["-f"]
    arguments = arguments[draws:]
    if len(arguments) not in ((1,) if draws else (1, 2)):
        sys.exit(__doc__)
    speeds = rows_of(arguments[0], "rays-per-second.csv")
    if (draws or len(arguments) == 2) and not speeds:
        sys.exit(f"tables: {arguments[0]}: rays-per-second.csv has no numbers")
    if draws:
        figure_data(speeds)
        return
    ratios, shaded = rows_of(arguments[0], "ratios.csv"), rows_of(arguments[0], "shaded-pictures.csv")
    tables = [*(engine_tables(speeds) if speeds else ()), *(ratio_table(ratios) if ratios else ()),
              *(shaded_table(shaded) if shaded else ())]
    print(lesson_with(arguments[1], tables) if len(arguments) == 2 else "\n".join(tables), end="" if len(arguments) == 2 else "\n")


main(sys.argv[1:])
