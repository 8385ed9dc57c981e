"""From profiles to D, G and their intervals: ten synthetic profiles of D = 1.5 and G = 1 nm."""

import numpy as np

from asperity.precision import use_double_precision
from asperity.surface.fractal_fit import FractalFit, fractal_fit
from asperity.surface.synthesis import self_affine_profile


def main() -> FractalFit:
    use_double_precision()
    random = np.random.default_rng(2025)
    profiles = np.array(
        [
            self_affine_profile(
                points=4000, spacing=0.2e-6, fractal_dimension=1.5, fractal_roughness=1e-9, random=random
            )
            for _ in range(10)
        ]
    )
    fit = fractal_fit(
        profiles=profiles, spacing=0.2e-6, estimator="automatic", frequency_ratio=1.5, rows_of_a_map=False
    )
    low, high = fit.dimension_interval(confidence=0.95)
    g_low, g_high = fit.roughness_interval(confidence=0.95)
    print(f"D = {fit.fractal_dimension:.4f}  (95 %: {low:.4f} .. {high:.4f})")
    print(f"G = {fit.fractal_roughness:.3g} m  (95 %: {g_low:.3g} .. {g_high:.3g} m)")
    print(
        f"band {1e6 * fit.shortest_wavelength:.3g} .. {1e6 * fit.longest_wavelength:.3g} um, {fit.estimator}"
    )
    return fit


if __name__ == "__main__":
    main()
