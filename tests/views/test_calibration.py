"""What a calibration found, as it is shown: intervals keep their width, bounds are no values."""

import dataclasses
import math

import numpy as np
import pytest
from shown_blocks import amount, cells, sentences, tables

import asperity
from asperity.units import format_quantity
from asperity.views.calibration import calibration, interval_digits, quantiles


@pytest.mark.parametrize(
    ("lower", "upper"), [(999.93, 1000.37), (1509.29, 1509.31), (-0.0536, -0.0486), (3.0, 3.0)]
)
def test_printed_intervals_keep_their_width(lower, upper):
    digits = interval_digits(lower, upper)
    shown = [float(format_quantity(each, "1", digits)) for each in (lower, upper)]
    assert shown[1] - shown[0] == pytest.approx(upper - lower, rel=0.1)


def test_intervals_without_a_width_have_four_digits():
    assert interval_digits(1.0, float("nan")) == interval_digits(0.0, 0.0) == 4
    assert interval_digits(1.0, 1.0 + 1e-14) == 15


def test_quantiles_by_their_shares():
    assert quantiles(np.linspace(0.0, 1.0, 1001)) == {
        "0.025": pytest.approx(0.025),
        "0.5": pytest.approx(0.5),
        "0.975": pytest.approx(0.975),
    }


@pytest.fixture(scope="module")
def found(zou_file, tmp_path_factory):
    """The paper's joint from its own first loading with a preload of 1250 N, without any errors.

    Only this half of ``angle`` is a history of loads: the other half is the first loading in the other direction.
    """
    joint = asperity.load(zou_file)
    curve = asperity.windup(joint.with_values({"load.preload": "1250 N"}), torque="8 N*m").curve
    loading = np.asarray(curve.torque) >= 0.0
    torque, angle = np.asarray(curve.torque)[loading][::4], np.asarray(curve.angle)[loading][::4]
    file = tmp_path_factory.mktemp("data") / "curve.csv"
    rows = "".join(f"{t!r},{1e3 * a!r}\n" for t, a in zip(torque.tolist(), angle.tolist(), strict=True))
    file.write_text("torque [N*m],angle [mrad]\n" + rows)
    return asperity.calibrate(joint, file, ["load.preload"], starts=1).calibration


@pytest.mark.slow
def test_estimates_with_their_intervals(found):
    """Data without errors give the preload itself; the interval is the model's error, alike in ratio to both sides."""
    blocks = list(calibration(found))
    (table,) = tables(blocks).values()
    value, low, high, scatter_low, scatter_high, _ = cells(table)["load.preload"]
    assert [cell.split()[1] for cell in (value, low, high, scatter_low, scatter_high)] == ["N"] * 5
    preload, *ends = (amount(cell) for cell in (value, scatter_low, scatter_high, low, high))
    assert preload == pytest.approx(1250.0, rel=1e-6)
    assert ends[0] <= preload <= ends[1]
    assert ends[2] < 0.9 * preload
    assert ends[3] > 1.1 * preload
    # preloads are searched by their logarithm
    assert math.sqrt(ends[2] * ends[3]) == pytest.approx(preload, rel=1e-4)
    assert any("an error of the model: 5 % of the joint's compliance" in text for text in sentences(blocks))


@pytest.mark.slow
def test_an_unknown_at_its_bound_has_no_value(found):
    (estimate,) = found.estimates
    cut = dataclasses.replace(estimate, at_bound="upper", determined=False)
    blocks = list(calibration(dataclasses.replace(found, estimates=(cut,))))
    (table,) = tables(blocks).values()
    assert cells(table)["load.preload"][:5] == ("–",) * 5
