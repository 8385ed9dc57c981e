"""A joint on a measured surface after running in: how much stiffer its asperities are, and what is said of it."""

from __future__ import annotations

from typing import NamedTuple

from asperity.contact.felt_contacts import FeltContacts
from asperity.contact.running_in import UNCERTAINTY, run_in_factor
from asperity.errors import InputError
from asperity.surface.height_spectrum import HeightSpectrum
from asperity.surface.lay import DIRECTIONS
from asperity.types import Document
from asperity.units import format_quantity


class RunInBound(NamedTuple):
    """What running in does to contacts.

    ``strips``: whether the surface consists of endless grooves; contact → ``slopes`` rms gradient of the waves that it
    feels [-], ``hardness_ratios`` H/(E h') [-], ``factors`` by which its asperities are stiffer at the load of running
    in and, ``at_half_load``, at half of it [-]; ``refused``: why one of them is not known, empty otherwise.
    """

    strips: bool
    slopes: dict[str, float]
    hardness_ratios: dict[str, float]
    factors: dict[str, float]
    at_half_load: dict[str, float]
    refused: str


def run_in_bound(spectra: tuple[HeightSpectrum, ...], contacts: FeltContacts) -> RunInBound:
    """How much stiffer running in makes contacts on a measured surface, under the torque of the file."""
    strips = all(not spectrum.is_map and spectrum.lay in DIRECTIONS for spectrum in spectra)
    bound = RunInBound(strips, {}, {}, {}, {}, "")
    for (name, felt), moduli in zip(contacts.felt.items(), contacts.moduli, strict=True):
        assert felt.rms_slope is not None
        ratio = float(moduli.hardness) / (float(moduli.contact_modulus) * felt.rms_slope)
        bound.slopes[name], bound.hardness_ratios[name] = felt.rms_slope, ratio
        try:
            for share, factors in ((1.0, bound.factors), (0.5, bound.at_half_load)):
                factors[name] = run_in_factor(hardness_ratio=ratio, strips=strips, load_share=share)
        except InputError as error:
            bound = bound._replace(refused=bound.refused or f"{name}: {error}")
    return bound


def run_in_document(bound: RunInBound, found: Document) -> Document:
    """The joint after running in as plain numbers for JSON, None where it is not known; ``words`` say what it is."""
    numbers = (
        *("published_Nm_per_rad", "series_with_bulk_Nm_per_rad", "assembly_Nm_per_rad"),
        "drift_rad_per_output_turn",
    )
    return {
        **{name: found.get(name) for name in numbers},
        "contacts": {
            name: {
                "rms_slope": slope,
                "hardness_ratio": bound.hardness_ratios[name],
                "factor": bound.factors.get(name),
                "factor_at_half_load": bound.at_half_load.get(name),
            }
            for name, slope in bound.slopes.items()
        },
        "uncertainty": UNCERTAINTY,
        "words": _words(bound, found),
    }


def _words(bound: RunInBound, found: Document) -> str:
    """What running in does, in sentences; or why that is not known."""
    slope = "rms slope of the profile" if bound.strips else "rms gradient"
    if bound.refused:
        return f"Run in: not known, {bound.refused} (h' is the {slope} of the waves that the contact feels)."
    factors = ", ".join(f"{name} {factor:.2f}" for name, factor in bound.factors.items())
    said = (
        f"Run in at this load, peaks flattened where they were pressed beyond the hardness: asperities {factors} times "
        f"as stiff, ±{100.0 * UNCERTAINTY:.0f} %, by H/(E h') with the {slope} h' that the measurement resolves"
    )
    stiffness, drift = found.get("assembly_Nm_per_rad"), found.get("drift_rad_per_output_turn")
    if stiffness is None or drift is None:
        return f"{said}. The joint has no state there."
    digits = f"{stiffness:.4g}" if stiffness < 9999.5 else f"{stiffness:.0f}"
    turned = format_quantity(drift, "arcmin", 4)
    return f"{said}. The assembled stiffness is then {digits} N·m/rad, the drift {turned} per output turn."
