import numpy as np
import pytest

import asperity
from asperity.errors import InputError

TRUE_PRELOAD = 1250.0


@pytest.fixture(scope="module")
def curve(joint, tmp_path_factory):
    """First loading of the joint with another preload, from its wind-up, without errors."""
    loaded = asperity.windup(joint.with_values({"load.preload": f"{TRUE_PRELOAD} N"}), torque="8 N*m").curve
    # the other half is the first loading in the other direction, which no history of loads joins to this one
    loading = np.asarray(loaded.torque) >= 0.0
    torque, angle = np.asarray(loaded.torque)[loading][::4], np.asarray(loaded.angle)[loading][::4]
    file = tmp_path_factory.mktemp("data") / "curve.csv"
    rows = "".join(f"{t!r},{1e3 * a!r}\n" for t, a in zip(torque.tolist(), angle.tolist(), strict=True))
    file.write_text("torque [N*m],angle [mrad]\n" + rows)
    return file


@pytest.fixture(scope="module")
def found(joint, curve):
    return asperity.calibrate(joint, curve, ["load.preload"], starts=1)


@pytest.mark.slow
def test_values_are_those_of_the_command(found, curve, printed, zou_file):
    document = printed("calibrate", zou_file, curve, "-u", "load.preload", "--starts", "1")
    (estimate,) = document["estimates"]
    assert found["load.preload"].si == pytest.approx(estimate["value"], rel=1e-12)
    row = found.to_frame().loc["load.preload"]
    assert [row.lower, row.upper, row.unit] == [
        pytest.approx(estimate["lower"], rel=1e-9),
        pytest.approx(estimate["upper"], rel=1e-9),
        "N",
    ]


@pytest.mark.slow
def test_the_preload_is_recovered(found):
    row = found.to_frame().loc["load.preload"]
    assert row.value == pytest.approx(TRUE_PRELOAD, rel=1e-6)
    assert row.lower < TRUE_PRELOAD < row.upper  # by the error of the model
    assert found.joint["load.preload"].si == pytest.approx(found["load.preload"].si, rel=1e-15)
    assert found.start["load.preload"].si == 1000.0


@pytest.mark.slow
def test_text_and_figure(found):
    text = repr(found)
    assert "1 unknown from" in text
    assert "residual:" in text
    assert found.plot().axes


@pytest.mark.slow
def test_a_bound_is_no_value(joint, curve):
    """The curve has 1250 N; bounds up to 1100 N leave that out."""
    found = asperity.calibrate(joint, curve, ["load.preload=500 N:1100 N"], starts=1)
    with pytest.raises(
        InputError, match=r"load\.preload ended at its upper bound, 1100 N: this is no fitted value"
    ):
        found["load.preload"]
    row = found.to_frame().loc["load.preload"]
    assert np.isnan([row.value, row.lower, row.upper]).all()
    assert (row.bound, row.determined) == (pytest.approx(1100.0), False)
    assert "at its upper bound, 1100 N" in repr(found)


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"unknowns": "load.preload"}, r"the unknowns are a list, e.g. \['load.preload'\]"),
        ({"history": "used"}, "there is no history 'used'; known are virgin, cycled"),
        ({"level": "full"}, "there is no level of the stiffness 'full'"),
        ({"data": "none.csv"}, "none.csv"),
    ],
)
def test_wrong_input_is_refused(joint, curve, changes, says):
    with pytest.raises(InputError, match=says):
        asperity.calibrate(joint, **({"data": curve, "unknowns": ["load.preload"]} | changes))
