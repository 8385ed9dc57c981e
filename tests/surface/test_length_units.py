"""Units of length."""

import pytest

from asperity.errors import InputError
from asperity.surface.length_units import length_in_metres, metres_per_unit, unit_in_words


def test_units():
    assert length_in_metres("0.5 um") == pytest.approx(0.5e-6)
    assert length_in_metres("1e-9m") == pytest.approx(1e-9)
    assert metres_per_unit("µm") == metres_per_unit("\u03bcm") == 1e-6
    assert unit_in_words("Lateral um") == "um"
    assert unit_in_words("[1/0]") is None


@pytest.mark.parametrize("text", ["5", "five mm", "5 parsec", "1.2.3 mm"])
def test_wrong_lengths(text):
    with pytest.raises(InputError):
        length_in_metres(text)
