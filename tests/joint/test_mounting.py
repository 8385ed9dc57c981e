"""Rings pressed or slipped over their rollers, by hand."""

from pathlib import Path
from types import SimpleNamespace

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.joint.evaluation import assembled_joint
from asperity.joint.mounting import mounting
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case, read_case

EXAMPLES = Path(__file__).parents[2] / "examples"


def _assembled(normal, interference):
    return SimpleNamespace(
        rest=SimpleNamespace(normal=jnp.array(normal), interference=jnp.array(interference))
    )


def test_a_planetary_by_hand():
    """Three planets press the ring with 900 N each, mu 0.08; bearing steel expands by 12.6e-6 of 50 mm a kelvin."""
    joint = joint_from_case(read_case(EXAMPLES / "planetary.toml"))
    mounted = mounting(joint, _assembled([900.0, 900.0], [0.0, 30e-6]), 20e-6)
    names = [body.name for body in joint.drive.bodies]
    assert names == ["sun", "planet", "ring"]
    assert float(mounted.force[2]) == pytest.approx(3 * 0.08 * 900.0)
    assert float(mounted.heating[2]) == pytest.approx(50e-6 / (12.6e-6 * 0.05), rel=1e-3)
    assert float(mounted.cooling) == pytest.approx(50e-6 / (12.6e-6 * 0.05), rel=1e-3)  # sun and two planets
    assert np.isnan(mounted.force[:2]).all()
    assert np.isnan(mounted.heating[:2]).all()


def test_a_planet_that_is_too_large_counts_at_both_sides():
    """1 um of radius more at the sun and at the ring: it stands out by 2 um."""
    joint = joint_from_case(read_case(EXAMPLES / "planetary.toml"))
    mounted = mounting(joint, _assembled([900.0, 900.0], [1e-6, 31e-6]), 0.0)
    assert float(mounted.heating[2]) == pytest.approx(32e-6 / (12.6e-6 * 0.05), rel=1e-3)
    assert float(mounted.cooling) == pytest.approx(32e-6 / (12.6e-6 * 0.05), rel=1e-3)


def test_cooling_of_aluminium_planets_by_hand():
    """Sun of 10 mm of steel and a planet of 40 mm in diameter of aluminium, 23.6e-6 1/K."""
    text = (EXAMPLES / "planetary.toml").read_text(encoding="utf-8")
    case = parse_case(text.replace('planet = "52100"', 'planet = "6061-T6"'), source="a.toml")
    mounted = mounting(joint_from_case(case), _assembled([900.0, 900.0], [0.0, 30e-6]), 0.0)
    assert float(mounted.cooling) == pytest.approx(30e-6 / (12.6e-6 * 0.01 + 23.6e-6 * 0.04), rel=0.01)


@pytest.mark.programs("operations by JAX, one after the other")
def test_both_rings_of_a_stepped_drive_by_hand():
    """Rings of 50 and 48 mm, each with its own force and its own interference."""
    joint = joint_from_case(read_case(EXAMPLES / "stepped_planet.toml"))
    mounted = mounting(joint, _assembled([900.0, 500.0, 400.0], [0.0, 30e-6, 20e-6]), 0.0)
    rings = [index for index, shape in enumerate(joint.shapes) if shape.kind == "ring"]
    assert np.asarray(mounted.force)[rings] == pytest.approx([3 * 0.08 * 500.0, 3 * 0.08 * 400.0])
    by_hand = [30e-6 / (12.6e-6 * 0.05), 20e-6 / (12.6e-6 * 0.048)]
    assert np.asarray(mounted.heating)[rings] == pytest.approx(by_hand, rel=2e-3)


@pytest.mark.programs("operations by JAX, one after the other")
def test_a_material_without_expansion_has_no_temperatures():
    joint = joint_from_case(read_case(EXAMPLES / "zou2025.toml"))
    mounted = mounting(joint, _assembled([1000.0] * 5, [0.0, 0.0, 0.0, 1e-5, 1e-5]), 0.0)
    ring = [shape.kind for shape in joint.shapes].index("ring")
    assert float(mounted.force[ring]) == pytest.approx(
        3 * 2 * 0.12 * 1000.0
    )  # two loading rollers to a planet
    assert np.isnan(mounted.heating[ring])
    assert np.isnan(mounted.cooling)


@pytest.mark.long
def test_a_joint_that_works_warm_is_mounted_cold():
    text = (
        (EXAMPLES / "planetary.toml")
        .read_text(encoding="utf-8")
        .replace('planet = "52100"', 'planet = "6061-T6"')
    )
    warm = text.replace("[model]", '[temperature]\nassembly = "20 degC"\nworking = "60 degC"\n\n[model]', 1)
    cold, hot = (joint_from_case(parse_case(file, source="a.toml")) for file in (text, warm))
    rest = assembled_joint(cold).rest
    expected = float(3 * 0.08 * rest.normal[1])
    assert float(assembled_joint(hot).rest.normal[1]) > 1.1 * float(rest.normal[1])
    mounted = mounting(hot, SimpleNamespace(rest=assembled_joint(hot).rest), 0.0)
    assert float(mounted.force[2]) == pytest.approx(expected, rel=1e-6)
