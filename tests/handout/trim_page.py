"""trim_page.py - a page for readers who have less than its writer: a paragraph, an item of a list or a row of a table
is left out if it links to a file that does not exist.

    trim_page.py FOLDER PAGE      prints it; FOLDER: where the page's links begin
"""
import re
import sys
from pathlib import Path


def links_to_nothing(text, folder):
    """[words](link): the part of the link before '#'."""
    return any(link and not link.startswith(("http:", "https:")) and not (folder / link).exists()
               for link in re.findall(r"\]\(([^)#]*)", text))


def trimmed(page, folder):
    kept, paragraph, left_out = [], "", False

    def end():
        nonlocal paragraph, left_out
        if paragraph:
            left_out = links_to_nothing(paragraph, folder)
            kept.extend([] if left_out else [paragraph])
            paragraph = ""

    for line in page.splitlines(keepends=True):
        is_empty, is_row = line == "\n", line.startswith("|")
        if is_empty or is_row or line.startswith("- "):
            end()
        paragraph += "" if is_empty else line
        if is_row:
            end()
        # Of the empty lines around what is left out, one.
        if is_empty and not left_out:
            kept.append(line)
        if is_empty or is_row:
            left_out = False
    end()
    return "".join(kept)


sys.stdout.write(trimmed(Path(sys.argv[2]).read_text(encoding="utf-8"), Path(sys.argv[1])))
