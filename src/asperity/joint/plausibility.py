"""Notes on a solved joint that can exist, but whose numbers lie outside what the model or the practice knows."""

from __future__ import annotations

import dataclasses
import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import equinox as eqx
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.drive.assembly import assembly_stiffness
from asperity.drive.geometry import CONTACT_NAMES, triangle
from asperity.drive.ring_bending import thin_ring_compliance
from asperity.joint.contacts import JointContacts, joint_contacts, loaded_contacts
from asperity.joint.description import Joint
from asperity.joint.elastic_bodies import AssemblySprings, assembly_springs
from asperity.joint.evaluation import JointResult
from asperity.types import Real
from asperity.units import format_quantity

if TYPE_CHECKING:
    from asperity.joint.results import Severity

#: Loss of assembled stiffness from which the bending of a ring is worth a warning [-].
RING_BENDING_LIMIT = 0.05
#: Friction coefficients above are those of dry or tacky surfaces; traction fluids end near 0.12 [-].
FRICTION_LIMIT = 0.3
#: Contact length over the smaller roller's diameter above which a roller skews rather than bears evenly [-].
SLENDERNESS_LIMIT = 3.0
#: Width over loaded length of a crowned contact above which its slices err by more than 2 % in the peak pressure [-].
WIDTH_OVER_LENGTH_LIMIT = 0.25
#: Oil film over roughness above which the film carries a part of the load [-].
FILM_RATIO_LIMIT = 1.0
#: The paper's pairs of rollers, Tables 1 and 2: effective radius and contact length [m].
PAPER_EFFECTIVE_RADII = (3.0e-3, 8.4e-3)
PAPER_CONTACT_LENGTHS = (5e-3, 30e-3)


@dataclass(frozen=True, slots=True)
class Note:
    """One comparison with what is usual, for a contact or for the whole drive.

    Parameters
    ----------
    name, label : str
        What is compared, for machines and for people.
    contact : str or None
        Which contact; None for the whole drive.
    value, limit : float
        The value and the limit it is compared with [SI].
    ok : bool
        Whether the value is on the good side of its limit.
    severity : {"function", "damage", "accuracy", "model"}
        How serious it is if it is not.
    meaning : str
        What that means.
    remedy : str or None
        What to do if it is not.
    """

    name: str
    label: str
    contact: str | None
    value: float
    limit: float
    ok: bool
    severity: Severity
    meaning: str
    remedy: str | None


class CheckedSizes(eqx.Module):
    """The numbers of a joint that :func:`plausibility` looks at. SI units.

    Parameters
    ----------
    contact_length, friction_coefficient, smaller_radius, effective_radius : Array
        Of the contacts, shape (5,) [m], [-], [m], [m].
    crown_curvature : Array or None
        Of the contacts, shape (5,) [1/m]; None where no roller is crowned.
    ring_bending_stiffness : Array
        Of a ring that carries itself, under each loading roller, by thin-ring theory [N/m].
    bent_stiffness : Array
        Assembled torsional stiffness of a joint whose ring carries itself [N·m/rad]: with that spring where the bodies
        are springs, otherwise with a ring of free rim; nan where the joint states what holds the ring.
    """

    contact_length: Array
    friction_coefficient: Array
    smaller_radius: Array
    effective_radius: Array
    ring_bending_stiffness: Array
    bent_stiffness: Array
    crown_curvature: Array | None = None


def checked_sizes(joint: Joint, result: JointResult) -> CheckedSizes:
    """What :func:`plausibility` needs beside the result: pure, compiled with the joint's solution.

    Parameters
    ----------
    joint : Joint
        One joint.
    result : JointResult
        Its result.

    Returns
    -------
    CheckedSizes
        Sizes of the contacts, and the assembled stiffness with a ring that carries itself.
    """
    contacts = joint_contacts(joint)
    pairs = contacts.pairs
    shape = (len(CONTACT_NAMES),)
    length = jnp.broadcast_to(pairs.contact_length, shape)
    sides = triangle(joint.geometry)
    bending = thin_ring_compliance(
        geometry=joint.geometry,
        sides=sides,
        wall_thickness=joint.ring_wall_thickness,
        length=jnp.max(length[3:]),
        youngs_modulus=joint.bodies.ring.youngs_modulus,
    )
    spring = 1.0 / bending.opposed
    return CheckedSizes(
        contact_length=length,
        friction_coefficient=jnp.broadcast_to(pairs.friction_coefficient, shape),
        smaller_radius=jnp.broadcast_to(jnp.minimum(pairs.radius_1, pairs.radius_2), shape),
        effective_radius=jnp.broadcast_to(pairs.effective_radius, shape),
        ring_bending_stiffness=jnp.asarray(spring),
        bent_stiffness=_bent_stiffness(joint, contacts, result, spring),
        crown_curvature=contacts.crown_curvature,
    )


def _bent_stiffness(
    joint: Joint, contacts: JointContacts, result: JointResult, ring_bending_stiffness: Real
) -> Array:
    """Assembled stiffness at the output with a ring that carries itself; nan if the joint states what holds it."""
    if joint.ring_support is not None:
        return jnp.asarray(jnp.nan)
    structure, sides, forces = joint.structure, triangle(joint.geometry), result.forces
    springs = AssemblySprings(
        jnp.asarray(result.interfaces.normal), jnp.asarray(result.interfaces.tangential), None
    )
    if joint.body_model == "springs":
        structure = dataclasses.replace(structure, ring_bending_stiffness=ring_bending_stiffness)
    else:
        springs = assembly_springs(
            joint=dataclasses.replace(joint, ring_support="free"),
            sides=sides,
            contacts=contacts,
            loaded=loaded_contacts(
                contacts=contacts, normal_force=forces.normal, tangential_force=forces.tangential
            ),
        )
    bent = assembly_stiffness(
        geometry=joint.geometry,
        sides=sides,
        normal_stiffness=springs.normal_stiffness,
        tangential_stiffness=springs.tangential_stiffness,
        structure=structure,
        coupling=springs.coupling,
    )
    return jnp.asarray(bent.stiffness.output)


def plausibility(joint: Joint, result: JointResult, sizes: CheckedSizes) -> tuple[Note, ...]:
    """Notes on the ring's wall, the friction, the lengths, the oil film, and the sizes for which lambda was made.

    Parameters
    ----------
    joint : Joint
        One joint.
    result : JointResult
        Its result.
    sizes : CheckedSizes
        Its sizes, as NumPy arrays.

    Returns
    -------
    tuple of Note
        One for the drive or for each contact; those that are not ok are warnings.
    """
    lengths, effective = sizes.contact_length, sizes.effective_radius
    films = np.asarray(result.rolling.film_ratio)
    notes = list(_ring_bending(joint, result, sizes))
    for index, name in enumerate(CONTACT_NAMES):
        notes += contact_notes(
            name,
            friction_coefficient=float(sizes.friction_coefficient[index]),
            contact_length=float(lengths[index]),
            smaller_radius=float(sizes.smaller_radius[index]),
            effective_radius=float(effective[index]),
            film_ratio=float(films[index]),
            contact_factor_model=joint.contact_factor_model,
        )
        notes += _crown(result, sizes, index)
    return tuple(notes)


def contact_notes(
    name: str,
    *,
    friction_coefficient: float,
    contact_length: float,
    smaller_radius: float,
    effective_radius: float,
    film_ratio: float,
    contact_factor_model: str,
) -> list[Note]:
    """Notes on the friction, length, oil film and size of one contact of any drive.

    Parameters
    ----------
    name : str
        Name of the contact.
    friction_coefficient : float
        mu [-].
    contact_length, smaller_radius, effective_radius : float
        Length, radius of the smaller roller and effective radius [m].
    film_ratio : float
        Oil film over roughness [-]; nan where it is not known.
    contact_factor_model : str
        Model of the contact factor.

    Returns
    -------
    list of Note
        Those that are not ok are warnings.
    """
    notes = [
        _note(
            "friction_coefficient",
            "friction coefficient",
            name,
            friction_coefficient,
            FRICTION_LIMIT,
            ("a usual friction coefficient", "traction fluids reach 0.12, clean dry steel 0.3"),
            "measure a coefficient this high before relying on it",
        ),
        _note(
            "contact_length_over_diameter",
            "contact length over diameter",
            name,
            contact_length / (2.0 * smaller_radius),
            SLENDERNESS_LIMIT,
            (
                "a usual length of a contact line",
                "the contact line is long for its roller: a slight skew or bending loads one end, and the even line "
                "load of the model is lost",
            ),
            "shorten it, or crown the rollers",
        ),
    ]
    if math.isfinite(film_ratio):
        notes.append(
            _note(
                "film_ratio",
                "oil film over roughness lambda",
                name,
                film_ratio,
                FILM_RATIO_LIMIT,
                (
                    "the asperities carry the load, as the contact law assumes",
                    "the oil film carries a part of the load, and all of it from about 3: friction, creep, drift, "
                    "torque capacity and stiffness are then those of the oil, but they are computed for surfaces "
                    "that touch",
                ),
                "use the friction coefficient measured with this oil at this film, or choose a thinner oil or a "
                "lower speed",
            )
        )
    if contact_factor_model != "unity":
        notes.append(_size(contact_factor_model, name, effective_radius, contact_length))
    return notes


def _crown(result: JointResult, sizes: CheckedSizes, index: int) -> list[Note]:
    """Whether a crowned contact is long enough for its slices, and whether its ends are free."""
    if sizes.crown_curvature is None:
        return []
    found = result.diagnostics
    name, ratio = CONTACT_NAMES[index], float(np.asarray(found.loaded_length_over_width)[index])
    if not float(np.asarray(sizes.crown_curvature)[index]) > 0.0 or math.isnan(ratio):
        return []
    share, end, peak = (
        float(np.asarray(getattr(found, each))[index])
        for each in ("loaded_length_share", "end_line_load_ratio", "peak_line_load_ratio")
    )
    return [
        _note(
            "contact_width_over_length",
            "contact width over loaded length",
            name,
            1.0 / ratio,
            WIDTH_OVER_LENGTH_LIMIT,
            (
                "the contact is long enough for its slices: the peak pressure is within 2 % of Hertz's",
                "the contact is short for its slices: the peak pressure is 2 to 5 % too high, the creep up to 11 %"
                " too high",
            ),
            "choose a larger crown radius",
        ),
        _note(
            "crowned_end_load",
            "line load at the ends over mean line load",
            name,
            end,
            0.0,
            (
                f"the ends are free: {100.0 * share:.3g} % of the contact length is loaded, with {peak:.3g} times the "
                "mean line load in the middle",
                "the load reaches the ends of the rollers: their edges raise the stress there, which is not computed",
            ),
            "choose a smaller crown radius or a shorter contact line, or relieve and round the ends",
        ),
    ]


def _note(
    name: str, label: str, contact: str, value: float, limit: float, words: tuple[str, str], remedy: str
) -> Note:
    ok = value <= limit
    meaning = words[0] if ok else words[1]
    return Note(name, label, contact, value, limit, ok, "accuracy", meaning, None if ok else remedy)


def _size(model: str, contact: str, radius: float, length: float) -> Note:
    """Whether a pair of rollers is of the paper's sizes; told by whichever of radius and length is farther outside."""
    ranges = ((radius, PAPER_EFFECTIVE_RADII), (length, PAPER_CONTACT_LENGTHS))
    value, (low, high) = max(ranges, key=lambda entry: max(entry[1][0] / entry[0], entry[0] / entry[1][1]))
    ok = low <= value <= high
    inside = "the sizes are those for which the paper uses lambda"
    mm = [format_quantity(bound, "mm", 2) for bound in (*PAPER_EFFECTIVE_RADII, *PAPER_CONTACT_LENGTHS)]
    outside = (
        f'contact_factor = "{model}" contains a length in mm, so that it depends on the size of the drive: the paper '
        f"uses it for effective radii of {mm[0]} to {mm[1]} and contact lengths of {mm[2]} to {mm[3]}. By this alone "
        'the published stiffness of the paper\'s joint would gain 28 % at ten times its size ("printed"), and lose '
        "93 % at a tenth"
    )
    return Note(
        "contact_factor_size",
        "size of the contact",
        contact,
        value,
        low if value < low else high,
        ok,
        "model",
        inside if ok else outside,
        None if ok else 'use contact_factor = "unity", which has no such scale',
    )


def _ring_bending(joint: Joint, result: JointResult, sizes: CheckedSizes) -> tuple[Note, ...]:
    """What a ring that carries itself would lose, where the joint does not say what holds it."""
    stated = joint.ring_support is not None or not math.isinf(float(joint.structure.ring_bending_stiffness))
    if stated or float(joint.geometry.planet_count) < 2.0:
        return ()
    held, bent = float(result.assembly.stiffness.output), float(sizes.bent_stiffness)
    if not held > 0.0:
        return ()
    loss = 1.0 - bent / held
    stiffness, bent_to, held_at = (
        format_quantity(value, unit, 3)
        for value, unit in (
            (float(sizes.ring_bending_stiffness), "N/um"),
            (bent, "N*m/rad"),
            (held, "N*m/rad"),
        )
    )
    if joint.body_model == "exact":
        means = "ring_support is not stated, and a rigid housing is assumed to hold the ring. In a ring that"
        remedy = "state ring_support, or hold the ring in a rigid housing"
    else:
        means = (
            "the springs are those of a ring in a rigid housing. By thin-ring theory, with a ring_bending_stiffness of "
            f"about {stiffness} under each loading roller, in a ring that"
        )
        remedy = 'choose bodies = "exact", give ring_bending_stiffness, or hold the ring in a rigid housing'
    ok = loss <= RING_BENDING_LIMIT
    return (
        Note(
            "ring_bending_loss",
            "stiffness lost by bending of the ring",
            None,
            loss,
            RING_BENDING_LIMIT,
            ok,
            "accuracy",
            f"{means} carries itself the assembled stiffness would be {bent_to} instead of {held_at}",
            None if ok else remedy,
        ),
    )
