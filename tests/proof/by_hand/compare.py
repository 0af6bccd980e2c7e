#!/usr/bin/env python3
"""compare.py - the differences between two records (record.py), in words. Exit status 1 if there are any.

    compare.py BEFORE AFTER [PART...] [--most N]

--most: show so many differences of a part (20), and count the others.
"""
import argparse
import difflib
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "house/figures"))
sys.dont_write_bytecode = True
import png  # noqa: E402 - found from there on


def entries(folder):
    """key -> text. Keys that occur again are numbered."""
    found = {}
    for entry in ("\n" + (folder / "entries.txt").read_text(encoding="utf-8")).split("\n== ")[1:]:
        key, _, text = entry.partition("\n")
        number = 1
        while (key if number == 1 else f"{key} ({number})") in found:
            number += 1
        found[key if number == 1 else f"{key} ({number})"] = text
    return found


def text_difference(before, after):
    old, new = before.splitlines(), after.splitlines()
    lines = [line for line in difflib.unified_diff(old, new, lineterm="", n=0) if not line.startswith(("---", "+++", "@@"))]
    return "differs\n" + "\n".join(f"    {line[:400]}" for line in lines[:12]) + (
        f"\n    and {len(lines) - 12} more lines" if len(lines) > 12 else "")


def picture_difference(before, after):
    """None if every pixel is the same."""
    (size, old), (other, new) = png.read(before.read_bytes(), before), png.read(after.read_bytes(), after)
    if size != other:
        return f"has {other[0]} x {other[1]} pixels, had {size[0]} x {size[1]}"
    if old == new:
        return None
    by = png.apart(old, new)
    places = [divmod(at, size[0]) for at in range(len(by)) if by[at]]
    columns = [column for _, column in places]
    return (f"{len(places)} of {len(by)} pixels differ, by at most {max(by)} of 255, "
            f"in columns {min(columns)} to {max(columns)} and rows {places[0][0]} to {places[-1][0]}")


def differences(before, after):
    """The number of equal things, and a list of (key, words)."""
    old, new = entries(before), entries(after)
    old.update({path.name: path for path in before.glob("*.png")})
    new.update({path.name: path for path in after.glob("*.png")})
    same, found = 0, []
    for key in sorted(old.keys() | new.keys()):
        if key not in new:
            found.append((key, "is only in the first record"))
        elif key not in old:
            found.append((key, "is only in the second record"))
        elif isinstance(old[key], Path):
            words = picture_difference(old[key], new[key])
            found += [(key, words)] if words else []
        elif old[key] != new[key]:
            found.append((key, text_difference(old[key], new[key])))
        same += key in old and key in new and (not found or found[-1][0] != key)
    return same, found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("before", type=Path)
    parser.add_argument("after", type=Path)
    parser.add_argument("parts", nargs="*")
    parser.add_argument("--most", type=int, default=20)
    args = parser.parse_args()
    there = [{path.parent.name for path in folder.glob("*/entries.txt")} for folder in (args.before, args.after)]
    parts = args.parts or sorted(there[0] | there[1])
    total = 0
    for part in parts:
        if not all(part in names for names in there):
            print(f"{part}: not in both records")
            total += bool(args.parts)
            continue
        same, found = differences(args.before / part, args.after / part)
        print(f"{part}: {same} the same, {len(found)} different")
        for key, words in found[:args.most]:
            print(f"  {key}: {words}")
        if len(found) > args.most:
            print(f"  and {len(found) - args.most} more (--most {len(found)})")
        total += len(found)
    return 1 if total else 0


if __name__ == "__main__":
    sys.exit(main())
