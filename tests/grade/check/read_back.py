"""read_back.py - readers of the reports' formats that share nothing with their writers.

Of HTML, and of CSV: the latter reads what RFC 4180 allows and nothing else.
"""
import html.parser
import re


def strict_csv(data: bytes) -> list:
    """RFC 4180, section 2, after a mark: CRLF ends each record; a quote only in quotes, doubled."""
    mark, text = data[:3], data[3:].decode("utf-8")
    assert mark == b"\xef\xbb\xbf" and "\ufeff" not in text  # by which Excel knows UTF-8
    rows, row, at = [], [], 0
    while at < len(text):
        quoted = re.compile(r'"((?:[^"]|"")*)"').match(text, at)
        plain = re.compile(r'[^",\r\n]*').match(text, at)
        row.append(quoted[1].replace('""', '"') if quoted else plain[0])
        at = (quoted or plain).end()
        if text.startswith("\r\n", at):
            rows.append(row)
            row, at = [], at + 2
        elif text.startswith(",", at):
            at += 1
        else:
            raise ValueError(f"no comma and no end of line at {at}: {text[at - 20:at + 20]!r}")
    assert not row
    return rows


class Page(html.parser.HTMLParser):
    """The parts of a page: its tags, attributes, URLs and words."""

    def __init__(self, text: str):
        super().__init__(convert_charrefs=True)
        self.tags, self.attributes, self.urls, self.words, self.open = [], set(), [], [], []
        self.other = []
        self.feed(text)
        self.close()

    def handle_starttag(self, name, attributes):
        self.tags.append(name)
        self.attributes |= {key for key, _ in attributes}
        self.urls += [(key, value) for key, value in attributes if key in ("href", "src")]
        if name not in ("meta", "img"):
            self.open.append(name)

    def handle_endtag(self, name):
        assert self.open.pop() == name, name

    def handle_data(self, data):
        self.words.append(data)

    def handle_comment(self, data):
        self.other.append(data)

    def handle_pi(self, data):
        self.other.append(data)

    def unknown_decl(self, data):
        self.other.append(data)
