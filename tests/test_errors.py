"""Exit codes and Python's own families of the errors, as documented."""

import pytest

from asperity.errors import (
    AsperityError,
    InputError,
    MissingExtraError,
    NoSolutionError,
    PrecisionError,
    printable,
    quoted,
)


@pytest.mark.parametrize(
    ("kind", "code", "family"),
    [
        (AsperityError, 1, Exception),
        (InputError, 2, ValueError),
        (NoSolutionError, 3, RuntimeError),
        (PrecisionError, 2, RuntimeError),
        (MissingExtraError, 2, ImportError),
    ],
)
def test_who_catches_the_family_catches_the_error(kind, code, family):
    assert issubclass(kind, AsperityError)
    assert kind.exit_code == code
    with pytest.raises(family, match="what to do"):
        raise kind("what to do")


HOSTILE = "a\x1b[31m\x07\x9b2J\u202e\u2066\u200b\ud800\u2028\r\nb\tc\x7f"


def test_no_message_carries_a_character_that_a_terminal_obeys():
    for kind in (AsperityError, InputError, NoSolutionError, PrecisionError, MissingExtraError):
        message = str(kind(f"joint.toml: {HOSTILE}"))
        assert message.isprintable()
        assert message == (r"joint.toml: a\x1b[31m\x07\x9b2J\u202e\u2066\u200b\ud800\u2028\r\nb\tc\x7f")


def test_lists_of_errors_keep_their_lines_and_text_its_letters():
    assert str(InputError("2 errors\n  µ·²: α\n  b\x00")) == "2 errors\n  µ·²: α\n  b\\x00"
    assert printable(printable(HOSTILE)) == printable(HOSTILE)


def test_long_and_deep_values_are_shortened():
    assert quoted("5 mm") == "'5 mm'"
    assert quoted("\x1b" * 1000) == "'" + r"\x1b" * 19 + r"\x1" + "…"
    deep = []
    for _ in range(100_000):
        deep = [deep]
    assert quoted(deep) == "a deeply nested value"
