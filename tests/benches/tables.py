"""tables.py - the numbers of the benches: a Markdown table of their means, and the figure of chapter 08.

Usage: tables.py FOLDER [PAGE.md], or tables.py -f FOLDER

Reads ratios.csv and shaded-pictures.csv of the folder, each if it is there, and prints one table: how many times as
fast this program is as each other ray tracer. With a page it prints the page instead, with the table in place of the
page's table that has the same first cell. With -f it prints the data of the figure (flat.gp), from rays-per-second.csv:
rays a second by one thread.
"""
import csv
import math
import re
import sys
from pathlib import Path

PEERS = {"Embree, its spheres": ("embree-8", "embree-16"), "Embree, 16-lane callback": ("embree-user",), "POV-Ray": ("povray",)}
FIRST = "| this program, times as fast as |"


def rows_of(folder, name):
    path = Path(folder, name)
    return list(csv.DictReader(path.open())) if path.exists() else []


def three_digits(number):
    """1094, 48.9, 0.0102; nothing for 0."""
    return f"{number:.{max(0, 2 - math.floor(math.log10(number) + 1e-9))}f}" if number > 0 else ""


def mean_over_scenes(rows, peers):
    """The geometric mean; of two ways to use a peer, each scene has the faster one. 0 if nothing was measured."""
    times = {}
    for row in rows:
        if (row.get("peer") or row.get("renderer")) in peers and float(row["times"]) > 0:
            times[row["scene"]] = min(float(row["times"]), times.get(row["scene"], math.inf))
    return math.exp(sum(map(math.log, times.values())) / len(times)) if times else 0


def counted(number, what):
    return f"{number} {what}{'' if number == '1' else 's'}"


def table(ratios, shaded):
    groups = {}
    for row in ratios:
        if row["engine"] == "bins":
            groups.setdefault(f"flat, {counted(row['threads'], 'thread')}", []).append(row)
    for row in shaded:
        groups.setdefault(f"shaded, {counted(row['samples'], 'sample')}, {counted(row['threads'], 'thread')}", []).append(row)
    head = f"{FIRST} {' | '.join(PEERS)} |\n|---|{'---:|' * len(PEERS)}\n"
    return head + "".join(f"| {name} | {' | '.join(three_digits(mean_over_scenes(rows, peers)) for peers in PEERS.values())} |\n"
                          for name, rows in sorted(groups.items()))


def figure_data(rows):
    """For each engine two blocks of data: the scenes with random spheres, and the others."""
    engines = list(dict.fromkeys(row["engine"] for row in rows))
    print(f'threads = 1\nengines = "{" ".join(engines)}"')
    for number, engine in enumerate(engines, 1):
        for random in (False, True):
            print(f"$engine{number}_{int(random)} << END")
            for row in rows:
                if row["engine"] == engine and row["threads"] == "1" and row["scene"].startswith("random") == random:
                    print(row["spheres"], row["rays_per_second"], row["lower_quartile"], row["upper_quartile"])
            print("END")


def page_with(path, new):
    page = Path(path).read_text()
    old = re.compile(rf"(?<=\n\n){re.escape(FIRST)}.*\n(?:\|.*\n)*")
    if not old.search(page):
        sys.exit(f"tables: {path} has no table that begins with {FIRST}")
    return old.sub(lambda _: new, page, count=1)


def main(arguments):
    draws = arguments[:1] == ["-f"]
    arguments = arguments[draws:]
    if len(arguments) not in ((1,) if draws else (1, 2)):
        sys.exit(__doc__)
    if draws:
        speeds = rows_of(arguments[0], "rays-per-second.csv")
        if not speeds:
            sys.exit(f"tables: {arguments[0]}: rays-per-second.csv has no numbers")
        figure_data(speeds)
        return
    ratios, shaded = rows_of(arguments[0], "ratios.csv"), rows_of(arguments[0], "shaded-pictures.csv")
    if len(arguments) == 2 and not ratios:
        sys.exit(f"tables: {arguments[0]}: ratios.csv has no numbers")
    new = table(ratios, shaded)
    print(page_with(arguments[1], new) if len(arguments) == 2 else new, end="")


main(sys.argv[1:])
