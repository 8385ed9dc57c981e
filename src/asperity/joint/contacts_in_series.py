"""What the creep of each contact adds to the angle that a joint loses, for every drive."""

from __future__ import annotations

import equinox as eqx
import jax.numpy as jnp
from jax import Array

from asperity.drive.geometry import DriveGeometry
from asperity.drive.planar.creeping import creeping_speeds
from asperity.drive.planar.layout import PlanarDrive
from asperity.drive.rolling_speeds import rolling_speeds
from asperity.drive.rolling_state import drift_per_turn, lost_speed, speed_loss
from asperity.joint.planar.turning import driving_sense
from asperity.joint.rolling import RollingResult


class ContactsInSeries(eqx.Module):
    """What the creep of each contact adds to the angle of the output. SI units; contact axis first.

    Parameters
    ----------
    half_width : Array
        Half-widths of the contacts, shape (contacts,) [m].
    slip_ratio : Array
        Share of each contact's width that slips in Carter's sense, 1 − (c/a)², shape (contacts,) [-]; T/(mu N) without
        skew.
    share : Array
        Share of each contact in the drift, shape (contacts,) [-]; they add up to 1.
    distance : Array
        Distance that each contact rolls per angle of the output, shape (contacts,) [m/rad].
    input_angle : Array
        Angle of the input per angle of the output [-].
    drift_per_output_turn : Array
        Angle lost in one turn of the output in steady rolling [rad].
    """

    half_width: Array
    slip_ratio: Array
    share: Array
    distance: Array
    input_angle: Array
    drift_per_output_turn: Array


def contacts_in_series(
    *, geometry: DriveGeometry, rolling: RollingResult, half_width: Array
) -> ContactsInSeries:
    r"""Shares of the contacts in the drift of a joint.

    .. math::
        c_{sp} = \frac{\xi_{sp}}{\xi_\Sigma}, \qquad
        c_{pwr} = \frac{T_{pwr}}{T_{sp}} \frac{\xi_{pwr}}{\xi_\Sigma}, \;\dots \qquad
        c_{wlo} = \frac{T_{pwl}}{T_{sp}} \frac{\xi_{wlo}}{\xi_\Sigma}

    Parameters
    ----------
    geometry : DriveGeometry
        The drive.
    rolling : RollingResult
        Its steady rolling.
    half_width : Array
        Half-widths of its contacts in rolling, shape (5,) [m].

    Returns
    -------
    ContactsInSeries
        Whatever the sense of torque and rotation.

    Notes
    -----
    Both sides of a planet lose the same speed in steady rolling, but not quite at the onset. The side with more force
    counts more: then the error of the sum is of second order in the error of the forces (complementary energy).

    References
    ----------
    Equations (B1) and (B10) of :doc:`/equations`.
    """
    creepage = jnp.abs(jnp.asarray(rolling.creepage))
    unit = rolling_speeds(geometry=geometry, creepage=creepage, sun_speed=1.0)
    right = jnp.asarray(rolling.tangential[1] / rolling.tangential[0])
    weight = lost_speed(creepage) * jnp.stack([jnp.ones_like(right), right, 1.0 - right, right, 1.0 - right])
    loss = speed_loss(geometry=geometry, creepage=creepage)
    return ContactsInSeries(
        half_width=half_width,
        slip_ratio=1.0 - jnp.asarray(rolling.stick_fraction) ** 2,
        share=weight / jnp.sum(weight, axis=0),
        distance=unit.rolling / unit.output,
        input_angle=1.0 / unit.output,
        drift_per_output_turn=drift_per_turn(loss),
    )


def contacts_of_planar_drive(
    *, drive: PlanarDrive, rolling: RollingResult, half_width: Array
) -> ContactsInSeries:
    r"""Shares of the contacts in the drift of a joint with a planar drive.

    .. math:: c_k = \frac{T_k s_k}{\sum_j T_j s_j}, \qquad s_k = \xi_k V_k

    Parameters
    ----------
    drive : PlanarDrive
        The drive.
    rolling : RollingResult
        Its steady rolling; its creepages and forces count with the sense of the drive, as in a joint's result.
    half_width : Array
        Half-widths of its contacts in rolling, shape (contacts,) [m].

    Returns
    -------
    ContactsInSeries
        Where the torque drives the rotation: of the rotation that the same forces resist.

    Notes
    -----
    The speed that the output loses times its torque is the power of the creep, contact by contact.

    References
    ----------
    Equations (B1), (B10) and (M3) of :doc:`/equations`.
    """
    resisted = jnp.where(rolling.speed_loss < 0.0, -1.0, 1.0)
    sense = driving_sense(drive)
    creepage = resisted * sense * rolling.creepage
    speed, rolled = creeping_speeds(drive=drive, creepage=creepage)
    work = jnp.abs(rolling.tangential * rolling.creepage) * rolled
    out = drive.members.index(drive.output)
    ideal, _ = creeping_speeds(drive=drive, creepage=jnp.zeros_like(creepage))
    loss = 1.0 - speed[out] / ideal[out]
    turned = jnp.abs(speed[out])
    return ContactsInSeries(
        half_width=half_width,
        slip_ratio=1.0 - jnp.asarray(rolling.stick_fraction) ** 2,
        share=work / jnp.sum(work),
        distance=rolled / turned,
        input_angle=1.0 / turned,
        drift_per_output_turn=drift_per_turn(loss),
    )


def side_by_side(contacts: ContactsInSeries, torque_share: Array) -> ContactsInSeries:
    r"""Contacts of branches that share a torque.

    .. math:: c_{k,b} = \frac{T_b}{T}\, c_k^{(b)}

    Parameters
    ----------
    contacts : ContactsInSeries
        Of drives all of whose branches are like one of them, branches last.
    torque_share : Array
        Share of each branch in the torque, shape (branches,) [-].

    Returns
    -------
    ContactsInSeries
        All contacts, branch by branch.

    Notes
    -----
    All branches lose the same speed in steady rolling. The one with more force counts more, as of
    :func:`contacts_in_series`.

    References
    ----------
    Equations (B10) and (I4) of :doc:`/equations`.
    """

    def listed(values: Array) -> Array:
        return jnp.swapaxes(values, 0, 1).reshape(-1)

    return ContactsInSeries(
        half_width=listed(contacts.half_width),
        slip_ratio=listed(contacts.slip_ratio),
        share=listed(torque_share * contacts.share),
        distance=listed(contacts.distance),
        input_angle=jnp.sum(torque_share * contacts.input_angle),
        drift_per_output_turn=jnp.sum(torque_share * contacts.drift_per_output_turn),
    )
