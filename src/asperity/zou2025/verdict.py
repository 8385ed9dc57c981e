"""A claim of the paper and the verdict on it."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any


@dataclass(frozen=True)
class Statement:
    """One statement of a claim, compared with computed numbers.

    Parameters
    ----------
    says : str
        What the paper says, in our words.
    met : bool
        Whether the equations confirm it.
    evidence : str
        The computed numbers in a sentence, with units.
    numbers : dict
        The same numbers for programs: name with unit → value.
    """

    says: str
    met: bool
    evidence: str
    numbers: dict[str, float]


@dataclass(frozen=True)
class Claim:
    """A claim of the paper; it is met if every one of its statements is met.

    Parameters
    ----------
    name : str
        C1 … C13, or ``window``.
    title : str
        Summary of the claim.
    panels : tuple of str
        Panels of the figures that show it.
    statements : tuple of Statement
        Its statements with their verdicts.
    """

    name: str
    title: str
    panels: tuple[str, ...]
    statements: tuple[Statement, ...]

    @property
    def met(self) -> bool:
        """True if every statement is met."""
        return all(statement.met for statement in self.statements)

    def as_dict(self) -> dict[str, Any]:
        """The claim with its verdict as plain data for JSON.

        Returns
        -------
        dict
            ``name``, ``title``, ``panels``, ``met`` and ``statements``.
        """
        return {
            "name": self.name,
            "title": self.title,
            "panels": list(self.panels),
            "met": self.met,
            "statements": [asdict(statement) for statement in self.statements],
        }
