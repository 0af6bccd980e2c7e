"""latex_picture.py - makes gnuplot's LaTeX picture one that any document can take in."""
import re

# Letters that LaTeX does not know, wherever they are.
LETTERS = {
    "−": "-", "½": "1/2", "¼": "1/4", "⅓": "1/3", "·": r"\cdot{}", "×": r"\times{}", "±": r"\pm{}",
    "⁻": "^-", "⁰": "^0", "¹": "^1", "²": "^2", "³": "^3", **{"⁴⁵⁶⁷⁸⁹"[i]: f"^{i + 4}" for i in range(6)}, "₀": "_0", "₁": "_1", "₂": "_2", "′": r"^\prime", "°": r"^\circ", "√": r"\surd{}",
    "…": r"\ldots{}", "∞": r"\infty{}", "≤": r"\le{}", "≥": r"\ge{}", "≠": r"\ne{}", "≈": r"\approx{}",
    "∈": r"\in{}", "⟂": r"\perp{}", "•": r"\bullet{}", "→": r"\to{}", "←": r"\leftarrow{}", "↑": r"\uparrow{}",
    "↓": r"\downarrow{}", "⇒": r"\Rightarrow{}", "Δ": r"\Delta{}", "α": r"\alpha{}", "β": r"\beta{}",
    "θ": r"\theta{}", "λ": r"\lambda{}", "π": r"\pi{}", "φ": r"\varphi{}",
}


class Misplaced(Exception):
    """gnuplot takes a label that begins with a brace or a bracket for one that says where it is."""


def known(text):
    return "".join(rf"\ensuremath{{{LETTERS[letter]}}}" if letter in LETTERS else letter for letter in text)


# Outside mathematics, gnuplot's own marks: x_1, x^2, x_{12}, {/:Italic x}, {/'DejaVu Serif':Bold x}, {/*0.8 small}.
MARKS = re.compile(r"""(?P<latex>\\.)                             # \small, \%: that is LaTeX already
    | (?P<name>(?<=[A-Za-z]{2})_(?=[A-Za-z]{2}))                  # of a name, as in upper_left
    | (?P<shift>[_^])(?P<part>\{[^}]*\}|.?)
    | \{(?P<font>/(?:'[^']*')?[^ ]*[ ])
    | (?P<letter>.)""", re.VERBOSE | re.DOTALL)


def mark(found):
    letter = found["letter"]
    if found["latex"]:
        return found["latex"]
    if found["name"]:
        return r"\_"
    if found["shift"]:
        return rf"\text{'sub' if found['shift'] == '_' else 'super'}script{{{known(found['part'])}}}"
    if found["font"]:
        font = found["font"]
        size = r"\small " if "*0" in font else r"\large " if "*" in font else ""
        return "{" + (r"\itshape " if "Italic" in font else "") + (r"\bfseries " if "Bold" in font else "") + size
    if letter in "%&#":
        return "\\" + letter
    if letter in "<>|":
        return rf"\ensuremath{{{letter}}}"
    return r"\~{}" if letter == "~" else known(letter)


def mathematics(text):
    """Factors are apart: LaTeX would set d f like the name of one thing. Spaces at its ends are spaces."""
    inside = re.sub(r"(?<=[A-Za-z0-9)]) (?=[A-Za-z(])", r"\\,", text.strip(" ")).replace("%", r"\%")
    before, after = (r"\ " if space else "" for space in (text.startswith(" "), text.rstrip(" ") != text))
    return f"${before}{known(inside)}{after}$"


# Not of a name, a mark of gnuplot's or an exponent: 12,345.6, (1, −2, 0.5).
NUMBER = r"−?\d+(?:[.,]\d+)*"
NUMBERS = re.compile(rf"(?<![\w.*^{{]){NUMBER}|\({NUMBER}(?:, {NUMBER})+\)")


def number(found):
    """In the font of formulas. A comma before a space separates; another one is part of a number."""
    return "$" + re.sub(r",(?! )", "{,}", found[0]) + "$"


def label(text):
    """Text, and mathematics between two $. Of two spaces LaTeX would leave one. A number's sign is a minus."""
    parts = re.sub(r"(?<![\w.)])-(?=[\d.])", "−", text).split("$")
    parts[::2] = [MARKS.sub(mark, NUMBERS.sub(number, part)).replace("  ", "~ ") for part in parts[::2]]
    parts[1::2] = [mathematics(part) for part in parts[1::2]]
    return "".join(parts)


def line_of(line, graphics):
    box = re.search(r"makebox\(([\d.]+),([\d.]+)\)", line)
    put = line.find(r"\put(")
    strut = line.rfind(r"\strut{}", put) if put >= 0 else -1
    if line.startswith("% GNUPLOT"):
        return "% Drawn by gnuplot. Needs the packages graphicx and color; if it is not in the folder of the document,\n" \
               r"% \graphicspath must also name its folder."
    if "colorbox{gpBackground}" in line and box:
        # Not larger than the picture.
        return r"    \put(0,0){\color{gpBackground}\rule{%.2f\unitlength}{%.2f\unitlength}}%%" % tuple(map(float, box.groups()))
    if r"\includegraphics[" in line and re.search(r"\{[^{}]*\}\}%$", line):
        return line[:line.rindex("{")] + f"{{{graphics}}}}}%"
    if strut >= 0:
        begin, after = strut + len(r"\strut{}"), "}}}%" if "rotatebox" in line[:strut] else "}}%"
        return line[:begin] + label(line[begin:len(line) - len(after)]) + after
    if line.lstrip(" ").startswith(r"\put(") and r"\makebox(0,0)" in line:
        raise Misplaced(f"a label of LaTeX begins with {{ or [, and would be misplaced: {line}")
    return line


def latex_picture(drawn, words, graphics):
    """The picture that gnuplot has drawn: first the figure in words, as comments; labels as LaTeX writes them; a
    background that is not larger than the picture; and the name of the graphics without a folder."""
    comments = [f"% {line}".rstrip(" ") for line in words.split("\n")[:-1]]
    return "\n".join(comments + [line_of(line, graphics) for line in drawn.rstrip("\n").split("\n")]) + "\n"
