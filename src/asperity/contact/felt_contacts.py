"""What contacts feel of a measured surface, and what Persson's theory makes of its waves and of its form."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from asperity.contact.persson_2007 import (
    WaveSpectrum,
    contact_fraction,
    persson_decay_length,
    sorted_waves,
    waves_along_line,
)
from asperity.engine import trees
from asperity.engine.control import at_once, vectorised
from asperity.materials import ContactPair
from asperity.types import Array

if TYPE_CHECKING:
    from asperity.surface.measured_roughness import MeasuredRoughness


class Felt(NamedTuple):
    """What a contact feels of a measured surface."""

    rms_height: float
    deviation: float  #: standard deviation of its logarithm
    width: float
    axial: tuple[float, ...]  #: longest waves along the axis, for each body
    longest: float  #: share of the mean square in waves longer than half of the longest one
    squares: tuple[float, ...]  #: mean square of the heights of each body
    rolling_share: float | None = (
        None  #: of the waves that run in the rolling direction; None where no lay is known
    )
    rms_slope: float | None = None  #: rms gradient, of strips their slope; None where it is not known


class FeltContacts(NamedTuple):
    """The contacts of a joint on a measured surface, crowned ones where they are widest."""

    felt: dict[str, Felt]
    pressures: Any  #: mean Hertzian pressures, shape (contacts,) [Pa]
    moduli: tuple[ContactPair, ...]


def form_lengths(measured: MeasuredRoughness, contacts: FeltContacts) -> dict[str, float]:
    """Decay length of waves along the axis that the heights leave out, as far as no line load closes them [m].

    Parameters
    ----------
    measured : MeasuredRoughness
        Of both bodies together, with spectra.
    contacts : FeltContacts
        The contacts.

    Returns
    -------
    dict
        Contact → length [m].

    References
    ----------
    :func:`asperity.contact.persson_2007.waves_along_line`.
    """
    lengths, _ = decay_lengths_by_theory(measured, contacts, form=True)
    return dict(zip(contacts.felt, map(float, lengths), strict=True))


def decay_lengths_by_theory(
    measured: MeasuredRoughness, contacts: FeltContacts, *, form: bool
) -> tuple[Any, Any]:
    """Decay length and share in contact by Persson's theory, of the waves that contacts feel or of their form.

    Parameters
    ----------
    measured : MeasuredRoughness
        Of both bodies together, with spectra.
    contacts : FeltContacts
        The contacts.
    form : bool
        The long waves along the axis that are no roughness.

    Returns
    -------
    tuple of array, shape (contacts,)
        Lengths [m] and shares of the area [-].

    References
    ----------
    Equation (A11) of :doc:`/equations`.
    """
    spectra, loads = [], np.asarray(contacts.pressures)
    for one in contacts.felt.values():
        parts = [
            (body.form if form else body.waves)(rolling=1.0 / one.width, axial=1.0 / limit)
            for body, limit in zip(measured.spectra, one.axial, strict=True)
        ]
        waves = np.concatenate(parts, axis=1)
        spectra.append(waves_along_line(*waves, half_width=0.5 * one.width) if form else sorted_waves(*waves))
    loads = loads * [one.width if form else 1.0 for one in contacts.felt.values()]
    moduli = np.array([float(moduli.contact_modulus) for moduli in contacts.moduli])
    return at_once(_theory, trees.map(lambda *leaves: np.stack(leaves), *spectra), loads, moduli)


def _theory(waves: WaveSpectrum, pressure: Array, modulus: Array) -> tuple[Array, Array]:
    """Decay length [m] and share of the area in contact [-]; the contacts are the first axis."""

    def one(spectrum: WaveSpectrum, p: Array, contact_modulus: Array) -> tuple[Array, Array]:
        state = {"mean_pressure": p, "contact_modulus": contact_modulus}
        return (
            persson_decay_length(spectrum=spectrum, **state),
            contact_fraction(rms_slope=spectrum.rms_slope, **state),
        )

    return vectorised(one)(waves, pressure, modulus)
