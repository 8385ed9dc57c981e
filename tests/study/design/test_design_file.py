"""Design files: what is read, and what is refused with which words."""

import tomllib

import pytest

from asperity.errors import InputError
from asperity.study.design.design_file import design_from_tables, read_design
from asperity.study.design.scenarios import scenarios

GOOD = """
joint = "zou2025.toml"
[variables]
surface.fractal_dimension = { lower = 1.3, upper = 1.9 }
"surface.fractal_roughness" = { lower = "1e-9 mm", upper = "1e-7 mm" }
[objective]
maximise = "stiffness"
[constraints]
slip_ratio = { at_most = 0.8, contacts = ["sp"] }
envelope_diameter = { at_most = "210 mm" }
[worst_case]
torque = { lower = "0 N*m", upper = "6 N*m", points = 4 }
"""


def problem(text, folder):
    return design_from_tables(tomllib.loads(text), folder=folder)


def test_good_file(zou_file):
    found = problem(GOOD, zou_file.parent)
    dimension, roughness = found.variables
    assert (dimension.path, dimension.logarithmic) == ("surface.fractal_dimension", False)
    assert roughness.logarithmic
    assert roughness.from_unit(0.5) == pytest.approx(1e-11, rel=1e-9, abs=0.0)
    assert roughness.to_unit(1e-11) == pytest.approx(0.5)
    assert found.level == "assembly"
    assert {(c.name, round(c.limit, 5), c.implied) for c in found.constraints} == {
        ("slip_ratio", 0.8, False),
        ("envelope_diameter", 0.21, False),
        ("slip_ratio", 1.0, True),
        ("clearance", 0.2e-3, True),
        ("normal_force_over_preload", 0.0, True),
        ("pressure_over_first_yield", 1.0, True),
        ("shakedown_ratio", 1.0, True),
    }
    states = scenarios(found)
    assert states.torques == pytest.approx(
        [5.0, 0.0, 2.0, 4.0, 6.0]
    )  # the file's torque first: it does not count
    assert states.counted.tolist() == [False, True, True, True, True]


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("[objective]", "[objectives]", "unknown key; did you mean 'objective'"),
        ("[constraints]", "[limits]", "limits: unknown key; did you mean 'constraints'"),
        (
            "[worst_case]",
            "rim_yield_safety = { at_least = 2 }\n[worst_case]",
            "only free rings and hollow rollers",
        ),
        ('maximise = "stiffness"', 'maximise = "stifness"', "did you mean 'stiffness'"),
        ('maximise = "stiffness"', "", "one objective, or two or three"),
        ('maximise = "stiffness"', 'maximise = "slip_ratio"', "can only be minimised"),
        ("upper = 1.9", "upper = 2.5", "2.5 is not allowed"),
        ("upper = 1.9", "upper = 1.2", "must be below the upper"),
        ("upper = 1.9", 'upper = 1.9, scale = "cubic"', "not one of log, linear"),
        (
            "surface.fractal_dimension = ",
            "surface.fractal_dimensions = ",
            "did you mean 'surface.fractal_dimension'",
        ),
        ('"1e-9 mm"', "1e-9", "bare number"),
        ('"1e-9 mm"', '"1e-9 N"', "variables.surface.fractal_roughness.lower: expected a length"),
        (
            "surface.fractal_dimension = { lower = 1.3, upper = 1.9 }",
            "drive.planets = { lower = 3, upper = 5 }",
            "whole numbers",
        ),
        ('{ at_most = "210 mm" }', '{ at_most = "210 N" }', "expected a length"),
        ('{ at_most = "210 mm" }', "{ }", "state 'at_most' or 'at_least'"),
        ('contacts = ["sp"]', 'contacts = ["xx"]', "not one of sp, pwr"),
        ('{ at_most = 0.8, contacts = ["sp"] }', '{ at_most = 0.8, rims = ["inner"] }', "rims"),
        ("[worst_case]", 'bearing_life = { at_least = "20000 h" }\n[worst_case]', "no ratings of a bearing"),
        ("at_most = 0.8", "at_most = 1.2", "at most 1"),
        (
            "[worst_case]",
            'clearance = { at_least = "-1 mm" }\n[worst_case]',
            "must be at least 0 mm",
        ),
        ("points = 4", "points = 1", "whole number from 2 to 50"),
        ('lower = "0 N*m"', 'lower = "7 N*m"', "0 <= lower < upper"),
        ("[worst_case]", '[worst_case]\ntolerances = "corners"', "states no tolerance"),
        ('joint = "zou2025.toml"', 'level = "best"\njoint = "zou2025.toml"', "not one of assembly"),
        ('joint = "zou2025.toml"', 'joint = "none.toml"', "there is no such file"),
        ("[worst_case]", "[search]\nseed = 3000000000\n[worst_case]", "from 0 to 2147483648, got 3000000000"),
        ("[worst_case]", "[search]\nseed = -1\n[worst_case]", "from 0 to 2147483648, got -1"),
        ("[worst_case]", "[search]\nstarts = 0\n[worst_case]", "from 1 to 1000, got 0"),
    ],
)
def test_bad_files(zou_file, old, new, message):
    assert old in GOOD
    with pytest.raises(InputError, match=message.replace("(", r"\(")):
        problem(GOOD.replace(old, new, 1), zou_file.parent)


_TWICE = """
joint = "planetary.toml"
[variables]
"FIRST" = { lower = "LOWEST", upper = "HIGHEST" }
OTHER = { lower = "LOW", upper = "HIGH" }
[objective]
minimise = "mass"
"""


@pytest.mark.parametrize(
    ("first", "other", "bounds"),
    [
        (
            "drive.ring_wall_thickness",
            "drive.ring_wall_thickness",
            {"LOWEST": "5 mm", "HIGHEST": "9 mm", "LOW": "4 mm", "HIGH": "14 mm"},
        ),
        # a file states one of both, and the other one was replaced without a word
        (
            "load.interference",
            "load.preload",
            {"LOWEST": "10 um", "HIGHEST": "40 um", "LOW": "500 N", "HIGH": "900 N"},
        ),
        (
            "surface.fractal_roughness",
            "surface.roughness_average",
            {"LOWEST": "1e-9 mm", "HIGHEST": "1e-6 mm", "LOW": "0.1 um", "HIGH": "0.4 um"},
        ),
        (
            "drive.contact_length.sp",
            "drive.contact_length",
            {"LOWEST": "5 mm", "HIGHEST": "9 mm", "LOW": "4 mm", "HIGH": "14 mm"},
        ),
    ],
)
def test_a_variable_that_is_stated_twice_is_refused(zou_file, first, other, bounds):
    text = _TWICE
    for word, meant in (("FIRST", first), ("OTHER", other), *bounds.items()):
        text = text.replace(f'"{word}"', f'"{meant}"').replace(f"{word} =", f"{meant} =")
    both = first if first == other else f"{first} and {other}"
    with pytest.raises(InputError, match=f"{both}: two variables for the same number; vary it once"):
        problem(text, zou_file.parent)


def test_a_result_that_is_limited_twice_is_refused(zou_file):
    text = _TWICE.replace('OTHER = { lower = "LOW", upper = "HIGH" }\n', "")
    for word, meant in (("FIRST", "drive.ring_wall_thickness"), ("LOWEST", "4 mm"), ("HIGHEST", "9 mm")):
        text = text.replace(word, meant)
    limits = "".join(
        f'{name} = {{ at_least = "1e5 N*m/rad" }}\n' for name in ("stiffness", "assembly_stiffness_output")
    )
    with pytest.raises(
        InputError,
        match=r"constraints\.stiffness and constraints\.assembly_stiffness_output limit the same result; limit it once",
    ):
        problem(f"{text}[constraints]\n{limits}", zou_file.parent)


def test_all_errors_of_a_file_are_said_at_once(zou_file):
    text = GOOD
    for old, new in (
        (
            "surface.fractal_dimension = { lower = 1.3, upper = 1.9 }",
            "load.prelod = { lower = 1, upper = 2 }",
        ),
        ('maximise = "stiffness"', "maximise = 0"),
        ("slip_ratio = { at_most = 0.8", "gross_slip = { at_most = 0.8"),
        ('envelope_diameter = { at_most = "210 mm" }', "hertz_pressure = { at_most = -9 }"),
        ("points = 4", "points = 1"),
    ):
        assert old in text
        text = text.replace(old, new)
    with pytest.raises(InputError) as caught:
        problem(text, zou_file.parent)
    first, *errors = str(caught.value).splitlines()
    assert first == "5 errors"
    for error, said in zip(
        errors,
        (
            "variables.load.prelod: a joint file has no number 'load.prelod'; did you mean 'load.preload'?",
            "objective.maximise: expected the name of a result as text, got 0",
            "constraints.gross_slip: there is no result 'gross_slip'; it was renamed to 'slip_ratio'",
            "constraints.hertz_pressure.at_most: expected",
            "worst_case.torque.points: expected a whole number from 2 to 50, got 1",
        ),
        strict=True,
    ):
        assert error.strip().startswith(said)


def test_limits_hold_for_the_bearings_that_have_ratings(zou_file, tmp_path):
    rated = '[pin_bearing]\ntype = "ball"\ndynamic_rating = "2 kN"\nstatic_rating = "1 kN"\ncount = 2\n'
    (tmp_path / "zou2025.toml").write_text(zou_file.read_text() + rated)

    def rows(entry):
        text = GOOD.replace("[worst_case]", f"bearing_life = {entry}\n[worst_case]")
        return next(c.rows for c in problem(text, tmp_path).constraints if c.name == "bearing_life")

    assert rows('{ at_least = "20000 h" }') == (0, 1)
    assert rows('{ at_least = "20000 h", bearings = ["left_loading_roller_pin"] }') == (1,)


def test_steps_are_read_and_checked(zou_file):
    stepped = GOOD.replace("upper = 1.9 }", "upper = 1.9, step = 0.05 }")
    assert [variable.step for variable in problem(stepped, zou_file.parent).variables] == [0.05, None]
    with pytest.raises(InputError, match="a multiple of it must lie between the bounds"):
        problem(GOOD.replace("upper = 1.9 }", "upper = 1.9, step = 7 }"), zou_file.parent)
    with pytest.raises(InputError, match=r"fractal_roughness\.step: .*bare number"):
        problem(GOOD.replace('upper = "1e-7 mm" }', 'upper = "1e-7 mm", step = 1 }'), zou_file.parent)


def test_finish_gives_the_bounds(zou_file):
    text = GOOD.replace('{ lower = "1e-9 mm", upper = "1e-7 mm" }', '{ finish = "superfinished" }')
    lower, upper = (getattr(problem(text, zou_file.parent).variables[1], side) for side in ("lower", "upper"))
    assert 1e-12 < lower < upper < 1e-9
    with pytest.raises(InputError, match="there is no finish"):
        problem(text.replace("superfinished", "superfinish3d"), zou_file.parent)


def test_unreadable(tmp_path):
    with pytest.raises(InputError, match="there is no such file"):
        read_design(tmp_path / "none.toml")
    (tmp_path / "bad.toml").write_text("joint = ")
    with pytest.raises(InputError, match="not valid TOML"):
        read_design(tmp_path / "bad.toml")


def test_corners_and_samples_of_tolerances(tmp_path, zou_file):
    text = (
        zou_file.read_text()
        .replace('"13.5 mm"', '"13.5 mm +- 5 um"')
        .replace('"1000 N"', '"1000 N +- 100 N"')
    )
    (tmp_path / "zou2025.toml").write_text(text)
    corners = problem(GOOD.replace("[worst_case]", '[worst_case]\ntolerances = "corners"'), tmp_path)
    states = scenarios(corners)
    assert states.torques.size == 1 + 4 * 5
    assert {tuple(row) for row in np_rows(states.deviations)} == {
        (0.0, 0.0), (-5e-6, -100.0), (-5e-6, 100.0), (5e-6, -100.0), (5e-6, 100.0),
    }  # fmt: skip
    changes = states.changes({"load.preload": 500.0})
    assert set(changes["load.preload"].round(6)) == {400.0, 500.0, 600.0}
    sampled = problem(
        GOOD.replace("[worst_case]", '[worst_case]\ntolerances = "samples"\nsamples = 7'), tmp_path
    )
    assert scenarios(sampled).torques.size == 1 + 4 * 8


def np_rows(deviations):
    import numpy as np

    return np.stack([deviations["drive.planet_radius"], deviations["load.preload"]], axis=1).round(12)


def test_limits_of_another_drive_have_its_names(zou_file):
    problem = read_design(zou_file.parent / "design_planetary.toml")
    assert problem.table["slip_ratio"].row_names == ("sp", "pr")
    assert {each.name: each.rows for each in problem.constraints} == {
        "slip_ratio": (0, 1),
        "hertz_pressure": (0, 1),
        "clearance": (0,),
        "normal_force_over_preload": (0, 1),
        "pressure_over_first_yield": (0, 1),
        "shakedown_ratio": (0, 1),
        "rim_yield_safety": (2,),
        "rim_fatigue_safety": (2,),
    }
    bounds = '{ lower = "4 mm", upper = "14 mm" }'
    text = f'joint = "planetary.toml"\n[variables]\n"VARIABLE" = {bounds}\n[objective]\nminimise = "GOAL"'
    for variable, goal, says in (
        ("drive.ring_radius", "mass", "of a drive of type planetary has no number 'drive.ring_radius'"),
        ("drive.sun_radius", "self_locking_ratio", "only one with wedges between planets and ring"),
    ):
        with pytest.raises(InputError, match=says):
            design_from_tables(
                tomllib.loads(text.replace("VARIABLE", variable).replace("GOAL", goal)),
                folder=zou_file.parent,
            )


def test_limits_hold_for_the_rated_bearings_of_another_drive(tmp_path, zou_file):
    joint = zou_file.with_name("planetary.toml").read_text()
    rated = '\n[pin_bearing]\ntype = "ball"\ndynamic_rating = "2 kN"\nstatic_rating = "1 kN"\ncount = 2\n'
    text = (
        'joint = "planetary.toml"\n[variables]\n"drive.contact_length" = { lower = "6 mm", upper = "20 mm" }\n'
        '[objective]\nminimise = "mass"\n[constraints]\nbearing_life = { at_least = "20000 h" }'
    )
    (tmp_path / "planetary.toml").write_text(joint + rated)
    assert problem(text, tmp_path).constraints[0].rows == (0,)
    (tmp_path / "planetary.toml").write_text(joint)
    with pytest.raises(
        InputError, match=r"no ratings of a bearing: a section for its ratings, such as \[pin_bearing\]"
    ):
        problem(text, tmp_path)


def test_limits_of_rims_hold_for_the_bodies_that_bend(tmp_path, zou_file):
    joint = zou_file.with_name("planetary.toml").read_text()
    text = (
        'joint = "planetary.toml"\n[variables]\n"drive.ring_wall_thickness" = { lower = "4 mm", upper = "14 mm" }\n'
        '[objective]\nminimise = "mass"\n[constraints]\n'
    )

    def limited(limit, support="free", steel="52100"):
        (tmp_path / "planetary.toml").write_text(
            joint.replace('ring_support = "free"', f'ring_support = "{support}"').replace("52100", steel)
        )
        return problem(text + limit, tmp_path).constraints[0]

    assert limited("rim_yield_safety = { at_least = 2 }").rows == (2,)
    safest = problem(text.replace('minimise = "mass"', 'maximise = "rim_yield_safety"'), tmp_path)
    assert safest.objectives[0].rows == (2,)
    assert limited('rim_yield_safety = { at_least = 2, bodies = ["ring"] }').rows == (2,)
    for limit, support, says in (
        ('rim_yield_safety = { at_least = 2, bodies = ["sun"] }', "free", "'sun' has none; only free rings"),
        ("rim_yield_safety = { at_least = 2 }", "rigid_housing", "only free rings and hollow rollers"),
        (
            "seat_torque_safety = { at_least = 2 }",
            "free",
            r"only rings in a housing that a section \[housing\]",
        ),
        (
            'seat_pressure = { at_least = "1 MPa" }',
            "free",
            r"only rings in a housing that a section \[housing\]",
        ),
        (
            'mounting_force = { at_most = "1 kN", bodies = ["sun"] }',
            "free",
            "'sun' has none; only rings have it",
        ),
        ('bore_stress = { at_most = "1 MPa" }', "free", "only hollow rollers of one track on pins"),
        ("ring_yield_safety = { at_least = 2 }", "free", "renamed to 'rim_yield_safety"),
    ):
        with pytest.raises(InputError, match=says):
            limited(limit, support)
    fatigue = "rim_fatigue_safety = { at_least = 2 }"
    assert limited(fatigue).rows == (2,)  # the library states it of this steel, and of no other
    with pytest.raises(InputError, match="where their material states fatigue_strength"):
        limited(fatigue, steel="440C")


@pytest.mark.parametrize("section", ["variables", "constraints"])
def test_a_section_of_thousands_of_entries_is_refused_at_once(section, tmp_path, zou_file):
    parts = {"objective": 'torsional_stiffness = "maximise"\n', "variables": "", "constraints": ""}
    parts[section] = "".join(f"k{i} = {{ lower = 1 }}\n" for i in range(20_000))
    text = f'joint = "{zou_file}"\n' + "".join(f"[{name}]\n{part}" for name, part in parts.items())
    (tmp_path / "d.toml").write_text(text)
    with pytest.raises(InputError, match=f"{section}: at most 1000 entries, got 20000") as caught:
        read_design(tmp_path / "d.toml")
    assert len(str(caught.value)) < 1000


def test_a_limit_of_the_ratio_needs_the_sense_of_the_drive_or_no_sign(zou_file):
    """The paper's drive has the ratio -9: a positive limit says nothing about it."""
    limited = GOOD.replace("[worst_case]", "speed_ratio = { at_least = 8 }\n[worst_case]")
    with pytest.raises(
        InputError, match="opposite directions, its speed_ratio is -9; limit absolute_speed_ratio"
    ):
        problem(limited, zou_file.parent)
    found = problem(limited.replace("speed_ratio", "absolute_speed_ratio"), zou_file.parent)
    assert ("absolute_speed_ratio", False, 8.0) in {(c.name, c.at_most, c.limit) for c in found.constraints}
    problem(limited.replace("at_least = 8", "at_most = -8"), zou_file.parent)


def test_without_its_joint_file_a_design_is_not_measured_against_another(tmp_path):
    """The one mistake is told: what other drives have, and which rows of a result, is not known."""
    (tmp_path / "d.toml").write_text(
        'joint = "nope.toml"\n[variables]\n"drive.planet_radius" = { lower = "6 mm", upper = "9 mm" }\n[objective]\n'
        'minimise = "slip_ratio"\n[constraints]\nslip_ratio = { at_most = 0.9, contacts = ["pr"] }\n'
        'bearing_life = { at_least = "20000 h" }\n'
    )
    with pytest.raises(InputError) as refused:
        read_design(tmp_path / "d.toml")
    assert str(refused.value) == (
        f"{tmp_path / 'd.toml'}: {tmp_path / 'nope.toml'}: there is no such file; 'asperity init' writes an example"
    )
