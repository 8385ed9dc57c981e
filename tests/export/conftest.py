"""A joint whose compliance is a polynomial in the torque: every curve is known in closed form."""

import types

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.export.content import ExportContent, MovingParts, export_content
from asperity.joint.play import NO_PLAY
from asperity.standing.standing import BothSenses
from asperity.standing.windup import windup_of

LARGEST = 5.0  # N·m
BASE = 1.0 / 3e4  # compliance at rest [rad/(N·m)]
SLIP = 2e-3  # compliance of slip over that at rest, at 1 N·m; grows with the square of the torque
DRIFT = 3e-3  # rad per turn at 1 N·m


def slip_angle(torque):
    """Angle lost to slip on first loading."""
    return BASE * SLIP * torque**3 / 3.0


def reversible_angle(torque, skewness=0.0):
    """The rest: a line, and a share that differs in the two directions."""
    return BASE * (torque + 0.5 * skewness * torque**2)


@pytest.fixture(scope="session")
def closed_form():
    """Angles of the joint by hand."""
    return types.SimpleNamespace(
        LARGEST=LARGEST, DRIFT=DRIFT, slip_angle=slip_angle, reversible_angle=reversible_angle
    )


@pytest.fixture(scope="session")
def made_content(paper_joint):
    """Maker of what is exported, without solving any joint."""

    def make(skewness=0.0, play=NO_PLAY, largest=LARGEST, slip=1.0, **changes):
        joint = paper_joint(play=play, **changes)

        def compliances(torque):
            elastic = BASE * (1.0 + skewness * torque)
            return elastic + slip * BASE * SLIP * torque**2, elastic

        windup = windup_of(compliances, largest_torque=largest, stage_shares=(0.3, 0.6), play=play)
        torque = windup.torque
        stiffness = 1.0 / compliances(torque)[0]
        drift = DRIFT * (torque + 0.1 * torque * jnp.abs(torque))
        curves = BothSenses(
            torque,
            100.0 * stiffness,
            10.0 * stiffness,
            stiffness,
            jnp.abs(torque) / 13.0,
            drift,
            0.9 * drift,
            0.98 + 0.0 * torque,
        )
        parts = MovingParts(input=2e-6, output=0.05, loss_factor=0.02, coupled=True, friction=0.01)
        return ExportContent("made.toml", joint, "assembly", windup, curves, parts, ())

    return make


@pytest.fixture(scope="session")
def content(made_content):
    return made_content()


@pytest.fixture(scope="session")
def read_table():
    """Numbers and names of a CSV file with comments."""

    def read(data: bytes):
        lines = [line for line in data.decode("ascii").splitlines() if not line.startswith("#")]
        rows = np.array([[float(cell) for cell in line.split(",")] for line in lines[1:]])
        return dict(zip(lines[0].split(","), rows.T, strict=True))

    return read


@pytest.fixture(scope="session")
def papers_content(paper_joint):
    """What is exported of the paper's joint up to 10 N·m, by its closure; solved, which takes its time."""

    def solved(closure):
        joint = paper_joint(closure=closure, output_torque=10.0)
        return export_content(joint, inertias=None, source="j.toml", largest_torque=None, level="assembly")

    return {closure: solved(closure) for closure in ("elastic", "constant_pin_force")}
