"""Rz over Ra of normally distributed heights, simulated: source of the fits of asperity.surface.roughness_average.

    python benchmarks/roughness_depth.py [--profiles 200]

Prints for each ratio of the cut-offs and each D the simulated ratio with its standard error, the relative scatter of Rz
over one evaluation length, and how far the fits lie from both.
"""

import argparse

import numpy as np

from asperity.surface.roughness_average import depth_over_average, scatter_of_depth

#: Ratio of the cut-offs -> a long-wave cut-off of the standard with this ratio [m].
CUT_OFFS = {32: 0.08e-3, 100: 0.25e-3, 320: 0.8e-3}
DIMENSIONS = (1.01, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 1.99)
SAMPLES_PER_SHORT_CUT_OFF = 6.4
LENGTHS, EVALUATED = 34, 30  # sampling lengths of a periodic profile, and those of them that are evaluated


def simulated(
    rng: np.random.Generator, dimension: float, ratio: int, profiles: int
) -> tuple[np.ndarray, np.ndarray]:
    """Ra and Rz of each evaluation length of five sampling lengths, the cut-off as the unit of length."""
    points = round(SAMPLES_PER_SHORT_CUT_OFF * ratio)
    frequency = np.fft.rfftfreq(LENGTHS * points, 1.0 / points)
    amplitude = np.zeros_like(frequency)
    amplitude[1:] = frequency[1:] ** (-0.5 - (2.0 - dimension))
    amplitude *= (1.0 - 2.0 ** -(frequency**2)) * 2.0 ** -((frequency / ratio) ** 2)
    averages, depths = [], []
    for _ in range(profiles):
        noise = rng.standard_normal(frequency.size) + 1j * rng.standard_normal(frequency.size)
        heights = np.fft.irfft(amplitude * noise, LENGTHS * points)[: EVALUATED * points].reshape(
            -1, 5, points
        )
        depths.append((heights.max(axis=2) - heights.min(axis=2)).mean(axis=1))
        averages.append(np.abs(heights).mean(axis=(1, 2)))
    return np.concatenate(averages), np.concatenate(depths)


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--profiles", type=int, default=200, help="profiles of six evaluation lengths each")
    given = parser.parse_args()
    rng = np.random.default_rng(11)
    print("cut-offs     D    Rz/Ra  standard error  fit, %   scatter of Rz  fit less it")
    for ratio, cut_off in CUT_OFFS.items():
        for dimension in DIMENSIONS:
            average, depth = simulated(rng, dimension, ratio, given.profiles)
            found, scatter = depth.mean() / average.mean(), depth.std() / depth.mean()
            error = found * np.std(depth / depth.mean() - average / average.mean()) / np.sqrt(depth.size)
            known = {"fractal_dimension": dimension, "cut_off": cut_off}
            off = 100.0 * (depth_over_average(**known) / found - 1.0)
            print(
                f"{ratio:8d}  {dimension:4.2f}  {found:7.3f}  {error:14.3f}  {off:+6.2f}  {scatter:14.4f}  "
                f"{scatter_of_depth(**known) - scatter:+.4f}"
            )


if __name__ == "__main__":
    main()
