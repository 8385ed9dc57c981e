"""How well D and G of known surfaces are recovered: the three tables of docs/surface_recovery.md.

Run ``python benchmarks/surface_recovery.py --repeats 40`` for the figures of the docs, fewer repeats for a
quick look, ``--table`` for one of the tables. Surfaces are made by generators that share no code with the
estimators but the conversion constants, which tests check against direct sums.
"""

from __future__ import annotations

import argparse
import multiprocessing
import os

import numpy as np

POINTS = 10_000
PROFILES = 10
DIMENSIONS = (1.1, 1.3, 1.5, 1.7, 1.9)
ROUGHNESSES = (1e-12, 1e-10, 1e-8)  # m, in turn
SPACINGS = (0.05e-6, 0.1e-6, 0.5e-6)  # m, in turn
CONFIDENCE = 0.95
ROLL_OFF = 40e-6  # m
BEND_POINTS = 4096
BEND_SPACING = 0.1e-6  # m


def rolled_off(
    kind: str, D: float, G: float, spacing: float, points: int, random: np.random.Generator
) -> np.ndarray:
    """Gaussian profile with K-correlation or a flat spectrum above ROLL_OFF, cut from a longer period."""
    n = 8 * points
    f = np.fft.rfftfreq(n, spacing)[1:]
    square = f**2 + ROLL_OFF**-2 if kind == "K-correlation" else np.maximum(f, 1.0 / ROLL_OFF) ** 2
    density = np.concatenate([[0.0], 0.5 * G ** (2.0 * (D - 1.0)) * square ** (D - 2.5)])
    white = np.fft.rfft(random.standard_normal(n))
    return np.fft.irfft(white * np.sqrt(density / (2.0 * spacing)), n=n)[:points]


def profiles(
    kind: str,
    D: float,
    G: float,
    spacing: float,
    points: int,
    random: np.random.Generator,
    count: int = PROFILES,
) -> np.ndarray:
    """Profiles of one kind."""
    from asperity.surface import synthesis

    common = {"points": points, "spacing": spacing, "random": random}
    common |= {"fractal_dimension": D, "fractal_roughness": G}
    if kind in ("K-correlation", "flat"):
        return np.array([rolled_off(kind, D, G, spacing, points, random) for _ in range(count)])
    if kind == "row quarters":  # the amplitude of the differences changes from quarter to quarter
        share = np.repeat([0.5, 1.0, 1.5, 2.0], points // 4 + 1)[: points - 1]
        share /= np.sqrt(np.mean(share**2))  # the mean power, and with it G, stay
        z = np.array([synthesis.self_affine_profile(**common) for _ in range(count)])
        return np.concatenate([np.zeros((count, 1)), np.cumsum(share * np.diff(z), axis=1)], axis=1)
    if kind == "self-affine":
        return np.array([synthesis.self_affine_profile(**common) for _ in range(count)])
    if kind == "band-limited":
        return np.array([synthesis.spectral_profile(**common, periodic=False) for _ in range(count)])
    from asperity.surface.weierstrass import weierstrass_mandelbrot_profile

    terms = int(np.log(points / 2) / np.log(1.5)) + 1
    heights = np.array(
        [
            np.asarray(
                weierstrass_mandelbrot_profile(
                    position=np.arange(points) * spacing,
                    profile_length=points * spacing,
                    fractal_dimension=D,
                    fractal_roughness=G,
                    frequency_ratio=1.5,
                    phases=random.uniform(0.0, 2.0 * np.pi, terms),
                    lowest_index=0,
                )
            )
            for _ in range(count)
        ]
    )
    if kind == "W-M + 1 % noise":
        heights += 0.01 * heights.std() * random.standard_normal(heights.shape)
    return heights


def instrument(effect: str, heights: np.ndarray, spacing: float, random: np.random.Generator) -> np.ndarray:
    """The same profiles through an imperfect instrument; sizes are shares of the rms height, or a radius in um."""
    import scipy.ndimage

    rms = float(heights.std(axis=1).mean())
    kind, size = effect.split(" ")[0], float(effect.split(" ")[1])
    if kind == "noise":
        return heights + size * rms * random.standard_normal(heights.shape)
    if kind == "quantised":
        return np.round(heights / (size * rms)) * (size * rms)
    if kind == "tip":  # a parabola of radius size (in um) rolls over the profile
        radius = size * 1e-6
        half = min(int(np.sqrt(2.0 * radius * 8.0 * rms) / spacing) + 1, 400)
        x = np.arange(-half, half + 1) * spacing
        return np.array([scipy.ndimage.grey_dilation(z, structure=-(x**2) / (2.0 * radius)) for z in heights])
    if kind == "scratches":  # twelve valleys of 1 to 4 um width in each profile
        x, heights = np.arange(heights.shape[1]) * spacing, heights.copy()
        for z in heights:
            for width, place in zip(
                random.uniform(1e-6, 4e-6, 12), random.uniform(0.0, x[-1], 12), strict=True
            ):
                z -= size * rms * np.maximum(1.0 - 2.0 * np.abs(x - place) / width, 0.0)
    return heights


def one(task: tuple) -> tuple | None:
    """One estimate: errors of D and log10 G, and whether the intervals cover the truth."""
    import jax

    jax.config.update("jax_enable_x64", True)
    from asperity.errors import NoSolutionError
    from asperity.surface.fractal_fit import fractal_fit

    kind, estimator, D, points, count, effect, repeat = task
    random = np.random.default_rng([repeat, int(100 * D), points, len(kind), count])
    G, spacing = ROUGHNESSES[repeat % 3], SPACINGS[(repeat // 3) % 3]
    if effect:
        G, spacing = 1e-10, BEND_SPACING
    heights = profiles(kind, D, G, spacing, points, random, count)
    if effect:
        heights = instrument(effect, heights, spacing, random)
    try:
        fit = fractal_fit(
            profiles=heights, spacing=spacing, estimator=estimator, frequency_ratio=1.5, rows_of_a_map=False
        )
    except NoSolutionError:
        return None
    low, high = fit.dimension_interval(confidence=CONFIDENCE)
    g_low, g_high = fit.roughness_interval(confidence=CONFIDENCE)
    return (
        fit.fractal_dimension - D,
        (fit.log_roughness - np.log(G)) / np.log(10.0),
        low <= D <= high,
        g_low <= G <= g_high,
        np.log10(fit.longest_wavelength / fit.shortest_wavelength),
        fit.estimator == "lines",
    )


def row(label: str, outcomes: list) -> str:
    """One line of a table."""
    good = np.array([o for o in outcomes if o is not None], dtype=float)
    refused = len(outcomes) - len(good)
    if len(good) == 0:
        return f"| {label} | – | – | – | – | – | – | – | {refused}/{len(outcomes)} |"
    b, g, cd, cg, decades, _ = good.mean(axis=0)
    sd, sg = good[:, 0].std(), good[:, 1].std()
    return (
        f"| {label} | {b:+.1e} | {sd:.1e} | {100 * cd:.0f} % | {g:+.1e} | {sg:.1e} | {100 * cg:.0f} % "
        f"| {decades:.1f} | {refused}/{len(outcomes)} |"
    )


HEADER = (
    "| surface, estimator, profiles x points | D | bias of D | scatter of D | D covered | bias of lg G | "
    "scatter of lg G | G covered | band [decades] | refused |\n|---|---|---|---|---|---|---|---|---|---|"
)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--repeats", type=int, default=100)
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--table", choices=["recovery", "bends", "instrument"])
    arguments = parser.parse_args()
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    recovery = [
        ("self-affine", "automatic", POINTS),
        ("band-limited", "automatic", POINTS),
        ("W-M", "automatic", POINTS),
        ("W-M + 1 % noise", "automatic", POINTS),
        ("self-affine", "automatic", 1000),
        ("self-affine", "structure_function", POINTS),
        ("band-limited", "power_spectrum", POINTS),
    ]
    sizes = {
        "none": (0,),
        "noise": (0.001, 0.01, 0.1),
        "quantised": (0.01, 0.1),
        "tip": (2, 10),
        "scratches": (0.03, 0.1, 0.3),
    }
    effects = [f"{kind} {size}" for kind, all_sizes in sizes.items() for size in all_sizes]
    with multiprocessing.get_context("spawn").Pool(arguments.processes) as pool:
        if arguments.table in (None, "recovery"):
            print(HEADER)
            for kind, estimator, points in recovery:
                for D in DIMENSIONS:
                    tasks = [(kind, estimator, D, points, PROFILES, "", r) for r in range(arguments.repeats)]
                    label = f"{kind}, {estimator}, {PROFILES} x {points} | {D}"
                    print(row(label, pool.map(one, tasks, chunksize=5)), flush=True)
        if arguments.table in (None, "bends"):
            print("\n" + HEADER.replace("estimator, profiles x points", "noise, profiles"))
            for kind in ("K-correlation", "flat", "row quarters"):
                for count in (1, PROFILES):
                    for noise in (0.0, 0.02):
                        for D in (1.3, 1.5, 1.7):
                            tasks = [
                                (kind, "likelihood", D, BEND_POINTS, count, f"noise {noise}", r)
                                for r in range(arguments.repeats)
                            ]
                            label = f"{kind}, noise {noise:g}, {count} | {D}"
                            print(row(label, pool.map(one, tasks, chunksize=5)), flush=True)
        if arguments.table in (None, "instrument"):
            print("\n" + HEADER.replace("surface, estimator, profiles x points", "effect"))
            for effect in effects:
                for D in (1.2, 1.5, 1.8):
                    tasks = [
                        ("self-affine", "automatic", D, POINTS, PROFILES, effect, r)
                        for r in range(max(5, arguments.repeats // 4))
                    ]
                    print(row(f"{effect} | {D}", pool.map(one, tasks, chunksize=5)), flush=True)


if __name__ == "__main__":
    main()
