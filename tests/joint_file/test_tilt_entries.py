"""The section [tilt]: what is read and refused, that every type of drive has its axes, and that nothing else moves."""

import re

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint_file.assumptions import assumptions
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import replace_values, si_values, varied_keys
from asperity.joint_file.solved_document import solved_case
from asperity.joint_file.template import names_of_templates, template
from asperity.results.tilt_document import tilt_document


def case_of(tilts, name="wedge", change=lambda text: text):
    return parse_case(f"{change(template(name))}\n[tilt]\n{tilts}\n", source="tilted.toml")


@pytest.mark.parametrize(
    ("tilts", "message"),
    [
        ('planet_axis = { out = "1 mrad" }', "tilt.planet_axis: tilt of a floating body: no bearing holds its axis"),
        ('planet_axis = { out = "1 mrad" }', "state that of sun_axis, right_loading_roller_axis"),
        ('sunaxis = { out = "1 mrad" }', "tilt.sunaxis: the drive has no such axis; did you mean 'sun_axis'?"),
        ('housing = { out = "1 mrad" }', "the drive has no such axis; it has sun_axis, "),
        ("sun_axis = {}", 'tilt.sun_axis: out, across: one of both must be given, e.g. out = "1 mrad"'),
        ('sun_axis = { out = "1 mm" }', "tilt.sun_axis.out: expected an angle"),
        ('sun_axis = { across = "101 mrad" }', "it must be at least -100 mrad and at most 100 mrad"),
        ('sun_axis = { out = "1 mrad +- 0.1 mrad" }', "a tilt has no tolerance here, got '1 mrad +- 0.1 mrad'"),
        ('sun_axis = { up = "1 mrad" }', "tilt.sun_axis.up"),
    ],
)  # fmt: skip
def test_what_is_no_tilt_is_refused(tilts, message):
    with pytest.raises(InputError, match=re.escape(message)):
        case_of(tilts)


def test_a_floating_sun_and_pins_that_are_not_there_are_refused():
    def floating(text):
        return f'{text}\n[compliance]\nsun_support_stiffness = "0 N/m"\n'

    with pytest.raises(InputError, match=re.escape("tilt.sun_axis: tilt of a floating body")):
        case_of('sun_axis = { out = "1 mrad" }', "planetary", floating)
    with pytest.raises(InputError, match=re.escape("tilt.carrier_axis: the drive has no such axis")):
        case_of('carrier_axis = { out = "1 mrad" }', "wheel_pair")


def test_studies_refuse_it_by_name():
    case = case_of('sun_axis = { out = "1 mrad" }')
    assert not [path for path in varied_keys(case) if path.startswith("tilt")]
    with pytest.raises(
        InputError, match=re.escape("tilt.sun_axis.out: [tilt] is used by `asperity loads` only")
    ):
        replace_values(si_values(case), {"tilt.sun_axis.out": 2e-3})


def test_it_is_said_that_nothing_else_knows_of_it_and_nothing_does():
    case = case_of('sun_axis = { out = "1 mrad" }')
    straight = parse_case(template("wedge"), source="straight.toml")
    said = " ".join(assumptions(case, joint_from_case(case)))
    assert "[tilt] is used by `asperity loads` only" in said
    assert "[tilt]" not in " ".join(assumptions(straight, joint_from_case(straight)))
    one, other = (solved_case(each).result.rolling for each in (case, straight))
    assert float(one.drift_per_output_turn) == float(other.drift_per_output_turn)
    assert np.array_equal(one.normal, other.normal)


#: An axis of each type, and the contacts that its body has.
AXES = {
    "wedge": ("sun_axis", 1),
    "planetary": ("ring_axis", 1),
    "planetary_hollow": ("planet_axis", 2),
    "multiroller": ("sun_axis", 1),
    "stepped_planet": ("driven_ring_axis", 1),
    "planar": ("carrier_axis", 4),
    "wheel_pair": ("driven_axis", 1),
}


@pytest.mark.parametrize("name", names_of_templates())
def test_every_type_of_drive_has_tilted_contacts(name):
    axis, touched = AXES[name]
    solved = solved_case(case_of(f'{axis} = {{ out = "0.5 mrad", across = "0.1 mrad" }}', name))
    document = tilt_document(solved)
    assert document["unknown_because"] is None
    assert document["axes"] == {axis: {"out_rad": pytest.approx(5e-4), "across_rad": pytest.approx(1e-4)}}
    assert list(document["contacts"]) == list(solved.joint.contact_names)
    opened = [
        entry for entry in document["contacts"].values() if entry["in_any_direction"]["slope_rad"] > 1e-9
    ]
    assert len(opened) >= touched
    for entry in document["contacts"].values():
        stated, worst = entry["as_stated"], entry["in_any_direction"]
        assert worst["slope_rad"] >= stated["slope_rad"] * (1.0 - 1e-12)
        assert worst["peak_over_mean"] >= stated["peak_over_mean"] * (1.0 - 1e-9)
        assert 0.0 <= stated["sideways_over_friction"] < 1.0


def test_unlike_branches_have_the_contacts_of_every_branch():
    branches = "".join(f'[[branch]]\nplanet_deviation = "{size} um"\n' for size in (0, 0.5, -0.5))
    case = case_of(f'sun_axis = {{ out = "0.5 mrad" }}\n{branches}', "planetary")
    document = tilt_document(solved_case(case))
    assert list(document["contacts"]) == [f"{name}_{k}" for k in (1, 2, 3) for name in ("sp", "pr")]
    slopes = [document["contacts"][f"sp_{k}"]["as_stated"]["slope_rad"] for k in (1, 2, 3)]
    assert slopes == pytest.approx([0.5e-3, 0.25e-3, 0.25e-3])  # cos 0, 120, 240 degrees; planets on pins
    worst = [document["contacts"][f"sp_{k}"]["in_any_direction"]["slope_rad"] for k in (1, 2, 3)]
    assert worst == pytest.approx([0.5e-3] * 3)
