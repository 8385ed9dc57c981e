"""Joints that several of these files look at, and branches that can be reckoned by hand."""

import math

import numpy as np
import pytest
from scipy.interpolate import PchipInterpolator, RectBivariateSpline

from asperity.joint import branches
from asperity.joint.branch_law import BranchLaw, BranchLaws
from asperity.joint.branch_sizes import BranchSizes
from asperity.joint.branches import BranchedJoint

PER_NEWTON, PER_ANGLE = 0.013, 3e4  # capacity over preload [m], stiffness of a branch [N·m/rad]
INTERFERENCE = 13e-6

MOMENTS = {"sun": 0.15, "carrier": 1.0, "ring": 0.85}  # over the torque


class FakeLaws(BranchLaws):
    """Branches that need no program."""

    def states(self, preload, torque):
        slip = np.where(preload > 0.0, torque / (PER_NEWTON * np.maximum(preload, 1e-9)), np.nan)
        pressure = np.where(preload > 0.0, np.sqrt(preload / 1000.0), np.nan)
        return {
            **{name: np.tile(slip, (5, 1)) for name in ("slip_ratio", "rolling_slip_ratio")},
            **{name: np.tile(pressure, (5, 1)) for name in ("pressure_over_first_yield", "shakedown_ratio")},
            "life_hours": np.where(preload > 0.0, 1.0 / np.maximum(preload, 1e-9), np.nan),
            **{
                f"{rolls}{kind}": np.zeros((5, 3))
                for rolls in ("", "rolling_")
                for kind in ("normal", "tangential")
            },
            **{f"{rolls}pins": np.zeros((2, 2, 3)) for rolls in ("", "rolling_")},
            "bearing_speed": np.zeros((4, 3)),
            **{
                f"{rolls}{name}_torque": share * torque
                for rolls in ("", "rolling_")
                for name, share in MOMENTS.items()
            },
            **{name: np.zeros((5, 3)) for name in ("creep", "skew", "hysteresis", "oil")},
            "contact": np.tile(0.01 * torque, (5, 1)),
            "compliance": 1.0 / (PER_ANGLE * np.where(preload > 0.0, preload, np.nan) / 1000.0),
            "bearings": np.zeros(3),
            **{name: np.full(3, 0.5) for name in ("speed_loss", "drift_per_output_turn", "output_speed")},
        }


def spring_law(rigid_in_preload, friction=0.0):
    """A linear spring that slips at a torque in proportion to its preload; stiffness alike, or as the preload.

    Its bearings take a force of the sun in proportion to the preload.
    """
    nodes = np.geomspace(10.0, 5000.0, 6)
    ends = np.append(0.0, nodes)
    even = np.linspace(0.0, 1.0, 6)
    over, size = np.meshgrid(even, np.log(nodes), indexing="ij")

    def table(values):
        return RectBivariateSpline(even, np.log(nodes), values)

    at_slip = (
        PER_NEWTON * ends / PER_ANGLE if rigid_in_preload else np.full(7, PER_NEWTON * 1000.0 / PER_ANGLE)
    )
    return BranchLaw(
        preloads=nodes,
        capacity=PchipInterpolator(ends, PER_NEWTON * ends),
        demand_at_slip=PchipInterpolator(ends, at_slip),
        used=table(over),
        normal=table(np.ones_like(size)),
        tangential=table(friction + 0.1 * over),
    )


@pytest.fixture
def springs(paper_joint, monkeypatch):
    """A drive of three such branches, whose preload is in proportion to the interference: 1000 N at 13 um."""

    def of(friction=0.0, **changes):
        both = spring_law(True, friction), spring_law(False, friction)
        laws = lambda joint, *, largest_preload: FakeLaws(*both, joint, 1.0)  # noqa: E731
        monkeypatch.setattr(branches, "branch_laws", laws)
        monkeypatch.setattr(branches, "joint_preload", lambda joint, length: 1000.0 * length / INTERFERENCE)
        return BranchedJoint(paper_joint(**changes), INTERFERENCE)

    return of


@pytest.fixture(scope="session")
def sizes():
    """Maker of sizes of three branches: deviations of planets and right rollers, and what holds the sun."""

    def of(planet, support=math.inf, right=(0.0, 0.0, 0.0)):
        return BranchSizes(np.asarray(planet), np.asarray(right), np.zeros(3), support)

    return of


@pytest.fixture(scope="session")
def wedged(zou_file):
    """A joint whose left ring contact unloads with the torque."""
    from asperity.joint_file.build import joint_from_case
    from asperity.joint_file.reader import read_case

    return joint_from_case(read_case(zou_file.with_name("tutorial_joint.toml")))
