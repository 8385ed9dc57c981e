"""Sections of a report on wear and accuracy: those of the commands, with a picture, where the file has them."""

from pathlib import Path

import pytest

from asperity.joint_file.accuracy import joint_accuracy
from asperity.joint_file.reader import parse_case, read_case
from asperity.joint_file.wear import wear_of_case
from asperity.report.years_sections import accuracy_section, wear_section
from asperity.results.accuracy_document import accuracy_document
from asperity.results.wear_document import wear_document
from asperity.views.accuracy import accuracy
from asperity.views.blocks import Heading, Paragraph, Picture
from asperity.views.wear import wear

EXAMPLES = Path(__file__).parents[2] / "examples"
WORN, UNEVEN = EXAMPLES / "wear.toml", EXAMPLES / "accuracy.toml"


def split(blocks):
    """Heading, pictures, and everything else."""
    heading, *others = blocks
    pictures = [block for block in others if isinstance(block, Picture)]
    return heading, pictures, [block for block in others if block not in pictures]


def test_wear_is_that_of_the_command_with_its_picture():
    case = read_case(str(WORN))
    heading, (picture,), others = split(wear_section(case))
    assert heading == Heading("Wear over the years")
    assert others == list(wear(wear_document(wear_of_case(case))))
    assert picture.svg.count("</svg>") == 1


def test_accuracy_is_that_of_the_command_with_its_picture():
    case = read_case(str(UNEVEN))
    heading, (picture,), others = split(accuracy_section(case))
    assert heading == Heading("Accuracy over a turn")
    assert others == list(accuracy(accuracy_document(joint_accuracy(case))))
    assert picture.svg.count("</svg>") == 1


def test_a_file_without_them_has_no_sections():
    assert list(wear_section(read_case(str(UNEVEN)))) == []
    assert list(accuracy_section(read_case(str(WORN)))) == []


@pytest.mark.parametrize(
    ("section", "file", "old", "new", "why"),
    [
        (
            wear_section,
            WORN,
            'interference = "25 um"',
            'preload = "1 kN"',
            "load.preload: a force does not say",
        ),
        (accuracy_section, UNEVEN, "3 = ", "900 = ", "harmonic 900 of the sun"),
    ],
)
def test_what_is_not_known_is_said_in_its_section(section, file, old, new, why):
    text = file.read_text(encoding="utf-8")
    assert old in text
    _, said = section(parse_case(text.replace(old, new, 1), source="x"))
    assert isinstance(said, Paragraph)
    assert said.text.startswith(f"Not known: {why}")
