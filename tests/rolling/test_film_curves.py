"""Film and asperities over speed: one curve for each temperature, and no influence of the other points."""

from pathlib import Path

import numpy as np
import pytest

from asperity.engine.control import at_once
from asperity.joint.evaluation import assembled_joint
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import read_case
from asperity.rolling.film_curves import film_curves

OIL = Path(__file__).parents[2] / "examples" / "oil.toml"


@pytest.fixture(scope="module")
def given():
    joint = joint_from_case(read_case(OIL))
    return {"joint": joint, "without_torque": at_once(assembled_joint, joint)}


def test_every_point_is_by_itself(given):
    speed = np.array([20.0, 0.5, 100.0])
    told = []
    both = film_curves(
        **given,
        input_speed=speed,
        temperatures=(293.15, 313.15),
        report=lambda *done: told.append(done),
    )
    assert told == [(1, 2), (2, 2)]
    (alone,) = film_curves(**given, input_speed=speed[1:2], temperatures=(313.15,))
    for name in ("central_film", "minimum_film", "asperity_share", "traction_capacity", "creepage"):
        assert getattr(both[1], name).shape == (2, 3)
        np.testing.assert_allclose(getattr(both[1], name)[:, 1:2], getattr(alone, name), rtol=1e-10)


def test_nothing_turns(given):
    (curves,) = film_curves(**given, input_speed=np.zeros(1), temperatures=(313.15,))
    assert curves.rolls.all()
    for values in (curves.central_film, curves.minimum_film, curves.asperity_share, curves.efficiency):
        assert np.isnan(values).all()
    # drift is per turn: slow rolling, with the friction of the boundary
    assert np.isfinite(curves.drift_per_output_turn).all()
