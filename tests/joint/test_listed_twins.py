"""Drives of every type against the same drives listed roller by roller: one answer, over random drives and torques."""

import dataclasses

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.engine.arrays import as_numbers
from asperity.joint.solve import solution_of
from asperity.joint.torque_limits import TorqueCapacity
from asperity.joint_file.build import joint_from_values
from asperity.joint_file.own_branches import joint_with_branches
from asperity.joint_file.part_names import drive_type_of
from asperity.joint_file.si_tables import si_values
from asperity.results.document import joint_document
from asperity.results.solved import solved_with_capacities
from asperity.standing.windup import windup

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
    kind, drive = drive_type_of(values), joint_from_values(values).drive
    sizes, pins = values["drive"], list(drive.pinned)
    rollers = {}
    for number, (body, (x, y)) in enumerate(zip(drive.bodies, drive.centres, strict=True)):
        roller = {"name": body.name, "place": body.place}
        track = kind.material_key(body.name)
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
        for side, track in zip(("first", "second"), contact.tracks, strict=True):
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
        "bodies": {body.name: values["bodies"][kind.material_key(body.name)] for body in drive.bodies},
    }


def joint_of(values):
    """The joint of a file, every branch by itself where it states them."""
    return as_numbers(joint_with_branches(values))


def answers(joint):
    """What a joint does: numbers by name."""
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
                f"{track}_crown_radius": 5.0
                for contact in drive_type_of(values).contacts
                for track in drive_type_of(values).tracks(contact)
            }
        if drive_type_of(values).name == "wedge":
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


def numbers_of_joint(joint, sense):
    """All numbers of a joint by their place, those of a drive that turns clockwise mirrored."""
    drive = joint.drive
    mirrored = dataclasses.replace(
        drive,
        centres=np.asarray(drive.centres) * np.array([sense, 1.0]),
        push_angles=sense * np.asarray(drive.push_angles),
        motion=None,
    )
    found, _ = jax.tree.flatten_with_path(dataclasses.replace(joint, drive=mirrored))
    return {jax.tree_util.keystr(path): np.asarray(value, dtype=float) for path, value in found}


def words_of_joint(joint):
    """All choices of a joint by name, and what its drive is made of."""
    drive = joint.drive
    names = [field.name for field in dataclasses.fields(joint) if field.metadata.get("static")]
    choices = {name: getattr(joint, name) for name in names if name != "type"}
    return choices | {
        "bodies": [(body.name, body.place) for body in drive.bodies],
        "contacts": [
            (each.name, each.first, each.second, each.internal, each.sector) for each in drive.contacts
        ],
        "ends": (drive.input, drive.output, drive.grounded),
        "closure": drive.closure,
        "shapes": [(shape.kind, shape.support) for shape in joint.shapes],
    }


#: Tables in the place of those of each example, in SI units.
FEATURES = {
    "held ring at a temperature, crowns, skew, oil": {
        "drive": {"ring_support": "rigid_housing"},
        "temperature": {"assembly": 20.0, "working": 45.0, "housing_expansion": 23.6e-6},
        "load": {"interference": 3e-5},
        "rolling": {"skew": 2e-4, "hysteresis_factor": 0.01},
        "lubrication": {"viscosity": 0.05, "pressure_coefficient": 2e-8},
    },
    "elastic housing, cam, hollow rollers, pins that bend, backwards": {
        "drive": {"ring_support": "elastic_housing"},
        "compliance": {"ring_housing_stiffness": 4e11, "pin_stiffness": 1e8},
        "load": {"cam_force_per_torque": 40.0, "interference": 3e-5, "sun_speed": -50.0},
        "bearings": {"pin_diameter": 3e-3, "pin_length": 20e-3, "pin_support": "both_ends"},
    },
    "thin free ring, planets and pins held": {
        "drive": {"ring_support": "free", "ring_wall_thickness": 4e-3},
        "compliance": {
            "planet_support_stiffness": 2e7,
            "pin_transverse_stiffness": 3e7,
            "ring_bending_stiffness": 4e8,
            "output_shaft_stiffness": 5e4,
        },
    },
    "thick free ring, cam on a preload, springs": {
        "drive": {"ring_support": "free", "ring_wall_thickness": 60e-3},
        "load": {"cam_force_per_torque": 40.0, "preload": 800.0},
        "model": {"bodies": "springs", "closure_springs": "bulk_and_asperities"},
    },
}
#: Bores of hollow rollers [m], and a key that has no effect, and is refused, where all rollers are on pins.
BORES = {
    "planetary": {"planet_bore_diameter": 20e-3},
    "stepped_planet": {"planet_bore_diameter": 15e-3},
    "multiroller": {"first_row_bore_diameter": 8e-3, "second_row_bore_diameter": 7e-3},
    "zou2025": {"loading_roller_bore_diameter": 4e-3},
}
ALL_ON_PINS, WITHOUT_PINS = ("planetary", "stepped_planet"), "planet_support_stiffness"


@pytest.mark.parametrize("features", FEATURES)
@pytest.mark.parametrize("name", BORES)
@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_a_drive_and_its_listed_twin_are_one_joint(planar_case, name, features):
    """The same numbers and choices, of which all that is computed follows."""
    values = si_values(planar_case(name))
    for material in values.get("materials", {}).values():
        material["thermal_expansion"] = 11.5e-6
    for section, table in FEATURES[features].items():
        values[section] = values.get(section, {}) | table
    values["load"].pop("interference" if "preload" in FEATURES[features].get("load", {}) else "preload", None)
    values["load"] |= {} if "preload" in values["load"] else {"interference": 3e-5}
    if name in ALL_ON_PINS:
        values.get("compliance", {}).pop(WITHOUT_PINS, None)
    if "hollow" in features:
        values["drive"] |= BORES[name]
    if "crowns" in features:
        tracks = dict.fromkeys(
            track
            for contact in drive_type_of(values).contacts
            for track in drive_type_of(values).tracks(contact)
        )
        values["drive"] |= {f"{track}_crown_radius": 1.0 + place for place, track in enumerate(tracks)}
    one, other = joint_of(values), joint_of(listed(values))
    assert words_of_joint(one) == words_of_joint(other)
    numbers, others = (numbers_of_joint(joint, joint.drive.sense) for joint in (one, other))
    assert numbers.keys() == others.keys()
    for place, number in numbers.items():
        np.testing.assert_allclose(others[place], number, rtol=1e-9, atol=1e-13, err_msg=place)


CASES = [
    pytest.param("planetary", False, marks=pytest.mark.slow),
    pytest.param("zou2025", True, marks=pytest.mark.long),
    pytest.param("multiroller", False, marks=pytest.mark.long),
    pytest.param("stepped_planet", False, marks=pytest.mark.long),
]


@pytest.mark.parametrize(("name", "crowned"), CASES)
def test_a_drive_and_its_listed_twin_give_one_answer(tables, name, crowned):
    values, random = tables(name, crowned=crowned), np.random.default_rng(25)
    for share in LOADS:
        draw = drawn(values, share * values["load"]["output_torque"], random)
        one, other = answers(joint_of(draw)), answers(joint_of(listed(draw)))
        assert np.all(one["slip"] < 1.0)
        assert_alike(one, other)


def assert_alike(one, other):
    """Numbers by name of both."""
    for what, value in one.items():
        size = np.max(np.abs(np.nan_to_num(value)))
        np.testing.assert_allclose(other[what], value, rtol=1e-6, atol=1e-8 * size, err_msg=what)


@pytest.mark.long
@pytest.mark.parametrize(
    ("name", "preload", "torques"),
    [  # the paper's drive beyond its first slip too
        ("zou2025", 1000.0, (0.5, 10.0)),
        ("zou2025", 1300.0, (5.0, 13.0)),
        ("planetary", None, (0.5, 8.0)),
        ("multiroller", None, (0.1, 0.6)),
        ("stepped_planet", None, (0.5, 8.0)),
    ],
)
def test_a_drive_and_its_listed_twin_wind_up_alike(tables, name, preload, torques):
    """Both directions, the loop with its energy, the lost motion with play, and the stages."""
    values, random = tables(name, crowned=False), np.random.default_rng(26)
    values["play"] = {"angle": 1e-4, "take_up_torque": 0.3}
    if preload is not None:
        values["load"]["preload"] = preload
    for torque in torques:
        draw = drawn(values, torque, random)
        one, other = (
            dataclasses.asdict(windup(joint_of(each), largest_torque=torque, level="assembly"))
            for each in (draw, listed(draw))
        )
        assert one["hysteresis"] > 0.0
        assert_alike(one, other)


def numbers_of(document, path=""):
    """All numbers of a document, those of entries with names under these."""
    if isinstance(document, dict):
        for key, value in document.items():
            yield from numbers_of(value, f"{path}.{key}")
    elif isinstance(document, list | tuple):
        for place, value in enumerate(document):
            named = value.get("name", place) if isinstance(value, dict) else place
            contact = value.get("contact") if isinstance(value, dict) else None
            yield from numbers_of(value, f"{path}.{named}" + (f".{contact}" if contact else ""))
    elif document is not None and not isinstance(document, str | bool):
        yield path, float(document)


@pytest.mark.long
@pytest.mark.parametrize(
    ("name", "torque"),
    [("zou2025", -9.0), ("planetary", 8.0), ("multiroller", -0.5), ("stepped_planet", 6.0)],
)
def test_documents_of_a_drive_and_its_listed_twin_have_the_same_numbers(tables, name, torque):
    """All that ``asperity roll --json`` prints: states, contacts, losses, lives, limits, margins and capacities."""
    draw = drawn(tables(name, crowned=False), torque, np.random.default_rng(27))
    joints = joint_of(draw), joint_of(listed(draw))
    one, other = (
        dict(
            numbers_of(
                joint_document(solved_with_capacities(each, solution_of(each)), inputs={}, assumptions=())
            )
        )
        for each in joints
    )
    assert one.keys() == other.keys()
    assert len(one) > 200
    for path, value in one.items():
        if "residual" in path:  # rounding errors of two searches
            assert max(abs(value), abs(other[path])) <= 1e-9, path
        elif path.startswith(
            ".geometry.centres_m."
        ):  # the twin of a drive that turns clockwise is its mirror image
            assert other[path] == pytest.approx(
                joints[0].drive.sense * value if path.endswith(".0") else value, abs=1e-15
            )
        else:
            assert other[path] == pytest.approx(value, rel=1e-6, abs=1e-12, nan_ok=True), path


@pytest.mark.long
@pytest.mark.parametrize(
    ("name", "torque", "sizes"),
    [
        (
            "zou2025",
            -6.0,
            ({"planet": 2e-6, "right_roller": -5e-7}, {"left_roller": 1e-6}, {"planet": -1e-6}),
        ),
        ("planetary", 6.0, ({"planet": 2e-6}, {}, {"planet": -1e-6})),
    ],
)
def test_unlike_branches_of_a_drive_and_of_its_listed_twin_do_alike(tables, name, torque, sizes):
    """Rolling and wind-up; of the mirror image of a drive that turns clockwise, the branches stand in reverse order."""
    draw = drawn(tables(name, crowned=False), torque, np.random.default_rng(28))
    if "preload" in draw["load"]:
        draw["load"].pop("preload")
        draw["load"]["interference"] = 13e-6
    sense = joint_from_values(draw).drive.sense
    order = [sense * k % len(sizes) for k in range(len(sizes))]
    branches = {
        str(number): {f"{track}_deviation": size for track, size in each.items()}
        for number, each in enumerate(sizes, start=1)
    }
    rollers = {"right_roller": "right_loading_roller", "left_roller": "left_loading_roller"}
    reversed_branches = {
        str(number): {"deviation": {rollers.get(track, track): size for track, size in sizes[k].items()}}
        for number, k in enumerate(order, start=1)
    }
    joints = joint_of(draw | {"branch": branches}), joint_of(listed(draw) | {"branch": reversed_branches})
    one, other = (answers(joint) for joint in joints)
    for what, value in one.items():
        if value.ndim and value.size % len(sizes) == 0 and what not in ("stiffness", "capacities"):
            one[what] = value.reshape(len(sizes), -1)[order].ravel()
    assert len(set(np.round(one["normal"], 3))) == one["normal"].size
    assert_alike(one, other)
    curves = [
        dataclasses.asdict(windup(joint, largest_torque=abs(torque), level="assembly")) for joint in joints
    ]
    assert_alike(*curves)


def test_a_listed_roller_may_have_any_name(planar_case):
    """Also one that the paper's drive has."""
    listed_as = planar_case(
        "planar", replaced={'"right"': '"right_loading_roller"', "right = ": "right_loading_roller = "}
    )
    names = [body.name for body in joint_from_values(si_values(listed_as)).drive.bodies]
    assert "right_loading_roller" in names
