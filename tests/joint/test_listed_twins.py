"""Drives of every type against the same drives listed roller by roller: one answer, over random drives and torques."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.joint.solve import solution_of
from asperity.joint.torque_limits import TorqueCapacity
from asperity.joint_file.build import joint_from_values
from asperity.joint_file.part_names import TRACKS, WEDGE_TYPE, material_key, type_of
from asperity.joint_file.si_tables import si_values

#: Torques over that of the example, of both senses.
LOADS = (0.05, -0.2, 0.4, -0.5, 0.6, -0.6)
#: Keys of [bearings] that the paper's drive calls otherwise.
BEARINGS = {
    "sun_torque": "input_torque",
    "loading_roller_torque": "roller_torque",
    "carrier_torque": "output_torque",
}


def listed(values):
    """Tables of the same drive, roller by roller; of one that turns clockwise, its mirror image."""
    kind, drive = type_of(values), joint_from_values(values).drive
    sizes, pins = values["drive"], list(drive.pinned)
    rollers = {}
    for number, (body, (x, y)) in enumerate(zip(drive.bodies, drive.centres, strict=True)):
        roller = {"name": body.name, "place": body.place}
        track = material_key(kind, body.name)
        roller |= {
            key: sizes[f"{track}_{key}"] for key in ("bore_diameter", "length") if f"{track}_{key}" in sizes
        }
        if body.place != "axis":
            roller |= {"orbit": jnp.hypot(x, y), "angle": jnp.arctan2(y, drive.sense * x)}
        if body.place == "pin":
            roller["push_angle"] = drive.sense * drive.push_angles[pins.index(number)]
            if body.name in drive.closure.constant_pins:
                roller["pin_force"] = "constant"
        if body.name in ("ring", "held_ring"):
            roller |= {"wall_thickness": sizes["ring_wall_thickness"], "ring_support": sizes["ring_support"]}
        if body.name == "driven_ring":
            roller |= {"wall_thickness": sizes["driven_ring_wall_thickness"], "ring_support": "free"}
        rollers[str(number + 1)] = roller
    same = {other: one for one, other in drive.closure.equal_coefficients}
    contacts = {}
    for k, contact in enumerate(drive.contacts):
        tracks = {side: contact.tracks[place] for place, side in enumerate(("first", "second"))}
        entry = {
            "name": contact.name,
            "first": contact.first,
            "second": contact.second,
            "first_radius": drive.first_radius[k],
            "second_radius": drive.second_radius[k],
            "internal": "yes" if contact.internal else "",
            "sector": str(contact.sector),
            "tracks": tracks,
        }
        for side, track in zip(("first", "second"), TRACKS[kind][contact.name], strict=True):
            if f"{track}_crown_radius" in sizes:
                entry[f"{side}_crown_radius"] = sizes[f"{track}_crown_radius"]
        if contact.name in same:
            entry["same_coefficient_as"] = same[contact.name]
        contacts[str(k + 1)] = entry
    others = {name: table for name, table in values.items() if name not in ("drive", "bodies", "bearings")}
    if "bearings" in values:
        others["bearings"] = {BEARINGS.get(key, key): value for key, value in values["bearings"].items()}
    return others | {
        "type": "planar",
        "drive": {
            "sectors": drive.sectors,
            "input": drive.input,
            "output": drive.output,
            "grounded": drive.grounded,
            "contact_length": sizes["contact_length"],
        },
        "roller": rollers,
        "contact": contacts,
        "bodies": {body.name: values["bodies"][material_key(kind, body.name)] for body in drive.bodies},
    }


def answers(values):
    """What a joint does: numbers by name."""
    joint = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), joint_from_values(values))
    solution = solution_of(joint)
    result = solution.result
    levels = (result.published, result.series_with_bulk, result.assembly.stiffness)
    return {
        "without torque": result.rest.normal,
        "normal": result.forces.normal,
        "tangential": result.forces.tangential,
        "pins": np.abs(result.forces.pins),
        "slip": result.diagnostics.slip_ratio,
        "input torque": result.forces.input_torque,
        "stiffness": np.stack([level.output for level in levels]),
        "capacities": np.stack(
            [
                each.output_torque
                for each in jax.tree.leaves(solution, is_leaf=lambda node: isinstance(node, TorqueCapacity))
                if isinstance(each, TorqueCapacity)
            ]
        ),
        "rolling normal": result.rolling.normal,
        "rolling tangential": result.rolling.tangential,
        "creepage": result.rolling.creepage,
        "drift": result.rolling.drift_per_output_turn,
        "efficiency": result.rolling.power.efficiency,
        "losses": result.rolling.power.contact,
        "life": result.rolling.life_hours.drive,
        "speed of the output": np.abs(result.output_speed),
    }


@pytest.fixture
def tables(planar_case):
    """Maker of the tables of an example with a free ring, skew, bearings, crowns and pins that press in their bores."""

    def made(name, *, crowned):
        values = si_values(planar_case(name))
        drive, pins = values["drive"], [f"{key}_torque" for key in ("input", "roller", "output")]
        drive["ring_support"] = "free"
        if crowned:
            drive |= {
                f"{track}_crown_radius": 5.0 for pair in TRACKS[type_of(values)].values() for track in pair
            }
        if type_of(values) == WEDGE_TYPE:
            pins = list(BEARINGS)
            drive |= {"left_push_angle": 0.1, "right_push_angle": -0.05}
            values["model"] |= {"traction_split": "springs"}
            values["model"].pop("closure_springs")
        values["bearings"] = dict.fromkeys(pins, 1e-3) | {
            "pin_friction_coefficient": 0.002,
            "pin_diameter": 3e-3,
        }
        values["rolling"] = {"skew": 1e-4}
        values["compliance"] = {"pin_stiffness": 1e8, "input_shaft_stiffness": 500.0}
        return values

    return made


def drawn(values, torque, random):
    """The tables with numbers around their own, under a torque."""
    spreads = {
        "load.interference": 0.1,
        "load.preload": 0.1,
        "load.friction_coefficient": 0.1,
        "load.sun_speed": 0.5,
        "drive.contact_length": 0.1,
        "drive.ring_wall_thickness": 0.1,
        "drive.planet_radius": 0.01,
        "bearings.pin_friction_coefficient": 0.5,
        "rolling.skew": 1.0,
    }
    tables = {name: dict(table) if isinstance(table, dict) else table for name, table in values.items()}
    for path, spread in spreads.items():
        section, key = path.split(".")
        if key in tables.get(section, {}):
            tables[section][key] = tables[section][key] * (1.0 + spread * random.uniform(-1.0, 1.0))
    tables["load"]["output_torque"] = torque
    return tables


CASES = [
    ("planetary", False),
    pytest.param("zou2025", True, marks=pytest.mark.slow),
    pytest.param("multiroller", False, marks=pytest.mark.slow),
    pytest.param("stepped_planet", False, marks=pytest.mark.slow),
]


@pytest.mark.parametrize(("name", "crowned"), CASES)
def test_a_drive_and_its_listed_twin_give_one_answer(tables, name, crowned):
    values, random = tables(name, crowned=crowned), np.random.default_rng(25)
    for share in LOADS:
        draw = drawn(values, share * values["load"]["output_torque"], random)
        one, other = answers(draw), answers(listed(draw))
        assert np.all(one["slip"] < 1.0)
        for what, value in one.items():
            size = np.max(np.abs(np.nan_to_num(value)))
            np.testing.assert_allclose(other[what], value, rtol=1e-6, atol=1e-8 * size, err_msg=what)


def test_a_listed_roller_may_have_any_name(planar_case):
    """Also one that the paper's drive has."""
    listed_as = planar_case(
        "planar", replaced={'"right"': '"right_loading_roller"', "right = ": "right_loading_roller = "}
    )
    names = [body.name for body in joint_from_values(si_values(listed_as)).drive.bodies]
    assert "right_loading_roller" in names
