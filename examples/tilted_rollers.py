"""How two steel rollers whose axes are tilted carry their load: along their line, and over the tilt.

Rollers of 10 and 20 mm radius and 10 mm length under 2000 N, as cylinders and with profiles.

Run it: ``python examples/tilted_rollers.py [picture.png]``.
"""

import sys
from pathlib import Path

import numpy as np
from matplotlib import rc_context
from matplotlib.figure import Figure

from asperity.contact.hertz_line import effective_radius, half_width
from asperity.contact.roller_profiles import (
    iso_16281_coefficient,
    johns_gohar_share,
    logarithmic_profile,
    lundberg_coefficient,
)
from asperity.contact.tilted_line import PLACES, ProfiledLine, profiled_line
from asperity.engine.control import at_once
from asperity.materials import contact_modulus
from asperity.show.style import ACCENT, MARK, MUTED, STYLE

PICTURE = Path(__file__).parents[1] / "docs" / "images" / "tilted_rollers.png"
LENGTH, FORCE = 10e-3, 2000.0
MODULUS = contact_modulus(
    youngs_modulus_1=206e9, youngs_modulus_2=206e9, poisson_ratio_1=0.3, poisson_ratio_2=0.3
)
RADIUS = effective_radius(radius_1=10e-3, radius_2=20e-3, sign=1.0)
PAIR = {
    "normal_force": FORCE,
    "contact_length": LENGTH,
    "effective_radius": RADIUS,
    "contact_modulus": MODULUS,
}
LUNDBERG = lundberg_coefficient(line_load=FORCE / LENGTH, contact_modulus=MODULUS)
#: Gaps of the profiles without a tilt [m].
PROFILES = {
    "cylinders": 0.0 * PLACES,
    "Lundberg": logarithmic_profile(coefficient=LUNDBERG, end_share=1.0),
    "Johns and Gohar": logarithmic_profile(
        coefficient=LUNDBERG,
        end_share=johns_gohar_share(even_half_width=half_width(**PAIR), contact_length=LENGTH),
    ),
    "ISO/TS 16281": logarithmic_profile(
        coefficient=iso_16281_coefficient(roller_diameter=20e-3), end_share=1.0
    ),
    "crown of 2 m": (LENGTH * PLACES) ** 2 / 4.0,
}
#: Tilts of the curves along the line [mrad].
SHOWN = (0.0, 0.25, 0.5, 1.0)


def loaded(profile: str, tilt: float) -> ProfiledLine:
    """The pair with a profile under a tilt [mrad]."""
    gap = np.asarray(PROFILES[profile]) - 1e-3 * tilt * LENGTH * PLACES
    return at_once(lambda some: profiled_line(gap=some, **PAIR), gap)


def draw(tilts: np.ndarray, peaks: dict[str, list[float]]) -> Figure:
    with rc_context(STYLE):
        figure = Figure(figsize=(9.6, 4.0), layout="constrained")
        left, right = figure.subplots(1, 2)
        for tilt, shade in zip(SHOWN, np.linspace(0.25, 1.0, len(SHOWN)), strict=True):
            for profile, color in (("cylinders", ACCENT), ("Lundberg", MARK)):
                label = f"{profile}, {tilt:g} mrad"
                load = 1e-3 * loaded(profile, tilt).line_load
                left.plot(1e3 * LENGTH * PLACES, load, color=color, alpha=shade, label=label)
        left.set_title("A tilt loads one end, unless a profile frees it")
        left.set_xlabel("place along the line [mm]")
        left.set_ylabel("line load [N/mm]")
        left.set_ylim(0.0, None)
        left.legend(fontsize=7)
        for number, (profile, values) in enumerate(peaks.items()):
            color = MUTED if profile == "cylinders" else ACCENT if number % 2 else MARK
            right.plot(tilts, values, color=color, alpha=1.0 - 0.15 * number, label=profile)
        right.set_title("Peak of the line load over its mean")
        right.set_xlabel("tilt [mrad]")
        right.set_ylabel("peak over mean [-]")
        right.set_ylim(0.0, None)
        right.legend()
    return figure


def main(picture: Path = PICTURE) -> dict[str, list[float]]:
    tilts = np.linspace(0.0, 1.5, 16)
    mean = FORCE / LENGTH
    peaks = {
        profile: [float(np.max(loaded(profile, tilt).line_load)) / mean for tilt in tilts]
        for profile in PROFILES
    }
    draw(tilts, peaks).savefig(picture, dpi=150)
    for profile in PROFILES:
        for tilt in (0.0, 0.5):
            line = loaded(profile, tilt)
            end = float(line.end_line_load) / mean
            state = "edge" if end > 0.0 else "ends free"
            peak = 1e-6 * float(line.peak_pressure)
            print(
                f"{profile}, {tilt:g} mrad: {peak:.1f} MPa in slices, {end:.3f} of the mean at an end, {state}"
            )
    return peaks


if __name__ == "__main__":
    main(*(Path(argument) for argument in sys.argv[1:2]))
