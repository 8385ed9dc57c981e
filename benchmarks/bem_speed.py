"""Boundary elements beside Tamaas and ContactMechanics: the same rough contact, in the same run.

    python benchmarks/bem_speed.py                   (needs: pip install asperity[benchmark])
    python benchmarks/bem_speed.py --points 256 --only-ours

Solves one periodic contact (self-affine, Hurst exponent 0.8, waves from a quarter of the period down to four pixels,
rms slope 1, mean pressure 0.05 E) with each program to a tolerance of 1e-8, each in processes of its own with one and
with two threads and judged by its best setting, and compares everybody's pressures with a solution of ours to
1e-11. Then the tangential stick stiffness of that contact. Runs unchanged on a GPU: JAX takes the one it finds.

The programs define their tolerances differently: ours bounds the rms gap inside the contact over the
pressure-weighted mean displacement, Tamaas its product of gap and pressure, ContactMechanics the largest
penetration (here 1e-8 rms heights). The column of pressure differences shows what each tolerance was worth.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

MEAN_PRESSURE = 0.05
TOLERANCE = 1e-8
POISSON_RATIO = 0.3


def rough_surface(points: int, seed: int = 0) -> np.ndarray:
    """Heights on the unit square, rms slope 1."""
    rng = np.random.default_rng(seed)
    q = 2.0 * np.pi * np.fft.fftfreq(points, 1.0 / points)
    qx, qy = np.meshgrid(q, q[: points // 2 + 1], indexing="ij")
    size = np.hypot(qx, qy)
    band = (size > 0.0) & (size <= 2.0 * np.pi * points / 4)
    amplitude = np.zeros_like(size)
    amplitude[band] = np.maximum(size[band], 2.0 * np.pi * 4) ** -1.8
    spectrum = amplitude * np.fft.rfft2(rng.standard_normal((points, points)))
    slopes = [np.fft.irfft2(1j * k * spectrum, s=(points, points)) for k in (qx, qy)]
    return np.fft.irfft2(spectrum, s=(points, points)) / np.sqrt(sum(np.mean(s**2) for s in slopes))


def best_of(repeats, run):
    """Shortest wall time and the last result."""
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        result = run()
        times.append(time.perf_counter() - start)
    return min(times), result


def measure_asperity(heights, repeats, folder):
    import jax

    jax.config.update("jax_enable_x64", True)
    from asperity.bem import ElasticPair, PeriodicHalfSpace, normal_contact, tangential_stiffness

    n = heights.shape[0]
    pair = ElasticPair(
        contact_modulus=1.0, antiplane_modulus=0.5 * (1.0 - POISSON_RATIO), dundurs_constant=0.0
    )
    half_space = PeriodicHalfSpace(pair, shape=(n, n), pixel_size=(1.0 / n, 1.0 / n))

    def solve(tolerance=TOLERANCE):
        found = normal_contact(half_space, heights, normal_force=MEAN_PRESSURE, tolerance=tolerance)
        return jax.block_until_ready(found)

    def shear():
        return jax.block_until_ready(tangential_stiffness(half_space, contact.pressure > 0.0, axis=0))

    contact = solve()
    shear()
    normal_times, shear_times = [], []
    for _ in range(repeats):  # interleaved, so that a busy machine is equally unfair to both
        normal_times.append(best_of(1, solve)[0])
        seconds, stiffness = best_of(1, shear)
        shear_times.append(seconds)
    reference = solve(1e-11)
    np.save(folder / "reference.npy", np.asarray(reference.pressure))
    return {
        "seconds": min(normal_times),
        "iterations": int(contact.iterations),
        "mean_gap": float(contact.mean_gap),
        "pressure": np.asarray(contact.pressure),
        "shear_seconds": min(shear_times),
        "shear_iterations": int(stiffness.iterations),
        "shear_stiffness": float(stiffness.stiffness),
        "shear_error": float(stiffness.error_estimate),
        "device": str(jax.devices()[0]),
    }


def measure_tamaas(heights, repeats, folder):
    import tamaas as tm

    tm.set_log_level(tm.LogLevel.error)
    tm.initialize(int(os.environ["OMP_NUM_THREADS"]))
    n = heights.shape[0]

    def solve():
        model = tm.ModelFactory.createModel(tm.model_type.basic_2d, [1.0, 1.0], [n, n])
        model.E, model.nu = 1.0, 0.0
        by_pressure = tm.PolonskyKeerRey.pressure
        solver = tm.PolonskyKeerRey(
            model, heights, TOLERANCE, primal_type=by_pressure, constraint_type=by_pressure
        )
        solver.max_iter = 10000
        solver.solve(MEAN_PRESSURE)
        return model

    seconds, model = best_of(repeats, solve)
    pressure = np.array(model.traction)
    gap = np.array(model.displacement) - heights
    return {
        "seconds": seconds,
        "iterations": None,
        "mean_gap": (gap - gap.min()).mean(),
        "pressure": pressure,
    }


def measure_contact_mechanics(heights, repeats, folder):
    from ContactMechanics import PeriodicFFTElasticHalfSpace
    from ContactMechanics.Optimization import constrained_conjugate_gradients
    from SurfaceTopography import Topography

    n = heights.shape[0]
    substrate = PeriodicFFTElasticHalfSpace((n, n), 1.0, (1.0, 1.0))
    topography = Topography(heights, (1.0, 1.0))

    def solve():
        return constrained_conjugate_gradients(
            substrate,
            topography,
            external_force=MEAN_PRESSURE,
            pentol=TOLERANCE * heights.std(),
            thermotol=TOLERANCE,
        )

    seconds, result = best_of(repeats, solve)
    if not result.success:
        raise SystemExit("ContactMechanics did not converge")
    gap = np.array(result.x) - heights
    return {
        "seconds": seconds,
        "iterations": int(result.nit),
        "mean_gap": (gap - gap.min()).mean(),
        "pressure": np.array(result.jac) * n * n,
    }


PROGRAMS = {
    "asperity": measure_asperity,
    "tamaas": measure_tamaas,
    "ContactMechanics": measure_contact_mechanics,
}


def worker(program: str, arguments: argparse.Namespace) -> None:
    """Measure one program in this process and leave the numbers in the folder."""
    folder = Path(arguments.folder)
    row = PROGRAMS[program](rough_surface(arguments.points), arguments.repeats, folder)
    pressure = row.pop("pressure")
    row["area"] = float(np.mean(pressure > 0.0))
    np.save(folder / f"{program}.npy", pressure)
    print(json.dumps(row))


def measured(program: str, threads: int, arguments: argparse.Namespace) -> dict | None:
    """Run one program in a fresh process with so many threads."""
    environment = dict(os.environ, OMP_NUM_THREADS=str(threads), OPENBLAS_NUM_THREADS=str(threads))
    command = [sys.executable, __file__, "--worker", program, "--folder", arguments.folder]
    command += ["--points", str(arguments.points), "--repeats", str(arguments.repeats)]
    if hasattr(os, "sched_setaffinity"):
        processors = sorted(os.sched_getaffinity(0))[:threads]
        pin = f"import os, sys; os.sched_setaffinity(0, {processors}); os.execv(sys.argv[1], sys.argv[1:])"
        command = [sys.executable, "-c", pin, *command]
    run = subprocess.run(command, env=environment, capture_output=True, text=True)
    if run.returncode:
        reason = run.stderr.strip().splitlines()[-1] if run.stderr.strip() else f"exit code {run.returncode}"
        print(f"{program}: not measured: {reason}")
        return None
    return json.loads(run.stdout.strip().splitlines()[-1]) | {"threads": threads}


def main() -> None:
    import tempfile

    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--points", type=int, default=512, help="grid points along each side")
    parser.add_argument("--repeats", type=int, default=3, help="runs of each setting; the shortest counts")
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2], help="thread counts to try")
    parser.add_argument("--only-ours", action="store_true", help="do not run the other programs")
    parser.add_argument("--worker", choices=PROGRAMS, help=argparse.SUPPRESS)
    parser.add_argument("--folder", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.worker:
        worker(arguments.worker, arguments)
        return
    with tempfile.TemporaryDirectory() as folder:
        arguments.folder = folder
        rows = {}
        for program in ["asperity"] if arguments.only_ours else PROGRAMS:
            tries = [row for t in arguments.threads if (row := measured(program, t, arguments))]
            if tries:
                rows[program] = min(tries, key=lambda row: row["seconds"])
                rows[program]["pressure"] = np.load(Path(folder) / f"{program}.npy")
        reference = np.load(Path(folder) / "reference.npy")
    report(rows, reference, arguments.points)


def report(rows: dict, reference: np.ndarray, points: int) -> None:
    """Print the table, the ratios, and what was asked for."""
    ours = rows["asperity"]
    print(
        f"{points} x {points} points, rms slope 1, p/E = {MEAN_PRESSURE}, tolerance {TOLERANCE:g}", end=", "
    )
    print(f"device {ours['device']}")
    print(f"{'program':18s}{'threads':>8s}{'time [s]':>10s}{'iterations':>12s}{'area [-]':>13s}{'mean gap [-]':>14s}"
          f"{'max dp/max p [-]':>18s}{'time/ours':>11s}")  # fmt: skip
    for name, row in rows.items():
        difference = np.abs(row["pressure"] - reference).max() / reference.max()
        print(f"{name:18s}{row['threads']:8d}{row['seconds']:10.3f}{row['iterations'] or '-':>12}{row['area']:13.7f}"
              f"{row['mean_gap']:14.9f}{difference:18.1e}{row['seconds'] / ours['seconds']:11.1f}")  # fmt: skip
    error, iterations, seconds = (ours[f"shear_{what}"] for what in ("error", "iterations", "seconds"))
    print(
        f"\ntangential stick stiffness (nu = {POISSON_RATIO}): k = {ours['shear_stiffness']:.6f} E,", end=" "
    )
    print(f"estimated relative error {error:.0e}, {iterations} iterations, {seconds:.3f} s")
    checks = [("tangential time over normal time", ours["shear_seconds"] / ours["seconds"], "<", 0.5)]
    for name, least in (("tamaas", 6.0), ("ContactMechanics", 3.0)):
        if name in rows:
            row = rows[name]
            between = np.abs(row["pressure"] - ours["pressure"]).max() / reference.max()
            checks += [
                (f"{name}: its time over ours", row["seconds"] / ours["seconds"], ">", least),
                (f"{name}: difference of area", abs(row["area"] / ours["area"] - 1.0), "<", 1e-4),
                (f"{name}: difference of pressure over peak", between, "<", 1e-6),
            ]
    for what, value, relation, bound in checks:
        met = value > bound if relation == ">" else value < bound
        print(f"{what:45s}{value:11.3g}  asked {relation} {bound:g}: {'met' if met else 'NOT met'}")


if __name__ == "__main__":
    main()
