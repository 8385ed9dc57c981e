"""Colours and lines of the figures."""

from asperity.drive.geometry import CONTACT_NAMES
from asperity.show.style import CONTACT_LABELS, CONTACT_STYLES, plain_title, torque_colors


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
