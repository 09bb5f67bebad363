"""Tables of texts, for a terminal and for a notebook."""

from __future__ import annotations

from html import escape
from typing import NamedTuple, Sequence


class Table(NamedTuple):
    """Rows of texts below a head, and notes below these."""

    head: Sequence[str]
    rows: Sequence[Sequence[str]]
    notes: Sequence[str] = ()

    @property
    def text(self) -> str:
        """In columns."""
        lines = [self.head, *self.rows]
        widths = [max(len(line[k]) for line in lines) for k in range(len(self.head))]
        columns = ["  ".join(cell.ljust(width) for cell, width in zip(line, widths)).rstrip() for line in lines]
        return "\n".join([*columns, *self.notes])

    @property
    def html(self) -> str:
        """As a table, with paragraphs for the notes."""
        head = "".join(_cell("th", cell) for cell in self.head)
        rows = "".join(f"<tr>{_cell('th', row[0])}{''.join(_cell('td', cell) for cell in row[1:])}</tr>" for row in self.rows)
        notes = "".join(f"<p>{escape(note)}</p>" for note in self.notes)
        return f"<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>{notes}"


def _cell(tag: str, text: str) -> str:
    return f'<{tag} style="text-align:left">{escape(text)}</{tag}>'  # notebooks set it right otherwise
