"""pages.py - reads the text of a PDF of slides, as pdftohtml -xml prints it, and tells what it found.

    pdftohtml -xml -i -zoom 10 -stdout slides.pdf | pages.py QUESTION

    titles     the largest text of each page, once for pages in a row that have the same
    exercises  the text that names the exercise, likewise
    small      each text below 18 of 540 units of a page's height that is no index, with its page and its size
    notes      each page that has no text in its right half
    places     of each page the number of its slide, as its lower edge has it: '3 of 31'

Text outside the page, which Beamer puts there until its step comes, does not count.
"""
import re
import sys


def attributes(line):
    return {name: float(number) for name, number in re.findall(r' (\w+)="(-?\d+(?:\.\d+)?)"', line)}


def pages(lines):
    """Of each page its attributes, and its texts: attributes, size, words."""
    sizes, page, texts = {}, None, []
    for line in lines:
        has = attributes(line)
        if line.startswith("<page "):
            page, texts = has, []
        elif "<fontspec " in line:
            sizes[has["id"]] = int(has["size"])
        elif line.startswith("<text "):
            words = re.sub("<[^>]*>", "", line.rstrip("\n"))
            if words.strip(" ") and 0 <= has["left"] < page["width"] and 0 <= has["top"] < page["height"]:
                texts.append((has, sizes[has["font"]], words))
        elif line.startswith("</page>"):
            yield page, texts


def main(question):
    said, last = "no page", ""
    for page, texts in pages(sys.stdin):
        said = None
        number, height = int(page["number"]), page["height"]
        if question == "small":
            # pdftohtml cuts the digits off.
            for _, size, words in texts:
                if size < int(18 * height / 540) and len(words.strip()) > 2:
                    print(f"page {number}: {size * 540 / height:.1f} units: {words}")
        elif question == "places":
            print(*[found for _, _, words in texts for found in re.findall(r"(?<!\d)(\d\d? of \d\d)$", words)][:1] or ["none"])
        elif question == "notes":
            if not any(has["left"] > page["width"] / 2 for has, _, _ in texts):
                print(f"page {number}")
        else:
            largest = max((size for _, size, _ in texts), default=0)
            found = {"titles": [words for _, size, words in texts if size == largest][:1] or [""],
                     "exercises": [words for _, _, words in texts if words.startswith("Exercise ")][-1:]}[question]
            if found and found[0] != last:
                last = found[0]
                print(last)
    return said


sys.exit(main(sys.argv[1]))
