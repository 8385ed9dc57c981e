"""The errors that asperity raises on purpose.

Each carries one complete sentence for the user: the offending value, the allowed range, what to do. The
command line prints that sentence and exits with :attr:`AsperityError.exit_code`; nothing else is printed.
"""

import itertools
from collections.abc import Iterable, Sequence
from contextvars import ContextVar

LONGEST_QUOTE = 80
#: Errors of one file that are told; the others are counted.
MOST_ERRORS = 20
#: Names whose likeness to a given one, 0 to 1, is less below that of the best one are told beside it.
_AS_ALIKE = 0.05
#: Known names that are compared with a mistyped one.
_MOST_KNOWN = 1000
_LONGEST_SENTENCE = 1000

#: What runs, in words, where the command line has set it; messages name it.
RUNNING: ContextVar[str] = ContextVar("RUNNING", default="this function")


def printable(text: str) -> str:
    r"""Text in which every character that a terminal could obey is written as its escape sequence, safe to print.

    Control characters (also those of C1), marks that change the direction of writing, invisible characters and lone
    surrogates become ``\x1b``, ``\u202e`` and the like. A line break stays where two spaces follow it, which is how
    messages list several errors.

    Examples
    --------
    >>> print(printable("red \x1b[31m\n  second line"))
    red \x1b[31m
      second line
    """
    if text.isprintable():
        return text
    lines = text.split("\n  ")
    return "\n  ".join("".join(map(_escaped, line)) for line in lines)


def one_line(text: str) -> str:
    r"""The same in one line, such as the name of a file: every document can hold it, and text in UTF-8 or XML, too.

    Examples
    --------
    >>> print(one_line("shaft\n  \udcfc.toml"))
    shaft\n  \udcfc.toml
    """
    return "".join(map(_escaped, text))


def _escaped(letter: str) -> str:
    return letter if letter.isprintable() else letter.encode("unicode_escape").decode("ascii")


def quoted(value: object) -> str:
    """A value of a file as a message quotes it: text in quotes, of at most :data:`LONGEST_QUOTE` characters."""
    try:
        text = repr(value)
    except RecursionError:
        return "a deeply nested value"
    return text if len(text) <= LONGEST_QUOTE else f"{text[:LONGEST_QUOTE]}…"


def closest(name: str, known: Iterable[str]) -> str | None:
    """The known name most like the given one, if any is alike."""
    import difflib

    close = difflib.get_close_matches(name[:200], list(known), n=3, cutoff=0.5)
    # letters in the wrong order are the likeliest typing error
    return min(close, key=lambda other: sorted(other) != sorted(name), default=None)


def nearest(name: str, known: Iterable[str]) -> str:
    """``"; did you mean 'x' or 'y'?"`` for the known names most like the given one, or nothing."""
    import difflib

    names = list(itertools.islice(known, _MOST_KNOWN))
    best = closest(name, names)
    if best is None:
        return ""
    if sorted(best) == sorted(name):  # letters in the wrong order leave no doubt
        return f"; did you mean '{best}'?"
    given = name[:200]
    alike = difflib.SequenceMatcher(b=given, a=best).ratio() - _AS_ALIKE
    others = difflib.get_close_matches(given, names, n=3, cutoff=max(alike, 0.5))
    told = " or ".join(f"'{other}'" for other in dict.fromkeys([best, *others]))
    return f"; did you mean {told}?"


def listed(sentences: Sequence[str], *, more: int = 0) -> str:
    """Errors of one file, at least one, as one text: the sentence, or the number of errors and the first ones.

    They are the first :data:`MOST_ERRORS`, on a line each; a sentence is shortened if it is long, as the name of a key
    may be as long as the file. ``more`` is the number of errors besides these.
    """
    told = [_shortened(sentence) for sentence in sentences[:MOST_ERRORS]]
    count = len(sentences) + more
    if count == 1:
        return told[0]
    left = count - len(told)
    lines = "".join(f"\n  {sentence}" for sentence in told)
    return f"{count} errors{lines}" + (f"\n  and {left} more" if left else "")


def _shortened(sentence: str) -> str:
    if len(sentence) <= _LONGEST_SENTENCE:
        return sentence
    half = _LONGEST_SENTENCE // 2
    return f"{sentence[:half]}…{sentence[-half:]}"


class AsperityError(Exception):
    """Base of every error that asperity raises on purpose; its message is :func:`printable`.

    The message says what is wrong, and what to do, in words that also fit a call from Python; ``options`` of the
    command line do it, without their dashes, and only the command line names them.
    """

    exit_code = 1

    def __init__(self, message: str = "", *, options: Sequence[str] = ()) -> None:
        super().__init__(printable(message))
        self.options = tuple(options)

    def _render_traceback_(self) -> list[str]:
        """What a notebook shows: the message, which says all that a user needs, instead of a traceback."""
        return [f"{type(self).__name__}: {self}"]


class InputError(AsperityError, ValueError):
    """The input is wrong: a value, a unit, a key, a file. Exit code 2."""

    exit_code = 2


class NoSolutionError(AsperityError, RuntimeError):
    """The input is well formed but has no solution, or the solver did not converge. Exit code 3."""

    exit_code = 3


class PrecisionError(AsperityError, RuntimeError):
    """JAX runs in single precision, which the contact law cannot tolerate. Exit code 2."""

    exit_code = 2


class MissingExtraError(AsperityError, ImportError):
    """An optional dependency is needed for this operation and is not installed. Exit code 2."""

    exit_code = 2
