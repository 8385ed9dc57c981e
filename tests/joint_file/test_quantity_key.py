import math

import pytest

from asperity.errors import InputError
from asperity.joint_file.quantity_key import Key
from asperity.unit_table import Dimension

RADIUS = Key(Dimension.LENGTH, 1e-3, 1e5, "mm")
DIMENSION = Key(Dimension.DIMENSIONLESS, 1.0, 2.0, open_lower=True, open_upper=True)
REQUIRED = Key(Dimension.TIME, 0.0, 1e9, "h", open_lower=True, exact=True)
COUNT = Key(Dimension.DIMENSIONLESS, 2, 100, integer=True)


def test_a_quantity_is_read_in_si_with_its_tolerance_and_its_text():
    assert RADIUS.read("13.5 mm").value == 0.0135
    assert RADIUS.read("13.5 mm").tolerance == 0.0
    with_tolerance = RADIUS.read("13.5 mm +- 5 um")
    assert (with_tolerance.value, with_tolerance.tolerance) == (0.0135, 5e-6)
    assert with_tolerance.text == "13.5 mm +- 5 um"
    assert DIMENSION.read(1.4).value == 1.4
    assert DIMENSION.read("1.4 ± 0.02").tolerance == 0.02
    assert COUNT.read(3).value == 3.0


@pytest.mark.parametrize("written", ["0.001 mm", "1 um", "100 m", "100000 mm"])
def test_a_closed_bound_belongs_to_the_range_in_every_unit(written):
    assert RADIUS.read(written).text == written


@pytest.mark.parametrize(
    ("key", "written", "said"),
    [
        (RADIUS, "-4 mm", "-4 mm is not allowed; it must be at least 0.001 mm and at most 100000 mm"),
        (RADIUS, "0 mm", "0 mm is not allowed"),
        (RADIUS, "101 m", "101000 mm is not allowed"),
        (RADIUS, "4", "got the bare number '4'"),
        (RADIUS, 4, "expected a length with its unit as text (e.g. '13.5 mm'), got the bare number 4"),
        (RADIUS, "4 MPa", "expected a length (e.g. '13.5 mm'), got a pressure 'MPa' in '4 MPa'"),
        (RADIUS, "nan mm", "not a finite number"),
        (RADIUS, True, "got True"),
        (RADIUS, [4.0], "got [4.0]"),
        (RADIUS, "4 mm +- -1 mm", "negative tolerance"),
        (DIMENSION, 1.0, "1 is not allowed; it must be above 1 and below 2"),
        (DIMENSION, 2.0, "2 is not allowed"),
        (DIMENSION, math.nan, "not finite"),
        (DIMENSION, math.inf, "not finite"),
        (DIMENSION, "1.4 mm", "expected a dimensionless number"),
        (COUNT, 2.5, "2.5 is not allowed; it must be a whole number, at least 2 and at most 100"),
        (COUNT, 1, "1 is not allowed"),
        (COUNT, "3 +- 1", "a whole number has no tolerance"),
        (REQUIRED, "20000 h +- 1 h", "what is required has no tolerance, got '20000 h +- 1 h'"),
        (REQUIRED, "0 h", "0 h is not allowed; it must be above 0 h and at most 1e9 h"),
    ],
)
def test_everything_else_is_refused_with_the_value_and_what_is_allowed(key, written, said):
    with pytest.raises(InputError) as refused:
        key.read(written)
    assert said in str(refused.value)


def test_nan_is_in_no_range():
    assert not RADIUS.admits(math.nan)
    assert not DIMENSION.admits(math.nan)
