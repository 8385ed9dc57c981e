"""A rough steel patch by boundary elements: area, stiffness both ways, and the shear it takes to slip.

Run it: ``python examples/bem_partial_slip.py``.
"""

import numpy as np

from asperity.bem import (
    PeriodicHalfSpace,
    elastic_pair,
    normal_contact,
    normal_stiffness,
    partial_slip,
    tangential_stiffness,
)
from asperity.precision import use_compilation_cache, use_double_precision
from asperity.surface.synthesis import spectral_surface


def main() -> dict[str, float]:
    use_double_precision()
    use_compilation_cache()
    points, side = 64, 0.5e-3
    pixel = side / points
    steel = elastic_pair(
        youngs_modulus_1=206e9, youngs_modulus_2=206e9, poisson_ratio_1=0.3, poisson_ratio_2=0.3
    )
    half_space = PeriodicHalfSpace(steel, shape=(points, points), pixel_size=(pixel, pixel))
    heights = spectral_surface(
        rows=points,
        columns=points,
        spacing=pixel,
        fractal_dimension=1.2,
        areal_fractal_roughness=1e-16,
        periodic=True,
        random=np.random.default_rng(7),
    )
    load, friction = 50.0, 0.12
    contact = normal_contact(half_space, heights, normal_force=load)
    touching = contact.pressure > 0.0
    normal = float(normal_stiffness(half_space, touching).stiffness)
    along = [float(tangential_stiffness(half_space, touching, axis=axis).stiffness) for axis in (0, 1)]
    tangential = 0.5 * sum(along)
    shares = np.array([0.25, 0.5, 0.75, 0.95])
    slip = partial_slip(
        half_space,
        contact.pressure,
        friction_coefficient=friction,
        axis=0,
        tangential_force=shares * friction * load,
    )
    print(f"real contact area: {100.0 * float(contact.contact_fraction):.2f} % of the patch")
    print(
        f"normal stiffness: {normal / 1e6:.1f} N/µm, tangential: {along[0] / 1e6:.1f} and {along[1] / 1e6:.1f} N/µm"
    )
    print(f"tangential (mean of both directions) over normal: {tangential / normal:.4f}")
    for share, displacement, stick in zip(shares, slip.displacement, slip.stick_fraction, strict=True):
        moved, sticks = float(displacement) * 1e9, 100.0 * float(stick)
        print(f"T = {share:.2f} mu F: displacement {moved:.2f} nm, sticks {sticks:.0f} % of the contact area")
    return {"ratio": tangential / normal, "stick_at_95": float(slip.stick_fraction[-1])}


if __name__ == "__main__":
    main()
