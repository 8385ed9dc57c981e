"""Contacts with oil: film, load sharing and traction against an independent program, closed forms and strips."""

from __future__ import annotations

import dataclasses
import functools
from collections.abc import Iterator

import numpy as np

from asperity.contact.creep_capacity import traction_capacity
from asperity.contact.creep_law import elastic_layers_factor, traction_at_creepage
from asperity.contact.film_traction import MixedContact, even_slip
from asperity.contact.fluid import Fluid, LimitingTraction, RheologicalTraction
from asperity.contact.viscosity import ExponentialViscosity, RationalPressureRise, Viscosity
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.control import at_once
from asperity.types import Array
from asperity.validation.check import Check, compared
from asperity.validation.oiled_rollers import (
    CREEPAGES,
    HALF_WIDTH,
    LENGTH,
    LOAD,
    MODULUS,
    OiledContact,
    known_contacts,
    oiled_contact,
    strip_force,
)

_SOURCE = (
    "a program that shares no code with this one: 10/20 mm, 10 mm long, 2000 N, four oils, 5 mm/s to 3 m/s"
)


def films() -> Iterator[Check]:
    """Films and shares of the contacts of the table."""
    known = known_contacts()
    found = [at_once(lambda each=each: each.contact()) for each in known]
    for model, quantity, unit, expected, computed, tolerance in (
        (
            "Central film",
            "thickness without asperities",
            "µm",
            [1e6 * each.full_film for each in known],
            [1e6 * each.full_film for each in found],
            1.1e-4,
        ),
        (
            "Load sharing",
            "share of the asperities",
            "-",
            [each.asperity_share for each in known],
            [each.contact.asperity_share for each in found],
            1.1e-5,
        ),
        (
            "Load sharing",
            "thickness of the film beside asperities",
            "µm",
            [1e6 * each.film_thickness for each in known],
            [1e6 * each.contact.film_thickness for each in found],
            1.1e-4,
        ),
    ):
        yield compared(
            model=model,
            reference=_SOURCE,
            quantity=quantity,
            unit=unit,
            expected=expected,
            computed=np.ravel(computed),
            tolerance=tolerance,
            absolute=True,
        )


def _of_load(oiled: OiledContact) -> tuple[Array, Array, Array]:
    """Factor of the layers, tractions at the creepages of the table over the load, and the largest one."""
    contact, layer = oiled.contact, oiled.layer_factor
    tractions = traction_at_creepage(contact=contact, creepage=xp.asarray(CREEPAGES), layer_factor=layer)
    return (
        elastic_layers_factor(
            contact=contact,
            layer_factor=layer,
            slides=even_slip(contact=contact, creepage=xp.asarray(CREEPAGES)),
        ),
        tractions.traction / LOAD,
        traction_capacity(contact=contact, layer_factor=layer).traction / LOAD,
    )


def _tractions() -> Iterator[Check]:
    """The table's tractions."""
    known = known_contacts()
    found = [at_once(lambda each=each: _of_load(each.contact())) for each in known]
    factors, tractions, capacities = zip(*found, strict=True)
    check = functools.partial(
        compared, model="Creep law with oil", reference=_SOURCE, unit="-", absolute=True
    )
    yield check(
        quantity="factor of film and asperities as elastic layers",
        expected=[each.elastic_factor for each in known],
        computed=np.ravel(factors),
        tolerance=1.1e-4,
    )
    yield check(
        quantity="traction over load at creepages of 0.01 to 1 %",
        expected=np.ravel([each.tractions for each in known]),
        computed=np.ravel(tractions),
        tolerance=1.1e-5,
    )
    yield check(
        quantity="largest traction over load",
        expected=[each.capacity for each in known],
        computed=np.ravel(capacities),
        tolerance=1.1e-5,
    )


def _even_film(ratio: float) -> MixedContact:
    """The rollers with a film alone, of constant viscosity and without a limit, of a number b = 2 eta V/(h E*)."""
    oiled = oiled_contact("M100", 60.0, 1.0, 1e-7, rough=False)
    thickness = 1e-7
    viscosity = Viscosity(
        ExponentialViscosity(0.5 * ratio * thickness * MODULUS, 0.0, 0.0),
        RationalPressureRise(1e30, 0.0, 0.0, 0.0),
    )
    fluid = Fluid(viscosity, RheologicalTraction(LimitingTraction(1e9), 1e30, "limit"), np.inf)
    return dataclasses.replace(
        oiled.contact, fluid=fluid, film_thickness=xp.asarray([thickness]), effusivity=np.inf
    )


def creep() -> Iterator[Check]:
    """Traction over creepage: the table, a linear film, strips."""
    yield from _tractions()
    ratios, creepage = np.array([0.1, 1.0, 10.0]), 1e-3
    closed = HALF_WIDTH * MODULUS * LENGTH * creepage * np.arctan(ratios)
    films = [_even_film(float(ratio)) for ratio in ratios]
    by_law = [
        at_once(
            lambda film=film: traction_at_creepage(
                contact=film, creepage=xp.asarray([creepage]), layer_factor=xp.asarray([1.0])
            ).traction[0]
        )
        for film in films
    ]
    exact = "closed form of an even film in proportion to its slip, a E* B xi arctan(2 eta V/(h E*))"
    yield compared(
        model="Creep law with oil",
        reference=exact,
        quantity="traction at 2 eta V/(h E*) of 0.1, 1 and 10",
        unit="N",
        expected=closed,
        computed=by_law,
        tolerance=1e-9,
    )
    yield compared(
        model="Boundary elements: rolling with a film",
        reference=exact,
        quantity="traction at 2 eta V/(h E*) of 0.1, 1 and 10, 100 strips and half of them",
        unit="N",
        expected=closed,
        computed=[
            strip_force(contact=_single(film), creepage=creepage, elastic_factor=1.0, strips=100)
            for film in films
        ],
        tolerance=3e-3,
    )
    yield _against_strips()


def _single(contact: MixedContact) -> MixedContact:
    """A contact of shape (1,) as one without axes."""
    single: MixedContact = trees.map(lambda leaf: np.ravel(leaf)[0], contact)
    return single


def _against_strips() -> Check:
    """The law against strips with the same shear stress at every place."""
    by_strips, by_law = [], []
    for each in known_contacts():
        oiled = at_once(each.contact)
        found = at_once(
            lambda oiled=oiled: traction_at_creepage(
                contact=oiled.contact, creepage=xp.asarray([3e-4]), layer_factor=oiled.layer_factor
            )
        )
        by_strips.append(
            strip_force(
                contact=_single(oiled.contact),
                creepage=3e-4,
                elastic_factor=float(found.elastic_factor[0]),
                strips=80,
            )
        )
        by_law.append(float(found.traction[0]))
    return compared(
        model="Creep law with oil",
        reference="boundary elements of this package: stress by the slip of every place, bodies and layers that yield",
        quantity="traction at a creepage of 0.03 %, 11 contacts",
        unit="N",
        expected=by_strips,
        computed=by_law,
        tolerance=0.1,
    )
