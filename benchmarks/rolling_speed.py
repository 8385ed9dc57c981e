"""Transient rolling of a line contact beside a dense direct solution of every step.

    python benchmarks/rolling_speed.py

Both take the same steps, from the standing contact on, and must agree. The dense program keeps the list of points that
stick or slip from the step before, corrects it until it fits, and solves the equations of the sticking points by LU
factorisation (SciPy): the plain way to write Kalker's method. Ratios of one run; the machine's load hardly matters.
"""

import argparse
import time

import jax
import numpy as np
import scipy.linalg

jax.config.update("jax_enable_x64", True)

from asperity.bem import ElasticPair, FreeHalfSpace, steady_rolling, transient_rolling  # noqa: E402


def elliptic_pressure(cells: int) -> np.ndarray:
    edge = np.linspace(-1.0, 1.0, cells + 1)
    return np.diff(0.5 * (edge * np.sqrt(1.0 - edge**2) + np.arcsin(edge))) * cells / 2.0


def dense_history(pressure: np.ndarray, pixel: float, steps: int, force: float) -> tuple[np.ndarray, int]:
    """Creepage of every step, and the number of factorisations."""
    n = pressure.size

    def kernel(x):
        return x * (1.0 - np.log(np.abs(x) / 10.0))

    distance = (np.arange(n + 1)[:, None] - np.arange(n)) * pixel
    response = (kernel(distance + pixel / 2) - kernel(distance - pixel / 2)) / np.pi
    A, ahead = response[:n], response[1:]
    state, traction, rigid = np.zeros(n, dtype=int), np.zeros(n), 0.0
    creepage, solved = np.full(steps, np.nan), 0
    for step in range(steps):
        target = np.zeros(n) if step == 0 else ahead @ traction - rigid
        for _ in range(100):
            stick = state == 0
            m = int(stick.sum())
            matrix = np.zeros((m + 1, m + 1))
            matrix[:m, :m], matrix[:m, m], matrix[m, :m] = A[np.ix_(stick, stick)], -1.0, pixel
            slipping = np.where(stick, 0.0, state * pressure)
            right = np.append((target - A @ slipping)[stick], force - slipping.sum() * pixel)
            found = scipy.linalg.lu_solve(scipy.linalg.lu_factor(matrix), right)
            solved += 1
            new = slipping
            new[stick] = found[:m]
            slip = A @ new - found[m] - target
            trial = new - 0.01 * slip / pixel  # small: a point that slipped sticks before it slips back
            changed = np.where(trial > pressure, 1, np.where(trial < -pressure, -1, 0))
            if np.array_equal(changed, state):
                break
            state = changed
        if step:
            creepage[step] = (found[m] - rigid) / pixel
        traction, rigid = new, found[m]
    return creepage, solved


def best_of(repeats: int, run):
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        result = run()
        times.append(time.perf_counter() - start)
    return min(times), result


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--cells", type=int, default=400, help="cells across the contact")
    parser.add_argument("--steps", type=int, default=200, help="steps of one cell")
    parser.add_argument("--repeats", type=int, default=3, help="runs of each; the shortest counts")
    arguments = parser.parse_args()
    n, steps, pixel = arguments.cells, arguments.steps, 2.0 / arguments.cells
    pair = ElasticPair(contact_modulus=2.0, antiplane_modulus=0.7, dundurs_constant=0.0)
    strip = FreeHalfSpace(pair, shape=(n + 2,), pixel_size=(pixel,), reference_distance=10.0)
    pressure = elliptic_pressure(n)
    force = 0.5 * pixel * pressure.sum()

    def ours():
        found = transient_rolling(
            strip,
            np.pad(pressure, 1),
            friction_coefficient=1.0,
            axis=0,
            rolled_pixels=np.r_[0, np.ones(steps - 1, dtype=int)],
            layer_compliance=0.0,
            tangential_force=np.full(steps, force),
        )
        return np.asarray(found.creepage), float(np.mean(np.asarray(found.shear.iterations)))

    def steady():
        found = steady_rolling(
            strip,
            np.pad(pressure, 1),
            friction_coefficient=1.0,
            layer_compliance=0.0,
            longitudinal_force=force,
            lateral_creepage=0.0,
        )
        return float(found.creepage[0]), int(found.iterations)

    first, _ = best_of(1, ours)
    steady()
    seconds, (creepage, iterations) = best_of(arguments.repeats, ours)
    steady_seconds, (level, newton) = best_of(arguments.repeats, steady)
    dense_seconds, (check, solved) = best_of(
        arguments.repeats, lambda: dense_history(pressure, pixel, steps, force)
    )
    print(f"{n} cells, {steps} steps, device {jax.devices()[0]}")
    print(f"transient, first call (compiles)        {first:9.3f} s")
    print(f"transient, later calls                  {seconds:9.3f} s, {iterations:.1f} iterations a step")
    print(
        f"dense direct solution of every step     {dense_seconds:9.3f} s, {solved / steps:.1f} factorisations a step"
    )
    print(f"its time over ours                      {dense_seconds / seconds:9.1f}")
    print(f"largest difference of the creepage      {np.nanmax(np.abs(creepage / check - 1.0)):9.1e}")
    print(
        f"steady state by Newton's method         {steady_seconds:9.3f} s, {newton} steps, creepage {level:.6f}"
    )
    print(f"asked: below 1 s: {'met' if seconds < 1.0 else 'NOT met'}")


if __name__ == "__main__":
    main()
