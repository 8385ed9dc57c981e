"""Measured traction in joint files: curves from files, discs taken off, tables over conditions, and what is refused."""

import json
from pathlib import Path

import numpy as np
import pytest
from assumed import assumptions

from asperity.contact.fluid import DataSheetTraction
from asperity.contact.measured_traction import MeasuredTraction
from asperity.errors import InputError
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.edited_text import joint_file_text
from asperity.joint_file.reader import parse_case, read_case
from asperity.joint_file.si_tables import replace_values, si_values, stated_tables, varied_keys
from asperity.joint_file.traction_curves import read_curve
from asperity.page.joint_request import refuse_named_files

PLANETARY = (Path(__file__).parents[2] / "examples" / "planetary.toml").read_text()
HEAD = PLANETARY.replace('viscosity = "30 mPa*s"', 'fluid = "mine"') + (
    '\n[temperature]\nassembly = "20 degC"\nworking = "40 degC"\n\n[fluids.mine]\n'
    'viscosity_40 = "100 mm^2/s"\nviscosity_100 = "11 mm^2/s"\ndensity = "880 kg/m^3"\n'
)
RIG = 'rig = { youngs_modulus = "206 GPa", poisson_ratio = 0.3, peak_pressure = "1 GPa" }\n'
STICK = 206e9 / (2.0 * 0.91) / 1e9
RATIO = np.geomspace(2e-4, 2e-2, 9)
#: Elastic discs with a film of constant stress, 0.08 of the pressure: Carter's law.
CARTER = 0.08 * (1.0 - (1.0 - np.minimum(STICK * RATIO / 0.16, 1.0)) ** 2)


def written(path, rows, heading="srr,mu"):
    path.write_text("\n".join([heading, *(f"{one:.17g},{other:.17g}" for one, other in rows)]) + "\n")
    return path


def pairs(ratio=RATIO, traction=CARTER):
    return json.dumps([[float(one), float(other)] for one, other in zip(ratio, traction, strict=True)])


def traction_of(case):
    return joint_from_case(case).rolling.lubricant.fluid.traction


def at(traction, ratio):
    """Traction coefficients of a single curve of even slip."""
    (curve,) = traction.curves
    return np.exp(curve.at(np.log(ratio))[0])


def test_a_curve_in_a_file_is_taken_as_read_without_a_rig(tmp_path):
    written(tmp_path / "mine.csv", zip(RATIO, CARTER, strict=True))
    (tmp_path / "joint.toml").write_text(HEAD + 'traction_curve = "mine.csv"\n')
    case = read_case(tmp_path / "joint.toml")
    traction = traction_of(case)
    assert isinstance(traction, MeasuredTraction)
    assert at(traction, RATIO) == pytest.approx(CARTER, rel=1e-12)
    assert "discs of its traction_curve count twice" in " ".join(assumptions(case))


def test_with_a_rig_the_discs_are_taken_off():
    case = parse_case(HEAD + f"traction_curve = [{{ points = {pairs()} }}]\n" + RIG, source="x")
    assert at(traction_of(case), RATIO) == pytest.approx(np.full(9, 0.08), rel=1e-6)
    assert "count twice" not in " ".join(assumptions(case))


@pytest.mark.parametrize(
    ("heading", "scale"),
    [
        ("SRR [%];traction coefficient", (100.0, 1.0)),
        ("slide-roll ratio;µ [%]", (1.0, 100.0)),
        ("slip;friction", (1, 1)),
    ],
)
def test_columns_have_the_names_and_units_of_rigs(tmp_path, heading, scale):
    rows = [
        f"{scale[0] * one:.12g};{scale[1] * other:.12g}" for one, other in zip(RATIO, CARTER, strict=True)
    ]
    path = tmp_path / "rig.csv"
    path.write_text("\n".join([heading, *rows]))
    assert pytest.approx(np.array([RATIO, CARTER]), rel=1e-9) == np.array(read_curve(path)).T


def test_both_directions_are_one_curve(tmp_path):
    """An offset of the sensor cancels; pure rolling is no point."""
    both = np.concatenate([-RATIO[::-1], [0.0], RATIO])
    traction = np.concatenate([-CARTER[::-1], [0.0], CARTER]) + 1e-4
    path = written(tmp_path / "both.csv", zip(both, traction, strict=True))
    assert pytest.approx(np.array([RATIO, CARTER]), rel=1e-9) == np.array(read_curve(path)).T


def test_many_rows_are_means_over_the_logarithm(tmp_path):
    ratio = np.geomspace(1e-4, 1e-1, 2000)
    path = written(tmp_path / "many.csv", zip(ratio, 0.01 * ratio**0.25, strict=True))
    found = np.array(read_curve(path)).T
    assert found.shape == (2, 40)
    assert found[1] == pytest.approx(0.01 * found[0] ** 0.25, rel=2e-3)


def test_curves_over_temperature_are_mixed():
    low, high = pairs(traction=0.08 * RATIO / (RATIO + 1e-3)), pairs(traction=0.04 * RATIO / (RATIO + 1e-3))
    text = HEAD + (
        f'traction_curve = [{{ temperature = "20 degC", points = {low} }}, '
        f'{{ temperature = "60 degC", points = {high} }}]\n'
    )
    traction = traction_of(parse_case(text, source="x"))
    assert traction.conditions.temperatures == pytest.approx((293.15, 333.15))
    shares = traction.conditions.shares(1e9, 313.15, 1.0)
    assert [float(share) for share in shares] == pytest.approx([0.5, 0.5])


def test_a_table_over_pressure_has_the_discs_of_each_row_taken_off():
    """1/m_F = 1/m - p0/E*, each at its pressure."""
    rows = (
        '{ pressure = "1 GPa", maximum_traction = 0.08, traction_slope = 60 }, '
        '{ pressure = "1.5 GPa", maximum_traction = 0.09, traction_slope = 55 }'
    )
    rig = 'rig = { youngs_modulus = "206 GPa", poisson_ratio = 0.3 }\n'
    case = parse_case(HEAD + f"traction_table = [{rows}]\n" + rig, source="x")
    traction = traction_of(case)
    assert isinstance(traction, DataSheetTraction)
    modulus = 206e9 / 1.82
    film = [1.0 / (1.0 / slope - pressure / modulus) for slope, pressure in ((60.0, 1e9), (55.0, 1.5e9))]
    for share in (0.0, 0.3, 1.0):
        pressure = 1e9 + share * 0.5e9
        assert float(traction.film_slope.at(pressure, 313.15, 1.0)) == pytest.approx(
            film[0] + share * (film[1] - film[0]), rel=1e-9
        )
        assert float(traction.maximum_traction.at(pressure, 313.15, 1.0)) == pytest.approx(
            0.08 + 0.01 * share
        )
    changed = replace_values(si_values(case), {"fluids.mine.traction_table.2.maximum_traction": 0.1})
    assert changed["fluids"]["mine"]["traction_table"]["2"]["maximum_traction"] == 0.1


def test_a_written_file_has_the_points_of_its_curve(tmp_path):
    """Any folder can have the text, and the page, which opens no files."""
    written(tmp_path / "mine.csv", zip(RATIO, CARTER, strict=True))
    text = HEAD + 'traction_curve = [{ file = "mine.csv", temperature = "40 degC" }]\n' + RIG
    case = parse_case(text, source="x", folder=tmp_path)
    again = parse_case(joint_file_text(case, {"load.output_torque": 7.0}, comment=""), source="y")
    assert si_values(again)["fluids"] == si_values(case)["fluids"]
    assert "mine.csv" not in again.text
    with pytest.raises(InputError, match="the page opens no other files"):
        refuse_named_files({"fluids": {"mine": {"traction_curve": "mine.csv"}}}, source="x")
    refuse_named_files({"fluids": {"mine": {"traction_curve": [{"points": []}]}}}, source="x")


def test_what_curves_are_made_of_is_no_number_of_a_study():
    case = parse_case(HEAD + f"traction_curve = [{{ points = {pairs()} }}]\n" + RIG, source="x")
    assert not any(path.startswith("fluids.mine.rig") for path in varied_keys(case))
    with pytest.raises(InputError, match="taken off the curves when the file is read"):
        replace_values(si_values(case), {"fluids.mine.rig.peak_pressure": 2e9})
    assert len(str(stated_tables(case)["fluids"])) < 200


STEEP = pairs(traction=np.minimum(1.01 * STICK * RATIO, 0.09))


@pytest.mark.parametrize(
    ("keys", "told"),
    [
        (f"traction_curve = [{{ points = {pairs()} }}]\nlimiting_traction = 0.05\n", "leave all but one out"),
        ("traction_curve = []\n", "fluids.mine.traction_curve"),
        ("traction_curve = [{ }]\n", "a curve needs its file, or points"),
        ("traction_curve = 3\n", "fluids.mine.traction_curve"),
        ('traction_curve = "absent.csv"\n', "fluids.mine.traction_curve: absent.csv"),
        ("traction_curve = [{ points = [[0.1, 0.05], [0.2, 0.06]] }]\n", "a curve of 2 points is too short"),
        ("traction_curve = [{ points = [[0.1, 0.05, 1]] }]\n", "expected pairs [slide-roll ratio"),
        (
            f"traction_curve = [{{ points = {pairs(traction=100 * CARTER)} }}]\n",
            "the traction coefficient goes up to 8, above 0.3: it is a share, not %",
        ),
        (
            f"traction_curve = [{{ points = {pairs(ratio=200 * RATIO)} }}]\n",
            "the slide-roll ratio goes up to 4, above 2",
        ),
        (f"traction_curve = [{{ points = {pairs(ratio=RATIO[::-1])} }}]\n", "must rise from point to point"),
        (f"traction_curve = [{{ points = {pairs(traction=CARTER - 0.03)} }}]\n", "must be above 0"),
        (
            f"traction_curve = [{{ points = {STEEP} }}]\n" + RIG,
            "traction_curve.1: at the slide-roll ratio 0.0002 the traction coefficient 0.02286 is steeper "
            "than the discs",
        ),
        (
            f"traction_curve = [{{ points = {pairs()} }}]\n" + RIG.replace(', peak_pressure = "1 GPa"', ""),
            "rig: its pressure is missing",
        ),
        (
            f'traction_curve = [{{ points = {pairs()}, speed = "1 m/s" }}, {{ points = {pairs()} }}]\n',
            "speed: state it for all of them, or for none",
        ),
        (
            "traction_table = [{ pressure = '1 GPa', maximum_traction = 0.08, traction_slope = 60 }, "
            "{ pressure = '1 GPa', maximum_traction = 0.08, traction_slope = 60 }]\n",
            "pressure 1 GPa must be number 1, once",
        ),
        (
            "traction_table = [{ pressure = '2 GPa', maximum_traction = 0.08, traction_slope = 60 }, "
            "{ pressure = '1 GPa', maximum_traction = 0.08, traction_slope = 60 }]\n",
            "pressure 1 GPa must be number 1, once: sort by pressure",
        ),
        (
            "traction_table = ["
            + ", ".join(
                f"{{ pressure = '{p} GPa', temperature = '{t} degC', maximum_traction = 0.08, traction_slope = 60 }}"
                for p, t in ((1, 40), (1, 80), (2, 40))
            )
            + "]\n",
            "pressure 2 GPa at temperature 80 degC is missing: give all combinations",
        ),
        (
            "traction_table = [{ pressure = '2 GPa', maximum_traction = 0.08, traction_slope = 60 }]\n" + RIG,
            "traction_table.1.traction_slope: 60 is steeper than the discs alone, whose slope E*/p0 is 56.59",
        ),
    ],
)
def test_what_cannot_be_is_refused_with_a_remedy(keys, told):
    with pytest.raises(InputError) as error:
        parse_case(HEAD + keys, source="x")
    assert told in str(error.value)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("speed,mu\n0.1,0.02\n0.2,0.03\n0.3,0.04\n", "needs one column for the slide-roll ratio, e.g. 'srr'"),
        ("srr,mu\n1,0.02\n2,0.03\n3,0.04\n5,0.04\n7,0.04\n", "goes up to 7, above 2: it is a share, not %"),
        ("srr,mu\n0.1,0.02\n0.2,0.03\n0.3,0.04\n", "a curve of 3 points is too short"),
    ],
)
def test_files_that_are_no_curve(tmp_path, text, told):
    path = tmp_path / "rig.csv"
    path.write_text(text)
    with pytest.raises(InputError) as error:
        read_curve(path)
    assert told in str(error.value)
