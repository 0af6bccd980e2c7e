"""sheets.py - tables that learning platforms write, and read again: CSV or tab-separated, in UTF-8 or UTF-16.

A platform takes its own file back if only the cells that it expects have changed. So a sheet keeps every cell as it
was written, with its quotes, and the byte order mark, separator and line ends of the file; a cell that is filled is
written by the rules of RFC 4180.
"""
from __future__ import annotations

import codecs
import re
from dataclasses import dataclass
from pathlib import Path

from grade.report.formats import RUNS, cell as harmless
from grade.visible import why

LARGEST = 64 * 1024 * 1024
MARKS = [(codecs.BOM_UTF8, "utf-8"), (codecs.BOM_UTF16_LE, "utf-16-le"), (codecs.BOM_UTF16_BE, "utf-16-be")]


class SheetError(ValueError):
    """FILE:LINE: what is wrong, expected what."""


def as_meant(text: str) -> str:
    """Without the apostrophe that keeps a spreadsheet from running a cell."""
    return text[1:] if text[:1] == "'" and text[1:2] and text[1] in RUNS else text


@dataclass
class Row:
    line: int           # where it begins, from 1
    written: list       # each cell as the file has it, with its quotes
    end: str            # of the line

    def cells(self) -> list:
        return [unquoted(cell) for cell in self.written]


def unquoted(cell: str) -> str:
    return cell[1:-1].replace('""', '"') if cell[:1] == '"' and cell[-1:] == '"' and len(cell) > 1 else cell


def quoted(text: str, separator: str, always: bool) -> str:
    plain = not always and not any(sign in text for sign in (separator, '"', "\n", "\r"))
    return text if plain else '"' + text.replace('"', '""') + '"'


class Sheet:
    """rows[0] is the heading."""

    def __init__(self, path: Path, raw: bytes | None = None):
        """raw: what is in the file, or will be."""
        self.path = path
        try:
            raw = path.read_bytes() if raw is None else raw
        except OSError as error:
            raise SheetError(f"{path}: cannot be read: {why(error)}, expected a table (CSV)") from None
        if len(raw) > LARGEST:
            raise SheetError(f"{path}: more than {LARGEST >> 20} MB, expected a table (CSV)")
        self.mark, self.coding = next(((mark, coding) for mark, coding in MARKS if raw.startswith(mark)), (b"", "utf-8"))
        try:
            text = raw[len(self.mark):].decode(self.coding)
        except UnicodeError:
            raise SheetError(f"{path}: not text in UTF-8 or UTF-16, expected a table (CSV); "
                             "a spreadsheet saves one as 'CSV UTF-8'") from None
        first = text.split("\n", 1)[0]
        self.separator = max(",\t;", key=first.count)
        self.rows = list(self._rows(text))
        if not self.rows:
            raise SheetError(f"{path}:1: empty, expected a table (CSV)")
        self.quotes_all = all(cell.startswith('"') for cell in self.rows[0].written)

    def _rows(self, text: str):
        """RFC 4180, and a last line without an end."""
        cell = re.compile(rf'("(?:[^"]|"")*"|[^{self.separator}"\r\n][^{self.separator}\r\n]*|)({self.separator}|\r\n|\n|\r|\Z)')
        at, line, written, begins = 0, 1, [], 1
        while at < len(text) or written:
            match = cell.match(text, at)
            if match is None:
                raise SheetError(f"{self.path}:{line}: a quotation mark that does not end its cell, expected \"...\" with "
                                 "quotes inside doubled")
            written.append(match[1])
            line += match[1].count("\n")
            at = match.end()
            if match[2] == self.separator:
                continue
            if written != [""]:
                yield Row(begins, written, match[2])
            line, written = line + 1, []
            begins = line

    def heading(self) -> list:
        return [cell.strip() for cell in self.rows[0].cells()]

    def column(self, *names: str) -> int | None:
        """Of the first of these names that there is, whatever its capitals."""
        heads = [head.casefold() for head in self.heading()]
        return next((heads.index(name.casefold()) for name in names if name.casefold() in heads), None)

    def cell(self, row: Row, column: int | None) -> str:
        return "" if column is None or column >= len(row.written) else unquoted(row.written[column]).strip()

    def fill(self, row: Row, column: int, text: str) -> None:
        row.written += [""] * (column + 1 - len(row.written))
        was_quoted = row.written[column].startswith('"') or self.quotes_all
        row.written[column] = quoted(harmless(text), self.separator, was_quoted)

    def add(self, cells: list) -> None:
        """A row at the end."""
        end = self.rows[0].end or "\n"
        self.rows[-1].end = self.rows[-1].end or end
        line = self.rows[-1].line + 1 + sum(cell.count("\n") for cell in self.rows[-1].written)
        self.rows.append(Row(line, [quoted(harmless(text), self.separator, self.quotes_all) for text in cells], end))

    def bytes(self) -> bytes:
        text = "".join(self.separator.join(row.written) + row.end for row in self.rows)
        return self.mark + text.encode(self.coding)

