"""What every section of a joint file is, and the entries that may differ from contact to contact."""

from __future__ import annotations

from typing import Any, Generic, TypeVar

from pydantic import BaseModel, ConfigDict

Entry = TypeVar("Entry")

#: Marks in pydantic's error locations that are no keys of the file.
ONE_FOR_ALL, ONE_FOR_EACH = "<one for all>", "<one for each>"


class Section(BaseModel):
    """A table of the file: frozen, and without room for unknown keys."""

    model_config = ConfigDict(extra="forbid", frozen=True, use_attribute_docstrings=True)


class EachContact(Section, Generic[Entry]):
    """One entry for each contact of a branch."""

    sp: Entry
    """Sun–planet."""
    pwr: Entry
    """Planet–right loading roller."""
    pwl: Entry
    """Planet–left loading roller."""
    wro: Entry
    """Right loading roller–ring."""
    wlo: Entry
    """Left loading roller–ring."""

    def entries(self) -> tuple[Entry, ...]:
        """The five entries in the order of the contact axis."""
        return (self.sp, self.pwr, self.pwl, self.wro, self.wlo)


def number_or_table(written: Any) -> str:
    """Which of the two an entry is that is a number, or a table with one for each contact."""
    return ONE_FOR_EACH if isinstance(written, dict | EachContact) else ONE_FOR_ALL


def table_or_tables(written: Any) -> str:
    """Which of the two an entry is that is a table, or a table with one for each contact."""
    tables = isinstance(written, dict) and any(isinstance(value, dict) for value in written.values())
    return ONE_FOR_EACH if tables or isinstance(written, EachContact) else ONE_FOR_ALL
