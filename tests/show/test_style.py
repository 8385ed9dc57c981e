"""Colours and lines of the figures."""

import pytest

from asperity.show.style import (
    CONTACT_LABELS,
    CONTACT_STYLES,
    mark_few_decades,
    plain_number,
    plain_title,
    torque_colors,
)
from asperity.zou2025.kinematics import CONTACT_NAMES


def test_every_contact_has_a_line_and_a_label():
    assert tuple(CONTACT_STYLES) == tuple(CONTACT_LABELS) == CONTACT_NAMES


def test_colours_of_a_family_become_darker():
    brightness = [sum(color[:3]) for color in torque_colors(6)]
    assert brightness == sorted(brightness, reverse=True)


def test_the_name_of_a_file_is_no_formula():
    from matplotlib.figure import Figure

    figure = Figure()
    figure.suptitle(plain_title("$\\foo$ \x1b[31m.toml"))
    figure.savefig("/dev/null", format="png")
    assert plain_title("a\x1b$b") == r"a\x1b\$b"


@pytest.mark.parametrize(
    ("low", "high", "shown"),
    [
        (900.0, 1100.0, ["900", "950", "1000"]),
        (300.0, 3000.0, ["500", "1000", "2000"]),
        (1e-9, 1e-6, ["$\\mathdefault{10^{-9}}$", "$\\mathdefault{10^{-8}}$"]),
    ],
)
def test_a_logarithmic_axis_has_numbers_whatever_it_spans(low, high, shown):
    from matplotlib.figure import Figure

    axes = Figure().subplots()
    axes.set_xscale("log")
    axes.set_xlim(low, high)
    mark_few_decades(axes.xaxis, low, high)
    places = axes.xaxis.get_majorticklocs()
    labels = [
        text
        for text, x in zip(axes.xaxis.get_major_formatter().format_ticks(places), places, strict=True)
        if low * 0.999 <= x <= high * 1.001
    ]
    assert labels[: len(shown)] == shown


def test_plain_numbers():
    assert [plain_number(each) for each in (40000.0, 1e-9, 2e6, 0.25)] == ["40000", "1e-9", "2e6", "0.25"]
