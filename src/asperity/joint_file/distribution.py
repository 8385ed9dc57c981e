"""How a number scatters within its tolerance: what may follow a tolerance in a joint file."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal

from asperity.errors import InputError

#: What can be written after the comma of a tolerance.
FORMS = "'uniform', 'triangular' or 'normal K sigma' (e.g. 'normal 2 sigma': the tolerance is two standard deviations)"
_MOST_SIGMAS = 10.0


@dataclass(frozen=True, slots=True)
class Distribution:
    """A symmetric distribution about a stated value v with a tolerance t.

    Parameters
    ----------
    kind : {"uniform", "triangular", "normal"}
        Uniform or triangular between v − t and v + t, or normal.
    sigmas : float
        For ``normal``: how many standard deviations make t. 0 for the others.
    """

    kind: Literal["uniform", "triangular", "normal"]
    sigmas: float

    def __str__(self) -> str:
        return f"normal {self.sigmas:g} sigma" if self.kind == "normal" else self.kind

    def standard_deviation(self, tolerance: float) -> float:
        """Standard deviation of a number with this tolerance."""
        shrink = {"uniform": 3.0**0.5, "triangular": 6.0**0.5, "normal": self.sigmas}[self.kind]
        return tolerance / shrink


def parse_distribution(text: str) -> Distribution:
    """Read a distribution.

    Parameters
    ----------
    text : str
        ``uniform``, ``triangular`` or ``normal K sigma``.

    Returns
    -------
    Distribution
        The distribution.

    Raises
    ------
    InputError
        If the text has another form.

    Examples
    --------
    >>> parse_distribution("normal 2 sigma")
    Distribution(kind='normal', sigmas=2.0)
    """
    words = " ".join(text.lower().split())
    if words == "uniform":
        return Distribution("uniform", 0.0)
    if words == "triangular":
        return Distribution("triangular", 0.0)
    match = re.fullmatch(r"normal (\d+(?:\.\d*)?|\.\d+) ?(?:sigmas?|σ)", words)
    if match is None:
        raise InputError(f"a tolerance can be distributed as {FORMS}, got '{text}'")
    sigmas = float(match[1])
    if not 0.0 < sigmas <= _MOST_SIGMAS:
        raise InputError(
            f"a tolerance is above 0 and at most {_MOST_SIGMAS:g} standard deviations, got '{text}'"
        )
    return Distribution("normal", sigmas)


def split_distribution(written: str) -> tuple[str, Distribution | None]:
    """Split the text of a tolerance from the distribution behind its comma."""
    text, comma, tail = written.rpartition(",")
    signs = ("±", "+-", "+/-", "+ -", "+ /")
    if not comma or not any(sign in text for sign in signs) or re.match(r"\s*\d", tail):
        return written, None
    return text, parse_distribution(tail)
