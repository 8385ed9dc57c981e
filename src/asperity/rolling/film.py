"""The oil in the contacts of a joint that rolls: who carries the load, and how the contacts creep."""

from __future__ import annotations

import dataclasses
import math
from typing import NamedTuple

from asperity.contact.creep_capacity import traction_capacity
from asperity.contact.creep_inverse import creepage_at_traction
from asperity.contact.creep_law import NEAR_CAPACITY, Capacity, LayerFactor, traction_at_creepage
from asperity.contact.film_thickness import FilmInlet, central_film_by
from asperity.contact.film_traction import BoundaryFriction, MixedContact
from asperity.contact.fluid import RheologicalTraction
from asperity.contact.hertz_line import peak_pressure
from asperity.contact.load_sharing import LoadSharing, rival_share, shared_load
from asperity.contact.viscosity import reciprocal_asymptotic_coefficient
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.control import once
from asperity.engine.module import Module
from asperity.joint.contacts import JointContacts, rough_joint_contacts
from asperity.joint.crowned_contacts import rough_slices
from asperity.rolling.conditions import Lubricant
from asperity.rolling.inlet_heat import inlet_heat
from asperity.types import Array, Real

#: Decay length of the asperities over the heights, where the contact law in use has none.
_DECAY_OVER_HEIGHTS = 0.48
#: Creepage below which traction is taken in proportion to it [-].
_SMALLEST_CREEPAGE = 1e-12


class OiledSurfaces(Module):
    r"""What the oil in the contacts of a joint meets. SI units.

    Parameters
    ----------
    lubricant : Lubricant
        The oil, of which traction is known.
    rolling_speed : Array
        Mean speeds of both surfaces of each contact relative to it, shape (contacts, ...) [m/s]; 0 where nothing turns.
    effusivity : Array
        :math:`\sqrt{k\rho c}` of the bodies of each contact, their mean [W s^0.5/(m^2 K)]; infinite where it is not
        known: heat of the surfaces is left out then.
    rms_height : Array or None
        Root mean square of the heights of both surfaces together, shape (contacts,) [m]; None where it is not known:
        the film carries all.
    """

    lubricant: Lubricant
    rolling_speed: Array
    effusivity: Array
    rms_height: Array | None


class _Strips(NamedTuple):
    """The strips of contacts, of slices where crowned: line load [N/m], half-width, length and decay length [m]."""

    line_load: Array
    half_width: Array
    length: Array
    decay_length: Array


def _strips(contacts: JointContacts, pressed: Array, rms_height: Real) -> _Strips:
    """The strips under normal forces above 0 [N]; a slice that does not touch is as the middle one, without length."""
    pairs, lines, nothing = contacts.pairs, contacts.loads_along(pressed), xp.zeros_like(pressed)
    if lines is None:
        rough = rough_joint_contacts(contacts=contacts, normal_force=pressed, tangential_force=nothing)
        strips = (
            pressed / pairs.contact_length,
            xp.asarray(pairs.half_width(pressed)),
            pairs.contact_length + nothing,
        )
        carried = pressed
    else:
        touches = lines.line_load > 0.0
        rough = rough_slices(
            pairs=pairs,
            model=contacts.contact_factor_model,
            lines=lines,
            normal_force=pressed,
            tangential_force=nothing,
        )
        strips = (
            xp.where(touches, lines.line_load, lines.line_load[0]),
            xp.where(touches, lines.half_width, lines.half_width[0]),
            xp.where(touches, lines.length_share, 0.0) * pairs.contact_length,
        )
        carried = lines.line_load * pairs.contact_length
    known = (rough.layer_stiffness > 0.0) & (carried > 0.0)
    decay = carried / xp.where(known, rough.layer_stiffness, 1.0)
    return _Strips(*strips, xp.where(known, decay, _DECAY_OVER_HEIGHTS * rms_height))


class OiledContacts(NamedTuple):
    """Contacts of a joint with oil under their loads, shape (contacts, ...), of slices where they are crowned.

    ``contact``: with the shares of film and asperities; ``rival_share`` of the asperities by the other law [-], nan
    where no heights are known; ``pressure_coefficient`` of the oil at the inlet [1/Pa].
    """

    contact: MixedContact
    rival_share: Array
    pressure_coefficient: Array


def oiled_contacts(
    *,
    surfaces: OiledSurfaces,
    contacts: JointContacts,
    normal_force: Array,
    lateral: tuple[Array, Real] | None = None,
) -> OiledContacts:
    """Shares of film and asperities in the contacts of a joint, under normal forces [N]; equations (F1)–(F3).

    ``lateral``: creepages across over how much further the bodies give way that way, and how much this is [-]; None for
    parallel axes.

    Notes
    -----
    The separation of the asperities falls by the decay length of the contact law in use. Where nothing turns the
    numbers are those of a speed of 1 m/s; they have no meaning then.
    """
    pairs, lubricant = contacts.pairs, surfaces.lubricant
    pressed = xp.where(normal_force > 0.0, normal_force, 1.0)
    heights = surfaces.rms_height
    strips = _strips(contacts, pressed, 1.0 if heights is None else heights)
    like = 0.0 * strips.line_load
    speed = xp.where(surfaces.rolling_speed > 0.0, surfaces.rolling_speed, 1.0) + like
    modulus = pairs.moduli.contact_modulus + like
    pressure = xp.asarray(
        peak_pressure(normal_force=strips.line_load, contact_length=1.0, half_width=strips.half_width)
    )
    oil, temperature = lubricant.fluid.viscosity, lubricant.temperature
    inlet = FilmInlet(
        viscosity=oil.base(temperature),
        pressure_coefficient=reciprocal_asymptotic_coefficient(
            viscosity=oil, peak_pressure=pressure, temperature=temperature
        ),
        rolling_speed=speed,
        line_load=strips.line_load,
        effective_radius=pairs.effective_radius + like,
        contact_modulus=modulus,
    )
    heat = inlet_heat(
        lubricant=lubricant, peak_pressure=pressure, contact_modulus=modulus, rolling_speed=speed
    )
    # beyond the range of its fit the factor is not above 0, and there is no film to be computed
    factor = lubricant.supply * xp.where(heat > 0.0, heat, xp.nan)
    sharing, rival = _shares(lubricant, inlet, strips, pressure, factor, heights)
    contact = MixedContact(
        fluid=lubricant.fluid,
        friction=_friction(lubricant, pairs.friction_coefficient + like),
        asperity_share=sharing.asperity_share,
        film_share=sharing.film_share,
        film_thickness=sharing.film_thickness,
        half_width=strips.half_width + like,
        peak_pressure=pressure,
        contact_length=strips.length + like,
        contact_modulus=modulus,
        rolling_speed=speed,
        oil_temperature=temperature,
        effusivity=surfaces.effusivity + like,
        lateral_creepage=None if lateral is None else lateral[0] + like,
        lateral_ratio=1.0 if lateral is None else lateral[1] + like,
        sliced=contacts.crown_curvature is not None,
    )
    return once(OiledContacts(contact, rival, xp.asarray(inlet.pressure_coefficient)))


def _shares(
    lubricant: Lubricant,
    inlet: FilmInlet,
    strips: _Strips,
    pressure: Array,
    factor: Array,
    heights: Real | None,
) -> tuple[LoadSharing, Array]:
    """Who carries the load, and the share of the asperities by the law that is not in use [-]."""
    full = factor * central_film_by(law=lubricant.film_law, inlet=inlet)
    if heights is None:
        return LoadSharing(0.0 * full, 1.0 + 0.0 * full, full), xp.full_like(full, xp.nan)
    balanced = shared_load(
        inlet=inlet,
        decay_length=strips.decay_length,
        rms_height=heights + 0.0 * full,
        half_width=strips.half_width,
        mean_pressure=0.25 * math.pi * pressure,
        thickness_factor=factor,
        film_law=lubricant.film_law,
    )
    rival = rival_share(film_thickness=full, rms_height=heights)
    if lubricant.load_sharing == "persson":
        return balanced, rival
    return LoadSharing(rival, 1.0 - rival, full), balanced.asperity_share


def _friction(lubricant: Lubricant, at_rest: Array) -> BoundaryFriction:
    """Friction of the asperities over their slip: by the table of the oil, or that at rest."""
    if not lubricant.friction_speeds:
        return BoundaryFriction(at_rest)
    first, *others = lubricant.friction_coefficients
    return BoundaryFriction(first + 0.0 * at_rest, lubricant.friction_speeds, (first, *others))


class OiledCreep(NamedTuple):
    """How contacts with oil creep: who carries the load, their layers of asperities, and their capacity.

    ``turns``: whether the contacts roll, for at rest there is no film.
    """

    oiled: OiledContacts
    layer: LayerFactor
    capacity: Capacity
    turns: Array

    def creepage(self, tangential_force: Array) -> Array:
        """Creepages under tangential forces of either sign [N]; equation (F5)."""
        return creepage_at_traction(
            contact=self.oiled.contact,
            traction=tangential_force,
            layer=self.layer,
            capacity=self.capacity,
        )

    def axial_force(self, creepage: Array) -> Array:
        """Axial forces under creepages along the rolling direction, with the sign of the skew [N]."""
        contact = self.oiled.contact
        size = xp.maximum(xp.abs(creepage), _SMALLEST_CREEPAGE)
        return traction_at_creepage(
            contact=contact, creepage=size, layer_factor=self._near_capacity()
        ).lateral

    def without_skew(self) -> Capacity:
        """The capacity of the same contacts with parallel axes."""
        contact = self.oiled.contact
        parallel = dataclasses.replace(contact, lateral_creepage=None)
        return traction_capacity(
            contact=parallel, layer_factor=self._near_capacity(), creep_limit=self.capacity.limit
        )

    def _near_capacity(self) -> Array:
        """Creepage factor of the asperities near gross slip [-]."""
        return self.layer(NEAR_CAPACITY + 0.0 * self.capacity.traction)


def oiled_creep(
    *,
    oiled: OiledContacts,
    layer: LayerFactor,
    surfaces: OiledSurfaces,
    sought: Array | None = None,
    roughly: bool = False,
) -> OiledCreep:
    """The creep law of contacts with oil; equation (F5).

    ``sought``: tractions for which alone it is made [N]: capacities that they are well below of are not found;
    ``roughly``, whether the others need not be exact.
    """
    contact = oiled.contact
    near = layer(NEAR_CAPACITY + contact.total(0.0 * contact.film_thickness))
    capacity = traction_capacity(
        contact=contact,
        layer_factor=near,
        creep_limit=surfaces.lubricant.creep_limit,
        sought=sought,
        roughly=roughly,
    )
    return OiledCreep(oiled, layer, capacity, surfaces.rolling_speed > 0.0)


class FilmState(Module):
    """Contacts with oil in a state of rolling, shape (contacts, ...); of crowned ones the middle of the line.

    Parameters
    ----------
    asperity_share, rival_share : Array
        Share of the asperities in the load, by the law in use and by the other one [-].
    central_film : Array
        Thickness of the film that carries the rest [m].
    elastic_factor : Array
        Creepage with film and asperities as elastic layers over that of the bodies alone [-].
    film_warming : Array
        By how much slip warms the film [K].
    deborah_number : Array
        Time in which the film relaxes over that in which it passes [-]; nan where its rheology is not known.
    traction_capacity : Array
        Largest traction over the normal force [-].
    pressure_coefficient : Array
        Of the oil at the inlet [1/Pa].
    """

    asperity_share: Array
    rival_share: Array
    central_film: Array
    elastic_factor: Array
    film_warming: Array
    deborah_number: Array
    traction_capacity: Array
    pressure_coefficient: Array


def film_state(*, creep: OiledCreep, normal_force: Array, creepage: Array, used: Array) -> FilmState:
    """What film and asperities do under normal forces [N] and creepages [-]; nan where nothing turns.

    ``used``: tractions over those of rigid bodies, at which the asperities' layer is taken [-].
    """
    contact = creep.oiled.contact
    size = xp.maximum(xp.abs(creepage), _SMALLEST_CREEPAGE)
    at = traction_at_creepage(contact=contact, creepage=size, layer_factor=creep.layer(used))
    shown = FilmState(
        asperity_share=contact.asperity_share,
        rival_share=creep.oiled.rival_share,
        central_film=contact.film_thickness,
        elastic_factor=at.elastic_factor,
        film_warming=at.warming,
        deborah_number=_deborah_number(contact),
        traction_capacity=creep.capacity.traction / normal_force,
        pressure_coefficient=creep.oiled.pressure_coefficient,
    )

    def of_middle(leaf: Array) -> Array:
        middle = leaf[0] if xp.ndim(leaf) > xp.ndim(normal_force) else leaf
        return xp.where(creep.turns, middle, xp.nan)

    found: FilmState = trees.map(of_middle, shown)
    return found


def _deborah_number(contact: MixedContact) -> Array:
    r"""Deborah's number of the film, :math:`\eta(\bar p) V/(2 a G)` [-]."""
    traction, viscosity = contact.traction, contact.fluid.viscosity
    if not isinstance(traction, RheologicalTraction):
        return xp.full_like(contact.film_thickness, xp.nan)
    mean = 0.25 * math.pi * contact.film_share * contact.peak_pressure
    thick = viscosity.at(mean, contact.oil_temperature)
    return thick * contact.rolling_speed / (2.0 * contact.half_width * traction.shear_modulus)
