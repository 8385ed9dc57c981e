"""What is said about the fit of parallel elements, checked by following the loop anew; play is refused."""

import re

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.export.elements import fitted_elements
from asperity.joint.play import Play


def test_stated_error_covers_the_exported_curves(content):
    fitted = fitted_elements(content, program="MuJoCo")
    curve = content.windup
    torque = np.asarray(curve.torque)
    forward = torque[torque > 0.0]
    path = np.concatenate([forward, torque[-2::-1], torque[1:]])
    angles = fitted.elements.angles(path, largest_angle=1e-3)
    loading, unloading, reloading = np.split(angles, [forward.size, forward.size + torque.size - 1])
    deviation = max(
        np.max(np.abs(loading - np.asarray(curve.angle)[torque > 0.0])),
        np.max(np.abs(unloading - np.asarray(curve.unloading_angle)[-2::-1])),
        np.max(np.abs(reloading - np.asarray(curve.reloading_angle)[1:])),
    )
    shares = [float(each) for each in re.findall(r"([0-9.e-]+) %", fitted.sentences[0])]
    assert deviation <= 1.05 * 0.01 * shares[0] * float(curve.angle[-1])
    assert deviation <= 1.05 * 0.01 * shares[1] * float(curve.hysteresis)
    assert shares[1] < 3.0


def test_a_curve_that_bends_more_than_its_loop_is_wide(made_content):
    """Both directions differ by far more than a cubic spring follows, and slip is small."""
    fitted = fitted_elements(made_content(skewness=0.15, slip=0.003), program="MuJoCo")
    times = float(re.search(r"([0-9.e+]+) times the width of its loop", fitted.sentences[0]).group(1))
    assert times > 1.0
    assert "an FMU follows both" in fitted.sentences[1]


def test_without_slip_nothing_is_said_about_a_loop(made_content):
    fitted = fitted_elements(made_content(slip=0.0), program="MuJoCo")
    assert fitted.elements.stiffness.size == 0
    assert "loop at zero torque" not in fitted.sentences[0]
    assert fitted.linear_stiffness == pytest.approx(3e4)


def test_play_is_refused(made_content):
    loose = made_content(play=Play(angle=1e-3, take_up_torque=0.0))
    with pytest.raises(
        InputError, match=r"play of 3.438 arcmin, in series .* springs of MuJoCo cannot carry it"
    ):
        fitted_elements(loose, program="MuJoCo")
