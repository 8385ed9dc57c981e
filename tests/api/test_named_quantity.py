import math

import numpy as np
import pytest

from asperity.api.named_quantity import NamedQuantity, si_number
from asperity.errors import InputError
from asperity.unit_table import Dimension

STIFFNESS = NamedQuantity(
    "stiffness", "torsional stiffness", 3000.0, Dimension.TORSIONAL_STIFFNESS, "N*m/rad", level="assembly"
)
FORCE = NamedQuantity(
    "force", "normal force", np.array([1.0, 2500.0]), Dimension.FORCE, "kN", rows=("sp", "pwr")
)
SLIPS = NamedQuantity("limiting", "slips first", 1.0, Dimension.DIMENSIONLESS, "1", categories=("sp", "pwr"))


def test_value_unit_and_conversion():
    assert (STIFFNESS.value, STIFFNESS.si, STIFFNESS.unit, STIFFNESS.si_unit) == (
        3000.0,
        3000.0,
        "N*m/rad",
        "N*m/rad",
    )
    assert STIFFNESS.to("N*m/arcmin") == pytest.approx(3000.0 * math.pi / 180.0 / 60.0, rel=1e-15)
    assert STIFFNESS.to("N-m/arc-min") == STIFFNESS.to("N*m/arcmin")
    # 1 lbf is 4.4482216152605 N, 1 in is 0.0254 m
    inch_pounds = 3000.0 / (4.4482216152605 * 0.0254)
    assert STIFFNESS.to("in-lb/rad") == pytest.approx(inch_pounds, rel=1e-15)
    assert repr(STIFFNESS) == "torsional stiffness: 3000 N·m/rad"


def test_rows():
    np.testing.assert_array_equal(FORCE.value, [0.001, 2.5])
    assert (FORCE["pwr"].value, FORCE["pwr"].si, FORCE["pwr"].name) == (2.5, 2500.0, "force_pwr")
    assert str(FORCE) == "sp 0.001 kN, pwr 2.5 kN"
    assert [each.name for each in FORCE.singles()] == ["force_sp", "force_pwr"]
    assert STIFFNESS.singles() == [STIFFNESS]


def test_category_is_a_name():
    assert (SLIPS.value, str(SLIPS)) == ("pwr", "pwr")


@pytest.mark.parametrize(
    ("call", "says"),
    [
        (lambda: STIFFNESS.to("mm"), r"expected a torsional stiffness.*got a length 'mm'"),
        (lambda: STIFFNESS.to("1"), r"stiffness is a torsional stiffness; '1' is no unit of it"),
        (lambda: FORCE["xx"], r"force has no row 'xx'; it has sp, pwr"),
        (lambda: STIFFNESS["sp"], r"stiffness has no row 'sp'; it is a single number"),
        (
            lambda: si_number(1200, Dimension.FORCE, name="load.preload"),
            r"^load.preload: .*got the bare number 1200",
        ),
        (lambda: si_number(np.float64(7), Dimension.FORCE, name="F"), r"got the bare number 7\.0"),
        (lambda: si_number("3 mm", Dimension.FORCE, name="F"), r"^F: expected a force .* got a length 'mm'"),
        (
            lambda: si_number(STIFFNESS, Dimension.FORCE, name="F"),
            r"F: expected a force, got a torsional stiffness",
        ),
        (lambda: si_number(FORCE, Dimension.FORCE, name="F"), r"F: expected a force, got several numbers"),
    ],
)
def test_wrong_units_are_refused(call, says):
    with pytest.raises(InputError, match=says):
        call()


def test_numbers_that_a_user_may_give():
    assert si_number("1.2 kN", Dimension.FORCE, name="F") == 1200.0
    assert si_number(FORCE["pwr"], Dimension.FORCE, name="F") == 2500.0
    assert si_number(np.int64(3), Dimension.DIMENSIONLESS, name="n") == 3.0


def test_what_is_not_known_has_a_dash_and_what_has_no_end_is_infinite():
    life = NamedQuantity("life", "life", math.nan, Dimension.TIME, "h")
    slip = NamedQuantity(
        "slip", "slip", np.array([math.inf, -math.inf]), Dimension.FORCE, "N", rows=("a", "b")
    )
    first = NamedQuantity(
        "limiting", "slips first", math.nan, Dimension.DIMENSIONLESS, "1", categories=("sp",)
    )
    assert (str(life), str(first), str(slip)) == ("–", "–", "a infinite, b -infinite")
