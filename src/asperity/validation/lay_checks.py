"""Surfaces with grooves and surfaces that ran in, against boundary elements."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from asperity.contact.exponential import lay_factor, lay_stiffness_ratio
from asperity.contact.running_in import run_in_factor
from asperity.engine.control import at_once
from asperity.materials import contact_modulus, tangential_contact_modulus
from asperity.surface.lay import ENDLESS, share_across
from asperity.types import Array, Real
from asperity.validation.check import Check, compared

#: Stretched self-affine surfaces of steel: ratio of the correlation lengths, the last for strips; k_n u_0/p, mean of
#: 100 and 300 MPa; k_t/k_n across and along the grooves, mean of both pressures.
ELEMENTS = (
    (1.0, 1.045, 0.828, 0.823),
    (3.0, 1.075, 0.905, 0.759),
    (10.0, 1.155, 0.965, 0.7205),
    (30.0, 1.20, 0.9875, 0.7075),
    (ENDLESS, 1.195, 1.0, 0.700),
)
_REFERENCE = "periodic boundary elements of self-affine surfaces, H 0.8, 100 and 300 MPa"


def lay() -> Iterator[Check]:
    """Grooves: the normal stiffness up to one factor of all surfaces, and the tangential over the normal one."""
    ratio, normal, across, along = np.array(ELEMENTS).T
    elastic = {
        **dict.fromkeys(("youngs_modulus_1", "youngs_modulus_2"), 206e9),
        **dict.fromkeys(("poisson_ratio_1", "poisson_ratio_2"), 0.3),
    }

    def law(ratio: Array) -> tuple[Real, Real, Real]:
        share = share_across(length_ratio=ratio)
        moduli = {
            "contact_modulus": contact_modulus(**elastic),
            "tangential_contact_modulus": tangential_contact_modulus(**elastic),
        }
        across = lay_stiffness_ratio(share=share, **moduli)
        return lay_factor(rolling_share=share), across, lay_stiffness_ratio(share=1.0 - share, **moduli)

    factor, ratio_across, ratio_along = at_once(law, ratio)
    common = np.mean(normal / factor)
    for quantity, expected, computed, tolerance in (
        ("stiffness of grooved surfaces over that of all", normal, common * factor, 0.02),
        ("tangential over normal stiffness, across grooves", across, ratio_across, 0.01),
        ("tangential over normal stiffness, along grooves", along, ratio_along, 0.01),
    ):
        yield compared(
            model="Lay of rough surfaces",
            reference=_REFERENCE,
            quantity=quantity,
            unit="-",
            expected=expected,
            computed=computed,
            tolerance=tolerance,
        )


def running_in() -> Iterator[Check]:
    """The table of surfaces that ran in, which the package interpolates."""
    hills, strips = (0.85, 0.38, 0.19), (0.53, 0.27)
    ratios = [(ratio, False) for ratio in hills] + [(ratio, True) for ratio in strips]
    found = [
        run_in_factor(hardness_ratio=ratio, strips=grooves, load_share=share)
        for share in (1.0, 0.5)
        for ratio, grooves in ratios
    ]
    full, half = (1.075, 1.35, 2.2, 1.25, 1.7), (1.13, 1.8, 3.3, 1.35, 2.15)
    elastic = np.array([1.07, 1.07, 1.07, 1.15, 1.15])
    yield compared(
        model="Running in of rough surfaces",
        reference="periodic boundary elements with the pressure capped at the hardness, elastic afterwards",
        quantity="stiffness over that of the elastic surface, at the full load and at half of it",
        unit="-",
        expected=np.concatenate([full / elastic, half / elastic]),
        computed=np.array(found),
        tolerance=1e-12,
    )
