import pytest

import asperity
from asperity.errors import InputError


def test_numbers_of_the_file(joint):
    radius = joint["drive.planet_radius"]
    assert (radius.value, radius.unit, radius.si, radius.si_unit) == (13.5, "mm", 0.0135, "m")
    assert "drive.planet_radius" in joint._ipython_key_completions_()
    assert joint["load.sun_speed"].value == pytest.approx(6000.0)
    frame = joint.to_frame()
    assert frame.loc["load.preload", ["value", "unit", "si", "si_unit"]].tolist() == [
        1000.0,
        "N",
        1000.0,
        "N",
    ]


def test_a_change_makes_a_new_joint(joint):
    changed = joint.with_values({"load.preload": "1.2 kN", "load.friction_coefficient": 0.13})
    assert changed["load.preload"].si == 1200.0
    assert changed["load.friction_coefficient"].value == 0.13
    assert joint["load.preload"].si == 1000.0
    again = changed.with_values(
        {"surface.sp.fractal_dimension": 1.5, "load.output_torque": joint["load.output_torque"]}
    )
    assert again["surface.sp.fractal_dimension"].value == 1.5
    assert again["surface.wro.fractal_dimension"].value == 1.4
    assert again["load.preload"].si == 1200.0


def test_a_tolerance_stays(tmp_path, joint_text):
    file = tmp_path / "joint.toml"
    file.write_text(joint_text.replace('preload = "1000 N"', 'preload = "1000 N +- 50 N"'))
    frame = asperity.load(file).with_values({"load.preload": "900 N"}).to_frame()
    assert frame.loc["load.preload", ["value", "tolerance"]].tolist() == [900.0, 50.0]


def test_saved_joint_is_the_same(joint, tmp_path):
    changed = joint.with_values({"load.preload": "1234.5 N"})
    changed.save(tmp_path / "new.toml")
    assert asperity.load(tmp_path / "new.toml").case == changed.case


def test_text_names_every_number_with_its_unit(joint):
    text = repr(joint)
    assert "preload 1000 N, output torque 5 N·m, sun speed 6000 rpm" in " ".join(text.split())
    assert ["drive.planet_radius", "13.5", "mm"] in [line.split() for line in text.splitlines()]
    assert "<td>13.5 mm</td>" in joint._repr_html_()


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        (
            {"load.preload": 1200},
            r"^load.preload: expected a force with its unit as text .* bare number 1200",
        ),
        ({"load.preload": "12 mm"}, r"^load.preload: expected a force .* got a length"),
        ({"load.preload": "-4 N"}, r"^load.preload: -4 N is not allowed"),
        ({"load.prelod": "1 N"}, r"no number 'load.prelod'; did you mean 'load.preload'"),
        ({"materials.brass.density": "8500 kg/m^3"}, r"there is no material 'brass'"),
        ("load.preload=3 N", r"expected changes such as .* got 'load.preload=3 N'"),
    ],
)
def test_wrong_changes_are_refused(joint, changes, says):
    with pytest.raises(InputError, match=says):
        joint.with_values(changes)


def test_unknown_numbers_and_files_are_refused(joint, tmp_path):
    with pytest.raises(InputError, match=r"no number 'load.torque'"):
        joint["load.torque"]
    with pytest.raises(InputError, match=r"does not state 'bearings.sun_torque'; it states load.preload"):
        joint["bearings.sun_torque"]
    with pytest.raises(InputError, match=r"there is no such file; 'asperity init' writes an example"):
        asperity.load(tmp_path / "none.toml")


def test_a_joint_with_another_drive(zou_file):
    joint = asperity.load(zou_file.parent / "planetary.toml")
    assert "planetary.toml: 3 planets, interference 30 µm" in joint.summary
    changed = joint.with_values({"drive.planets": 4, "surface.sp.fractal_dimension": 1.45})
    assert changed["surface.sp.fractal_dimension"].value == 1.45
    assert changed["surface.pr.fractal_dimension"].value == 1.5
    assert joint["drive.planets"].value == 3.0
    assert any("shafts are rigid" in each for each in joint.assumptions)
    with pytest.raises(InputError, match=r"type planetary has no number 'drive.ring_radius'"):
        joint.with_values({"drive.ring_radius": "50 mm"})


def test_one_track_of_a_listed_drive_is_one_number(zou_file):
    joint = asperity.load(zou_file.parent / "planar.toml").with_values({"contact.1.second_radius": "13.6 mm"})
    assert [joint[f"contact.{place}_radius"].value for place in ("1.second", "2.first", "3.first")] == [
        13.6
    ] * 3


def test_choices_and_materials_are_words(joint):
    changed = joint.with_values({"model.traction_split": "springs", "bodies.sun": "440C"})
    case = changed.case
    assert (case.model.traction_split, case.bodies["sun"], case.bodies["ring"]) == (
        "springs",
        "440C",
        "steel",
    )
    assert changed.with_values({"load.preload": "1100 N"})["load.preload"].si == 1100.0
    lines = zip(joint.case.text.splitlines(), case.text.splitlines(), strict=True)
    replaced = [before for before, after in lines if before != after]  # all others with their comments
    assert [line.partition(" =")[0] for line in replaced] == ["traction_split", "sun"]


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"model.traction_split": "spring"}, "'spring' is not one of 'springs' or 'equal_coefficients'"),
        ({"bodies.sun": "440D"}, "there is no material '440D'"),
        ({"bodies.moon": "440C"}, "no number 'bodies.moon'"),
        ({"model.traction_split": 3}, "model.traction_split: expected a word, got 3"),
    ],
)
def test_words_that_cannot_be(joint, changes, message):
    with pytest.raises(InputError, match=message):
        joint.with_values(changes)
