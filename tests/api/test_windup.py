import inspect
from pathlib import Path

import numpy as np
import pytest

import asperity
from asperity.errors import InputError


@pytest.fixture(scope="module")
def curve(joint):
    return asperity.windup(joint, torque="4 N*m", stages=(0.25, 0.75))


@pytest.mark.slow
def test_values_are_those_of_the_command(curve, printed, zou_file):
    document = printed("windup", zou_file, "--torque", "4 N*m", "--stages", "0.25", "0.75")
    assert curve.document == document
    assert curve["standing_torque_capacity"].si == document["standing_torque_capacity"]["output_torque_Nm"]
    for name in ("windup", "hysteresis", "lost_motion"):
        assert curve[name].si == document[f"{name}_rad"]
        assert curve[name].value == pytest.approx(np.degrees(document[f"{name}_rad"]) * 60.0)
    assert curve["dissipated_energy"].value == document["dissipated_energy_J"]
    assert [curve[f"K{n}"].si for n in (1, 2, 3)] == [s["stiffness_Nm_per_rad"] for s in document["stages"]]


def test_stages_are_thirds_and_the_static_curve_holds_to_a_twentieth_unless_stated():
    stated = inspect.signature(asperity.windup).parameters
    assert stated["stages"].default == pytest.approx((1.0 / 3.0, 2.0 / 3.0), rel=1e-12)
    assert stated["creep_share"].default == 0.05


@pytest.mark.slow
def test_the_sun_turns(curve):
    found = curve.document["rolling"]
    assert curve["static_input_angle"].si == found["static_curve_up_to"]["input_rad"]
    assert curve["steady_output_angle"].value == pytest.approx(
        np.degrees(found["steady_creep_from"]["output_rad"])
    )
    assert curve["drift_per_output_turn"].si == found["drift_rad_per_output_turn"]
    frame = curve.rolling_frame()
    assert frame["angle_behind_rad"].iloc[0] == curve["windup"].si
    assert frame["drift_per_swing_rad"].iloc[0] == 0.0


@pytest.mark.long
def test_a_torque_beyond_rolling_has_no_drift():
    tutorial = asperity.load(Path(__file__).parents[2] / "examples" / "tutorial_joint.toml")
    found = asperity.windup(tutorial, torque="13.8 N*m")
    assert "drift_per_output_turn" not in found.keys()  # noqa: SIM118
    with pytest.raises(InputError, match="no steady rolling"):
        found.rolling_frame()


def test_frame_figure_and_text(curve):
    frame = curve.to_frame()
    assert frame["torque_Nm"].iloc[-1] == 4.0
    assert frame["loading_angle_rad"].iloc[-1] == curve["windup"].si
    assert [curve[f"K{n}"].si for n in (1, 2, 3)] == list(curve.curve.stage_stiffness)
    assert ", assembled" in curve.plot().get_suptitle()
    assert "largest torque of the curve" in repr(curve)


@pytest.mark.parametrize(
    ("options", "says"),
    [
        ({"torque": 4.0}, r"^torque: expected a torque with its unit .* bare number 4\.0"),
        ({"level": "full"}, "there is no level of the stiffness 'full'"),
        ({"torque": "400 N*m"}, "beyond the standing torque capacity"),
        ({"stages": (0.7, 0.3)}, "out of order"),
        ({"creep_share": -1.0}, "creep share -1 is not allowed"),
    ],
)
def test_wrong_options_are_refused(joint, options, says):
    with pytest.raises(InputError, match=says):
        asperity.windup(joint, **options)


def test_something_else_than_a_joint_is_refused():
    with pytest.raises(InputError, match=r"expected a joint, got 'joint.toml'; asperity.load"):
        asperity.windup("joint.toml")


def test_unknown_figure_is_refused(curve):
    with pytest.raises(InputError, match="no figure of a wind-up 'K4'"):
        curve["K4"]
