"""Exit codes and Python's own families of the errors, as documented."""

import ast
import re
from pathlib import Path
from xml.etree import ElementTree

import pytest

import asperity
from asperity.errors import (
    AsperityError,
    InputError,
    MissingExtraError,
    NoSolutionError,
    PrecisionError,
    nearest,
    one_line,
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


def test_a_name_is_one_line_that_every_document_can_hold():
    name = one_line(f"µ {HOSTILE}\n  next\ufffe\U0001f600")
    assert (
        name
        == r"µ a\x1b[31m\x07\x9b2J\u202e\u2066\u200b\ud800\u2028\r\nb\tc\x7f\n  next\ufffe" + "\U0001f600"
    )
    assert name.isprintable()
    root = ElementTree.fromstring(
        f"<name>{name}</name>".encode()
    )  # XML 1.0 knows no control characters at all
    assert root.text == name


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


def test_no_message_names_an_option_which_only_the_command_line_has():
    """The command line adds the names of the options itself, from the attribute ``options`` of the error."""
    root = Path(asperity.__file__).parent
    found = []
    for file in root.rglob("*.py"):
        if file.is_relative_to(root / "cli"):
            continue
        tree = ast.parse(file.read_text(encoding="utf-8"))
        raised = [node.exc for node in ast.walk(tree) if isinstance(node, ast.Raise) and node.exc]
        texts = [
            part.value
            for error in raised
            for part in ast.walk(error)
            if isinstance(part, ast.Constant) and isinstance(part.value, str)
        ]
        found += [f"{file.name}: {text}" for text in texts if re.search(r"(^|[\s('])--[a-z]", text)]
    assert found == []


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("push_angle", "; did you mean 'left_push_angle' or 'right_push_angle'?"),  # likeness 0.80 and 0.77
        ("right_push_angel", "; did you mean 'right_push_angle'?"),
        ("viscosity", ""),
    ],
)
def test_names_as_alike_as_the_best_one_are_told_beside_it(name, told):
    assert nearest(name, ("left_push_angle", "right_push_angle", "ring_radius")) == told
