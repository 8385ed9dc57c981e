"""A loading cam: its preload, and the angle that its work demands."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.layout.wedge_geometry import DriveGeometry, triangle
from asperity.drive.stiffness.loading_cam import cam_angle, cam_compliance, cam_preload, with_cam
from asperity.drive.stiffness.torsional_stiffness import Assembly, TorsionalStiffness
from asperity.zou2025.mechanism import rest_state

GEOMETRY = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.0, 0.0)
LEAST, CAM = 200.0, 150.0
SECANT, FALL = 1.29e-8, 6e-10  # of the interference at 1000 N, and by how much less per e-fold [m/N]


def interference(preload):
    return preload * (SECANT - FALL * jnp.log(preload / 1000.0))


def state(torque):
    preload = cam_preload(least_preload=LEAST, force_per_torque=CAM, output_torque=torque)
    rest = rest_state(geometry=GEOMETRY, sides=triangle(GEOMETRY), preload=preload)
    return {
        "branches": GEOMETRY.planet_count,
        "rest_force": rest.normal_force[3:],
        "preload": preload,
        "force_per_torque": CAM,
    }


def angle(torque):
    cam = state(torque)
    closed = interference(cam["preload"]) - interference(LEAST)
    return cam_angle(**cam, closed=closed[None])


@pytest.mark.slow
def test_the_torque_does_the_work_that_compresses_the_contacts():
    """Both works by quadrature: of the torque on the cam's angle, and of the ring force beyond its least one."""
    torque = np.linspace(0.0, 8.0, 4001)
    turned = np.array(jax.vmap(angle)(jnp.asarray(torque)))
    by_torque = np.trapezoid(torque, turned)
    preload = LEAST + CAM * torque
    alpha, theta = np.radians(13.9248), np.radians(27.0831)
    on_ring = 2.0 * np.cos(theta - alpha) / (2.0 * np.cos(theta))  # of both rollers, over the preload
    length = np.asarray(interference(jnp.asarray(preload)))
    by_force = 3.0 * np.trapezoid(on_ring * (preload - LEAST), length)
    assert by_torque == pytest.approx(by_force, rel=1e-5)


@pytest.mark.slow
@pytest.mark.parametrize("torque", [0.5, 5.0, -5.0])
def test_its_compliance_is_the_derivative_of_its_angle(torque):
    # the angle is without sign
    slope = float(jax.grad(angle)(torque)) * np.sign(torque)
    cam = state(torque)
    softness = (SECANT - FALL * (jnp.log(cam["preload"] / 1000.0) + 1.0))[None]
    assert float(cam_compliance(**cam, softness=softness)) == pytest.approx(slope, rel=1e-12)


def test_in_series_with_the_drive_all_shares_add_up():
    tangential, normal = jnp.full(5, 0.05), jnp.full(5, 0.1)
    held = Assembly(TorsionalStiffness(400.0, 32400.0), tangential, normal, *np.full(5, 0.05))
    found = with_cam(assembly=held, compliance=1e-4)
    assert float(found.stiffness.output) == pytest.approx(1.0 / (1.0 / 32400.0 + 1e-4))
    assert float(found.stiffness.input) == pytest.approx(float(found.stiffness.output) / 81.0)
    shares = [np.sum(getattr(found, name)) for name in vars(found) if name.endswith("_share")]
    assert sum(shares) == pytest.approx(1.0)
    assert float(found.loading_cam_share) == pytest.approx(1e-4 * float(found.stiffness.output))
    assert float(with_cam(assembly=held, compliance=0.0).loading_cam_share) == 0.0


def test_the_angle_of_a_cam_is_the_work_of_its_force_by_hand():
    """3 branches of 1 and 2 kN, closed by 1 and 2 um: 5 mJ each; a torque T presses with 100 T/m."""
    angle = cam_angle(
        branches=3.0,
        rest_force=np.array([1000.0, 2000.0]),
        preload=1000.0,
        force_per_torque=100.0,
        closed=np.array([1e-6, 2e-6]),
    )
    assert float(angle) == pytest.approx(3.0 * 5e-3 * 100.0 / 1000.0, rel=1e-14)
