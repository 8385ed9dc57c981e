"""What the creep of each contact adds to the angle that a joint loses, for every drive."""

from __future__ import annotations

import equinox as eqx
import jax.numpy as jnp
from jax import Array

from asperity.drive.layout.creeping import creeping_speeds
from asperity.drive.layout.drive import Drive
from asperity.drive.state.creep import drift_per_turn
from asperity.rolling.rolling import RollingResult
from asperity.rolling.turning import driving_sense


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


def contacts_in_series(*, drive: Drive, rolling: RollingResult, half_width: Array) -> ContactsInSeries:
    r"""Shares of the contacts in the drift of a joint.

    .. math:: c_k = \frac{T_k s_k}{\sum_j T_j s_j}, \qquad s_k = \xi_k V_k

    Parameters
    ----------
    drive : Drive
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
    out = drive.members.index(drive.output)
    ideal, _ = creeping_speeds(drive=drive, creepage=jnp.zeros_like(rolling.creepage))
    forwards = driving_sense(drive) * rolling.creepage
    ahead, _ = creeping_speeds(drive=drive, creepage=forwards)
    resisted = jnp.where(jnp.abs(ahead[out]) > jnp.abs(ideal[out]), -1.0, 1.0)
    speed, rolled = creeping_speeds(drive=drive, creepage=resisted * forwards)
    work = jnp.abs(rolling.tangential * rolling.creepage) * rolled
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
