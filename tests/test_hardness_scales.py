"""Hardness numbers as pressures: ASTM E140 as two publishers print it, definitions, and the library's own entries."""

import re

import pint
import pytest

from asperity.errors import InputError
from asperity.hardness_scales import (
    hardness_words,
    rockwell_of_brinell,
    rockwell_of_vickers,
    vickers_of_rockwell,
)
from asperity.joint_file.limits import HARDNESS
from asperity.library import read_materials
from asperity.units import Dimension, from_si, parse_quantity, parse_tolerance

PINT = pint.UnitRegistry(cache_folder=None)
#: 1 kgf/mm^2 by pint [Pa].
VICKERS = PINT.Quantity("1 kgf/mm**2").to_base_units().magnitude

# HRC → HV as mikipulley.co.jp and phase2plus.com print ASTM E140, table 1
PRINTED = {68: 940, 65: 832, 63: 772, 60: 697, 58: 653, 55: 595, 50: 513, 45: 446, 40: 392, 30: 302, 20: 238}


@pytest.mark.parametrize("written", ["700 HV", "700HV", "700 HV10", "700 HV 30", "700 HV0.5", "7e2 HV30/20"])
def test_vickers_is_a_kilogram_force_per_square_millimetre(written):
    assert parse_quantity(written, Dimension.HARDNESS) == pytest.approx(700.0 * VICKERS, rel=1e-15)
    assert parse_quantity(written, Dimension.HARDNESS) == pytest.approx(6.865e9, rel=1e-4)


def test_a_pressure_is_a_hardness_and_is_shown_in_vickers():
    assert parse_quantity("1260 MPa", Dimension.HARDNESS) == 1260e6
    assert from_si(700.0 * VICKERS, "HV") == pytest.approx(700.0, rel=1e-15)


@pytest.mark.parametrize(("rockwell", "vickers"), PRINTED.items())
def test_rockwell_c_is_read_by_the_printed_table(rockwell, vickers):
    assert vickers_of_rockwell(rockwell_c=float(rockwell)) == vickers
    assert parse_quantity(f"{rockwell} HRC", Dimension.HARDNESS) == pytest.approx(
        vickers * VICKERS, rel=1e-14
    )


def test_between_entries_the_table_is_linear():
    assert vickers_of_rockwell(rockwell_c=60.5) == pytest.approx(0.5 * (697 + 720), rel=1e-14)
    assert vickers_of_rockwell(rockwell_c=44.25) == pytest.approx(434 + 0.25 * (446 - 434), rel=1e-14)


def test_materials_of_the_library_that_state_rockwell_c_are_read_to_their_hardness():
    stated = 0
    for material in read_materials().values():
        found = re.search(r"(\d+ HRC) = \d+ HV by ASTM E140", material.reference)
        if found:
            stated += 1
            library = parse_quantity(material.numbers["hardness"], Dimension.HARDNESS)
            assert parse_quantity(found[1], Dimension.HARDNESS) == pytest.approx(library, rel=1e-3)
    assert stated == 3


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (
            "19.9 HRC",
            r"19\.9 HRC is outside ASTM E140, which goes from 20 to 68 HRC.*state the hardness in HV",
        ),
        ("69 HRC", r"69 HRC is outside ASTM E140"),
        ("-60 HRC", r"-60 HRC is outside ASTM E140"),
        # 286 HBW is 30 HRC, 302 HV; 294 is 31 HRC, 310 HV
        (
            "286 HBW",
            r"a Brinell number depends on ball and load.*286 HBW of steel are 302 HV by ASTM E140.*'302 HV'",
        ),
        ("290 HB", r"290 HBW of steel are 306 HV by ASTM E140"),
        ("654 HBW 10/3000", r"654 HBW of steel are 697 HV"),
        ("100 HB", "a Brinell number depends on ball and load; state the hardness in HV or as a pressure"),
        (
            "90 HRB",
            r"'HRB' is no scale that is read; state the hardness in HV or as a pressure, e\.g\. '700 HV'",
        ),
        ("80 HRA", "'HRA' is no scale that is read"),
        ("500 HK", "'HK' is no scale that is read"),
        ("700 Hv", "unknown unit 'Hv'; did you mean 'HV'"),
        ("700 HV mm", "HV stands alone"),
        ("5 mm", "expected a hardness .* got a length"),
        ("700", "expected a hardness with its unit"),
    ],
)
def test_what_is_no_hardness_is_answered_with_what_to_state(text, message):
    with pytest.raises(InputError, match=message):
        parse_quantity(text, Dimension.HARDNESS)


@pytest.mark.parametrize("text", ["206 HV", "60 HRC", "300 HB"])
def test_a_hardness_number_is_no_other_pressure(text):
    with pytest.raises(InputError, match=r"expected a pressure .* got a hardness"):
        parse_quantity(text, Dimension.PRESSURE)


def test_brinell_between_entries():
    # 601 lies between 595 (57 HRC) and 615 (58 HRC)
    assert rockwell_of_brinell(brinell=601.0) == pytest.approx(57.3, rel=1e-12)
    assert rockwell_of_brinell(brinell=225.9) is None
    assert rockwell_of_brinell(brinell=739.1) is None


def test_tolerances_of_hardness():
    value, tolerance = parse_tolerance("700 HV +- 30 HV", Dimension.HARDNESS)
    assert (value, tolerance) == pytest.approx((700 * VICKERS, 30 * VICKERS), rel=1e-15)
    # 58 and 62 HRC are 653 and 746 HV, not alike about 697
    with pytest.raises(InputError, match=r"653 HV.*746 HV.*uneven.*tolerance in HV or as a pressure"):
        parse_tolerance("60 HRC +- 2 HRC", Dimension.HARDNESS)
    with pytest.raises(InputError, match="tolerance in HV or as a pressure"):
        parse_tolerance("60 HRC +- 30 HRC", Dimension.HARDNESS)
    with pytest.raises(InputError, match="tolerance in HV or as a pressure"):
        parse_tolerance("700 HV +- 30 HRC", Dimension.HARDNESS)
    value, tolerance = parse_tolerance("60 HRC +- 30 HV", Dimension.HARDNESS)
    assert (value, tolerance) == pytest.approx((697 * VICKERS, 30 * VICKERS), rel=1e-14)


@pytest.mark.parametrize(("text", "pascal"), [("700 HV", 700 * VICKERS), ("60 HRC", 697 * VICKERS)])
def test_the_key_of_joint_files_reads_both_scales(text, pascal):
    assert HARDNESS.read(text).value == pytest.approx(pascal, rel=1e-14)


@pytest.mark.parametrize(("rockwell", "vickers"), PRINTED.items())
def test_a_drawing_states_the_printed_rockwell_number_of_a_vickers_number(rockwell, vickers):
    assert rockwell_of_vickers(vickers=vickers) == pytest.approx(rockwell)
    assert hardness_words(pressure=9.80665e6 * vickers) == f"{vickers:g} HV, of steel {rockwell:g} HRC"


@pytest.mark.parametrize("vickers", [128, 237, 941, 1500])
def test_outside_the_table_a_drawing_states_vickers_alone(vickers):
    assert hardness_words(pressure=9.80665e6 * vickers) == f"{vickers} HV"
