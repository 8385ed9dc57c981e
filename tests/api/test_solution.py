"""A solution against the document that the command prints for the same file."""

import math

import numpy as np
import pytest

import asperity
from asperity.errors import InputError
from asperity.results import RESULTS
from asperity.results.table import results_of_joint


def test_values_are_those_of_the_command(solution, printed, zou_file):
    document = printed("joint", zou_file)
    assert solution.document == document
    for level in ("published", "series_with_bulk", "assembly"):
        stiffness = document["torsional_stiffness"][level]
        found = solution["stiffness", level]
        assert (found.si, found.level) == (stiffness["output_Nm_per_rad"], level)
        assert found.to("N*m/arcmin") == pytest.approx(stiffness["output_Nm_per_arcmin"], rel=1e-14)
        assert solution[f"{level}_stiffness_input"].si == stiffness["input_Nm_per_rad"]
    assert solution["stiffness"].si == document["torsional_stiffness"]["assembly"]["output_Nm_per_rad"]
    assert solution["torque_capacity"].si == document["torque_capacity"]["output_torque_Nm"]
    assert solution["capacity_limit"].value == document["torque_capacity"]["limit"]
    assert solution["limiting_place"].value == document["torque_capacity"]["limiting_place"] == "sp"
    standing = document["standing_torque_capacity"]
    assert solution["standing_torque_capacity"].si == standing["output_torque_Nm"]
    assert solution["standing_limiting_contact"].value == standing["limiting_contact"]
    # cosine rule in the triangle of 17.5, 18.5 and 35 mm
    assert solution["wedge_angle"].value == pytest.approx(
        math.degrees(math.acos((35.0**2 + 18.5**2 - 17.5**2) / (2.0 * 35.0 * 18.5)))
    )
    for contact, entry in document["standing"]["contacts"].items():
        assert solution["hertz_pressure"][contact].si == entry["hertz_pressure_Pa"]
        assert solution[f"hertz_pressure_{contact}"].value == pytest.approx(1e-6 * entry["hertz_pressure_Pa"])
        assert solution["normal_force"][contact].si == document["standing"]["forces"]["normal_N"][contact]


@pytest.mark.slow
def test_every_row_of_the_table_of_results_is_there(solution):
    rows = results_of_joint(solution._solved)
    assert list(solution) == list(rows) == solution.keys()
    assert len(solution) == len(rows) == len(RESULTS)
    for name, row in rows.items():
        found = solution[name]
        assert (found.label, found.unit, found.si_unit) == (row.label, row.display_unit, row.si_unit)
        assert np.shape(found.si) == row.row_shape


def test_text_shows_stiffness_with_units_and_warnings(solution):
    text = repr(solution)
    assert f"Stiffness at the output  {solution['stiffness'].to('N*m/arcmin'):.4g} N·m/arcmin" in text
    warned = " ".join(text.partition("Warnings, most serious first")[2].split())
    first = warned.partition("Hertz pressure over first yield ")[2].partition(" (limit 1)")[0]
    assert [place.rpartition(" ")[2] for place in first.split(", ")] == ["sp", "pwr", "pwl", "wro", "wlo"]
    assert "<caption>Torsional stiffness</caption>" in solution._repr_html_()


def test_drift_per_turn_is_printed_beside_the_stiffness(solution, printed, zou_file):
    drift = printed("joint", zou_file)["drift_rad_per_output_turn"]
    assert solution["drift"].si == drift
    text = repr(solution)
    shown = f"{np.degrees(drift) * 60.0:.4g} arcmin"
    figures = ("Stiffness at the output", "Drift per output turn", "Torque capacity")
    assert sorted(map(text.index, figures)) == list(map(text.index, figures))
    assert f"Drift per output turn    {shown}" in text
    assert text.index("Drift per output turn") < text.index("asperities alone, as published")


def test_a_joint_without_crossed_limits_says_so(solution):
    kept = [limit | {"ok": True} for limit in solution.limits]
    other = type(solution)(solution._case, solution._solved, source="x", summary="x")
    sound = solution.document["verdict"] | {"works": True, "holds": True}
    other.document = solution.document | {"diagnostics": kept, "verdict": sound}
    assert repr(other).endswith("No warnings: all limits are met.")


def test_a_warning_states_all_of_its_values(solution):
    """Safeties of 0.9 and 0.5 that should be above 1, and one that is not known."""
    entry = {"name": "rim", "label": "wall", "limit": 1.0, "ok": False, "severity": "damage", "meaning": "m"}
    entry["known"] = True
    entry |= {"limit_shown": "1", "remedy": None}
    values = {"held_ring": 0.9, "planet": 0.5}
    crossed = [
        entry | {"contact": place, "value": value, "shown": f"{value}"} for place, value in values.items()
    ]
    unknown = entry | {
        "contact": "sun",
        "value": None,
        "shown": "not known",
        "known": False,
        "infinite": False,
    }

    def warned(*entries):
        other = type(solution)(solution._case, solution._solved, source="x", summary="x")
        other.document = solution.document | {"diagnostics": list(entries)}
        said = repr(other).partition("Warnings, most serious first\n")[2]
        return [line.strip() for line in said.splitlines()]

    assert warned(*crossed) == ["Damage: wall 0.9 at held ring, 0.5 at planet (limit 1)", "m"]
    # what is not known does not hide what is crossed
    assert warned(*crossed, unknown)[0] == (
        "Damage: wall 0.9 at held ring, 0.5 at planet, not known at sun (limit 1)"
    )
    assert warned(unknown)[0].startswith("Not checked: wall not known")


def test_frame_and_series_carry_units(solution):
    frame = solution.to_frame()
    assert frame.loc["slip_ratio_sp", "unit"] == "1"
    assert frame.loc["hertz_pressure_sp", ["unit", "si_unit"]].tolist() == ["MPa", "Pa"]
    assert frame.loc["hertz_pressure_sp", "value"] == pytest.approx(
        1e-6 * frame.loc["hertz_pressure_sp", "si"]
    )
    series = solution.to_series()
    assert series["assembly_stiffness_output", "N*m/rad"] == solution["stiffness"].si
    assert (
        len(series)
        == len(frame)
        == sum(max(1, len(r.row_names)) for r in results_of_joint(solution._solved).values())
    )


def test_figure_shows_the_shares_of_the_compliance(solution):
    figure = solution.plot()
    budget, levels = figure.axes
    assert sum(bar.get_width() for bar in budget.patches) == pytest.approx(100.0, abs=1e-6)
    (line,) = levels.lines
    assert line.get_xdata()[0] == pytest.approx(solution["stiffness"].to("N*m/arcmin"))


@pytest.mark.parametrize(
    ("asked", "says"),
    [
        ("stifness", "there is no result 'stifness'; did you mean 'stiffness'"),
        ("gross_slip", "renamed to 'slip_ratio'"),
        ("slip_ratio_xx", "did you mean 'slip_ratio'"),
        (("stiffness", "full"), "no level of the stiffness 'full'; known are assembly"),
        (3, "expected the name of a result as text, got 3"),
    ],
)
def test_unknown_results_are_refused(solution, asked, says):
    with pytest.raises(InputError, match=says):
        solution[asked]
    assert asked not in solution


def test_a_torque_beyond_the_capacity_is_one_message(joint):
    with pytest.raises(InputError, match=r"beyond the standing torque capacity 13\.16 N·m"):
        joint.with_values({"load.output_torque": "40 N*m"}).solve()


@pytest.mark.slow
def test_a_planetary_by_its_own_names(zou_file):
    solution = asperity.load(zou_file.parent / "planetary.toml").solve()
    assert solution["speed_ratio"].si == pytest.approx(6.0)
    assert solution["slip_ratio"].rows == ("sp", "pr")
    assert solution["slip_ratio_pr"].value == solution["slip_ratio"]["pr"].value
    assert solution["clearance"]["planet_to_planet"].si == pytest.approx(
        60e-3 * math.sin(math.pi / 3.0) - 40e-3
    )
    assert solution["torque_safety"].si == pytest.approx(solution["torque_capacity"].si / 10.0)
    assert solution.document["geometry"]["sectors"] == 3
    with pytest.raises(InputError, match="no result 'wedge_angle': only one with wedges"):
        solution["wedge_angle"]
    text = str(solution)
    assert "\nEfficiency  " in text
    assert "\npr  " in text


def test_text_of_a_joint_beyond_what_is_known_shows_no_nan(joint):
    """Loaded above shakedown the drive has no life; with plastic spots only it has no stiffness."""
    for changes in ({"load.preload": "20 kN"}, {"surface.fractal_dimension": "1.05"}):
        solution = joint.with_values(changes).solve()
        assert math.isnan(solution["drive_life"].si) or math.isnan(solution["stiffness"].si)
        assert "nan" not in str(solution)
