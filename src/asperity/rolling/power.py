"""Power of a joint that rolls: what goes in, what comes out, and where the rest becomes heat."""

from __future__ import annotations

from asperity.contact.crowned_line import CrownedLine
from asperity.contact.roller_pairs import RollerPairs
from asperity.contact.rolling_losses import (
    creep_power,
    inlet_rolling_force,
    inlet_rolling_power,
)
from asperity.drive.state.state import DriveState, RollingSpeeds
from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.rolling.conditions import RollingConditions
from asperity.types import Array, Real


class RollingPower(Module):
    """Powers of a rolling joint, all branches together [W]; contact axis first. nan where the input stands.

    Losses of each contact, shape (contacts, ...), nan for one that the joint leaves out: by creep along the rolling
    direction, by creep across it (``skew``), by elastic hysteresis and by the oil at the inlet; ``contact`` is the sum
    of those that the joint counts. ``bearings``: in the bearings of the input, of rollers on pins and of the output,
    and at the pins; ``loss``: of the joint.

    ``input`` and ``output``: power that enters and leaves, at input and output, or at output and input where the output
    torque drives the rotation. Where the losses exceed what then enters, nothing leaves: it and ``efficiency``, output
    over input [-], are nan.
    """

    creep: Real
    skew: Real
    hysteresis: Real
    oil: Real
    bearings: Array
    contact: Real
    loss: Array
    input: Array
    output: Array
    efficiency: Array


def rolling_power(
    *,
    branches: Real,
    pairs: RollerPairs,
    conditions: RollingConditions,
    state: DriveState,
    speeds: RollingSpeeds,
    axial_force: Real,
    lateral_creepage: Array,
    bearing_power: Array,
    output_torque: Real,
) -> RollingPower:
    r"""Losses by cause and contact, and the efficiency.

    .. math:: \eta = \frac{P_{out}}{P_{out} + P_{creep} + P_{skew} + P_{bearings} + P_{hysteresis} + P_{oil}}

    Parameters
    ----------
    branches : Real
        Number of branches of the drive [-].
    pairs, conditions : RollerPairs, RollingConditions
        Its contacts, and which losses are counted.
    state : DriveState
        Forces, creepages and what resists rolling.
    speeds : RollingSpeeds
        Speeds of the bodies.
    axial_force, lateral_creepage : Real, Array
        Axial forces of the contacts, shape (contacts, ...) [N], and their creepages across [-].
    bearing_power, output_torque : Array, Real
        Power lost in bearings and pins [W]; torque at the output [N·m].

    Notes
    -----
    All losses equal :math:`T_{in}\omega_s - T_{out}\omega_c` of the rolling state. With the balance of the carrier as
    printed, equation (5) of Zou et al. 2025, they are larger by :math:`2n(T_{Bl} + T_{Br})\,\omega_c`: it leaves out
    that the rollers' bearings brake the carrier that holds them. Churning of the oil is left out.

    References
    ----------
    Equations (B3) and (B9) of :doc:`/equations`.
    """
    count, rolling = branches, speeds.rolling
    creep = count * creep_power(
        tangential_force=state.tangential, creepage=state.creepage, rolling_speed=rolling
    )
    skew = count * creep_power(tangential_force=axial_force, creepage=lateral_creepage, rolling_speed=rolling)
    absent = xp.full_like(creep, xp.nan)
    counted = creep + skew
    hysteresis: Real = absent
    oil: Real = absent
    if conditions.hysteresis_loss_factor is not None:
        turned = speeds.driving / pairs.radius_1 + pairs.sign * speeds.driven / pairs.radius_2
        hysteresis = count * xp.abs(state.hysteresis_moment) * turned
        counted = counted + hysteresis
    if conditions.viscosity is not None:
        oil = count * inlet_rolling_power(
            rolling_force=xp.abs(state.drag), contact_length=1.0, entrainment_speed=rolling
        )
        counted = counted + oil
    loss = xp.sum(counted, axis=0) + bearing_power
    entering, leaving, efficiency = _passed(xp.asarray(output_torque * speeds.output), loss)
    return RollingPower(
        creep=creep,
        skew=skew,
        hysteresis=hysteresis,
        oil=oil,
        bearings=bearing_power,
        contact=xp.asarray(counted),
        loss=loss,
        input=entering,
        output=leaving,
        efficiency=efficiency,
    )


def _passed(at_output: Array, loss: Array) -> tuple[Array, Array, Array]:
    """Powers that enter and leave [W] and the efficiency [-]; the power at the output is negative where it drives."""
    drives = at_output >= 0.0
    entering = xp.where(drives, at_output + loss, -at_output)
    leaving = xp.where(drives, at_output, -at_output - loss)
    works = (leaving >= 0.0) & (entering > 0.0)
    efficiency = xp.where(works, leaving / xp.where(works, entering, 1.0), xp.nan)
    return entering, xp.where(leaving >= 0.0, leaving, xp.nan), efficiency


def rolling_input_torque(
    *, power: RollingPower, output_torque: Real, output_speed: Real, input_speed: Real
) -> Array:
    r"""Torque at the input in rolling [N·m], all losses counted: what a motor needs.

    .. math:: T_{in} = \frac{T_{out}\,\omega_{out} + P_{loss}}{\omega_{in}}

    In the sense of rotation; negative where the output torque drives the input, nan where the input stands. Of the
    angular velocities [rad/s] only the sizes count; that of the output is reduced by creep. Balance of powers, with the
    losses of equations (B3) and (B9) of :doc:`/equations`.
    """
    speed = xp.abs(xp.asarray(input_speed))
    turns = speed > 0.0
    entering = output_torque * xp.abs(output_speed) + power.loss
    return xp.where(turns, entering / xp.where(turns, speed, 1.0), xp.nan)


def oil_drag(
    *,
    pairs: RollerPairs,
    viscosity: Real,
    normal_force: Array,
    rolling_speed: Array,
    lines: CrownedLine | None,
) -> Array:
    r"""Drag of the oil at the inlet on each surface of the contacts.

    .. math:: g = f B

    Parameters
    ----------
    pairs : RollerPairs
        The contacts.
    viscosity : Real
        Of the oil at the inlet [Pa·s].
    normal_force : Array
        Shape (contacts, ...) [N].
    rolling_speed : Array
        Mean speeds of both surfaces, of the same shape [m/s].
    lines : CrownedLine or None
        Loads along crowned contacts, whose slices add.

    Returns
    -------
    Array
        Shape (contacts, ...) [N]; 0 where nothing rolls.

    References
    ----------
    N. Biboulet and L. Houpert, Proc. IMechE J 224 (2010) 765; equation (B9) of :doc:`/equations`.
    """
    turns = rolling_speed > 0.0
    pressed = xp.where(normal_force > 0.0, normal_force, 1.0)
    force = inlet_rolling_force(
        viscosity=viscosity,
        entrainment_speed=xp.where(turns, rolling_speed, 1.0),
        line_load=pressed / pairs.contact_length if lines is None else lines.line_load,
        effective_radius=pairs.effective_radius,
        contact_modulus=pairs.moduli.contact_modulus,
    )
    if lines is not None:
        force = xp.sum(lines.length_share * force, axis=0)
    return xp.where(turns, force * pairs.contact_length, 0.0)
