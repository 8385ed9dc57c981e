"""Time of a full estimate and of the generators; prints seconds, best of three."""

from __future__ import annotations

import time

import numpy as np


def best(function, repeats=3):
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        function()
        times.append(time.perf_counter() - start)
    return min(times)


def main() -> None:
    import jax

    jax.config.update("jax_enable_x64", True)
    from asperity.surface import synthesis
    from asperity.surface.fractal_fit import fractal_fit
    from asperity.surface.structure_function import logarithmic_lags, structure_functions

    random = np.random.default_rng(0)
    fractal = {"spacing": 1e-7, "fractal_dimension": 1.4}
    common = {"estimator": "automatic", "frequency_ratio": 1.5, "spacing": 1e-7}
    line = synthesis.self_affine_profile(points=1_000_000, fractal_roughness=1e-10, random=random, **fractal)
    print(
        f"estimate of a profile of 1e6 points  "
        f"{best(lambda: fractal_fit(profiles=line[None], rows_of_a_map=False, **common)):.2f} s"
    )

    def spectral():
        return synthesis.spectral_surface(
            rows=4096, columns=4096, areal_fractal_roughness=1e-10, periodic=True, random=random, **fractal
        )

    print(f"spectral map, 4096 x 4096            {best(spectral, 2):.2f} s")
    surface = spectral()
    print(
        f"estimate of a map of 4096 x 4096     "
        f"{best(lambda: fractal_fit(profiles=surface, rows_of_a_map=True, **common), 2):.2f} s"
    )
    lags = logarithmic_lags(points=4096, per_decade=15, longest_fraction=0.5)
    print(
        f"structure functions of its rows      "
        f"{best(lambda: structure_functions(profiles=surface, lags=lags), 2):.2f} s"
    )


if __name__ == "__main__":
    main()
