"""Speed of the published model for many joints: rate, unavoidable cost, memory, gradient, distance to the script.

    python benchmarks/batch.py [--points 1e7] [--chunk 8192] [--repeats 15]

One evaluation is one joint by equations (1) to (30): forces, the five contacts' tangential stiffnesses, K_T and
whether the balance closed. The general chain: ``planar_batch.py``. Every figure is the best of several repeats,
measured in this one run, because wall times on a shared machine only ever err upwards. Points are generated chunk by
chunk from a seed and reduced chunk by chunk (mean, smallest, largest K_T): any number of them fits into memory.
"""

import argparse
import os
import resource
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

# one XLA thread per Python thread: the chunks, not the loops inside them, are what runs side by side
os.environ["XLA_FLAGS"] = os.environ.get("XLA_FLAGS", "") + " --xla_cpu_multi_thread_eigen=false"

import baseline_scipy
import jax
import jax.numpy as jnp
import numpy as np

from asperity.contact.laws.zou_2025 import Zou2025
from asperity.drive.layout.wedge_geometry import DriveGeometry
from asperity.materials import Material
from asperity.precision import use_double_precision
from asperity.zou2025.published import PublishedJoint, published_joint

NAMES = (
    "output_torque",
    "fractal_dimension",
    "log_fractal_roughness",
    "contact_length",
    "friction_coefficient",
    "preload",
)
LOW = np.array([0.5, 1.4, np.log(1e-12), 4e-3, 0.12, 800.0])
HIGH = np.array([5.0, 1.9, np.log(1e-11), 20e-3, 0.20, 2000.0])

# Exponentials and logarithms without which no method can evaluate the chain, per joint, counted by hand:
#   psi evaluated once 3 exp + 1 log, its power 1 exp, G from ln G 1 exp, a_c 1 log + 1 exp;
#   lambda of sp, pw and wo 1 log + 1 exp each;
#   five contacts: ln F 1 log, (A5) evaluated once 1 exp + 1 log, a_l 1 exp, (24) 1 exp, slip factor 1 log + 1 exp;
#   elastic closure evaluated once: 1 log per contact.
LOGS = 1 + 1 + 3 + 5 * 3 + 5
EXPS = 3 + 1 + 1 + 1 + 3 + 5 * 4
GRADIENT_BATCH = 4096


def joint_of(points: jax.Array) -> PublishedJoint:
    torque, dimension, log_roughness, length, friction, preload = points
    return PublishedJoint(
        geometry=DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.0, 0.0),
        material=Material(206e9, 0.3, 7850.0, 450e6, 1260e6),
        surface=Zou2025(dimension, jnp.exp(log_roughness), 1.5, "majumdar_bhushan_1991"),
        contact_length=length,
        friction_coefficient=friction,
        ring_wall_thickness=10e-3,
        preload=preload,
        output_torque=torque,
        sun_speed=6000 * np.pi / 30,
    )


def complete(points: jax.Array) -> dict[str, jax.Array]:
    found = published_joint(joint_of(points))
    return {
        "normal": found.forces.normal,
        "tangential": found.forces.tangential,
        "contact_stiffness": found.tangential_stiffness,
        "sun": found.stiffness.input,
        "output": found.stiffness.output,
        "solved": found.solved,
    }


def unavoidable(points: jax.Array) -> jax.Array:
    """LOGS logarithms and EXPS exponentials a point, each fed by the one before so that none can be dropped."""
    x = 0.5 + 0.1 * points[0]
    for _ in range(LOGS):
        x = jnp.log(x) + 2.0
    for _ in range(EXPS):
        x = jnp.exp(x - 2.0) + 0.5
    return x


def random_points(count: int, seed: int) -> np.ndarray:
    return np.random.default_rng(seed).uniform(LOW[:, None], HIGH[:, None], (len(NAMES), count))


def best(repeats: int, work) -> float:  # type: ignore[no-untyped-def]
    work()
    times = []
    for _ in range(repeats):
        started = time.perf_counter()
        work()
        times.append(time.perf_counter() - started)
    return min(times)


def compiled(function, points: jax.Array):  # type: ignore[no-untyped-def]
    program = jax.jit(function).lower(points).compile()
    return lambda x: jax.block_until_ready(program(x))


def side_by_side(program, batches: list[jax.Array], threads: int) -> None:  # type: ignore[no-untyped-def]
    if threads == 1:
        for batch in batches:
            program(batch)
        return
    with ThreadPoolExecutor(threads) as pool:
        list(pool.map(program, batches))


def stream(program, points: int, chunk: int, threads: int) -> tuple[float, float, float, float]:  # type: ignore[no-untyped-def]
    """Evaluate any number of points chunk by chunk; keep seconds, mean, smallest and largest K_T."""

    def one(seed: int) -> tuple[float, float, float]:
        result = np.asarray(program(jnp.asarray(random_points(chunk, seed)))["output"])
        return float(result.sum()), float(result.min()), float(result.max())

    started, total, low, high = time.perf_counter(), 0.0, np.inf, -np.inf
    chunks = -(-points // chunk)
    with ThreadPoolExecutor(threads) as pool:
        for first in range(0, chunks, 64):
            for part in pool.map(one, range(first, min(first + 64, chunks))):
                total, low, high = total + part[0], min(low, part[1]), max(high, part[2])
    return time.perf_counter() - started, total / (chunks * chunk), low, high


def baseline(points: np.ndarray, mine: dict[str, jax.Array], repeats: int) -> tuple[float, float]:
    """Seconds per joint of the script, and the largest relative difference from it."""
    worst, seconds = 0.0, np.inf
    for index, point in enumerate(points.T):
        case = dict(zip(NAMES, point.tolist(), strict=True))
        case["fractal_roughness"] = float(np.exp(case.pop("log_fractal_roughness")))
        case |= {"ring_wall": 10e-3, "normal_law": "nonlinear"}
        for _ in range(max(1, repeats // 4)):
            started = time.perf_counter()
            other = baseline_scipy.evaluate(case)
            seconds = min(seconds, time.perf_counter() - started)
        pairs = [(mine["sun"][index], other["sun"]), (mine["output"][index], other["output"])]
        for row, name in enumerate(baseline_scipy.CONTACTS):
            pairs.append((mine["normal"][row, index], other["forces"]["normal"][name]))
            pairs.append((mine["tangential"][row, index], other["forces"]["tangential"][name]))
            pairs.append((mine["contact_stiffness"][row, index], other["contacts"][name]["K_t"]))
        worst = max([worst, *(abs(float(a) - b) / abs(b) for a, b in pairs)])
    return seconds, worst


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument(
        "--points", type=float, default=1e7, help="points of the memory run (1e8 takes minutes)"
    )
    parser.add_argument("--chunk", type=int, default=8192, help="points evaluated at a time")
    parser.add_argument("--repeats", type=int, default=15, help="repeats of which the best counts")
    given = parser.parse_args()
    use_double_precision()
    load = os.getloadavg()[0]
    print(
        f"{os.cpu_count()} cores, load before the run {load:.1f} (above 0 the figures are too low), chunk {given.chunk}"
    )

    points = random_points(given.chunk, seed=0)
    batches = [jnp.asarray(random_points(given.chunk, seed)) for seed in range(16)]
    started = time.perf_counter()
    chain = compiled(complete, batches[0])
    print(f"compile                      {time.perf_counter() - started:8.1f} s")
    bare = compiled(unavoidable, batches[0])
    count = given.chunk * len(batches)
    floor = best(given.repeats, lambda: side_by_side(bare, batches, 1)) / count
    for threads in (1, 2):
        seconds = best(given.repeats, lambda n=threads: side_by_side(chain, batches, n)) / count
        print(f"joints a second, threads: {threads}  {1 / seconds:9.3g}   {seconds * 1e9:.0f} ns each")
        if threads == 1:
            single = seconds
    share = f"{LOGS} logs and {EXPS} exps: {floor / single:.0%} of a joint on one thread"
    print(f"exp and log alone            {floor * 1e9:8.0f} ns for {share}")

    gradient = compiled(
        lambda x: jax.value_and_grad(lambda x: jnp.sum(published_joint(joint_of(x)).stiffness.output))(x),
        batches[0],
    )
    # inputs and slopes of more joints at once do not fit into the processor's cache
    columns, value_of = all_inputs(batches[0][:, :GRADIENT_BATCH])
    value_of_all = compiled(value_of, columns)
    gradient_of_all = compiled(jax.value_and_grad(lambda x: jnp.sum(value_of(x))), columns)
    value = compiled(lambda x: published_joint(joint_of(x)).stiffness.output, batches[0])
    plain = best(given.repeats, lambda: value(batches[0]))
    few = best(given.repeats, lambda: gradient(batches[0]))
    plain_of_all = best(given.repeats, lambda: value_of_all(columns))
    every = best(given.repeats, lambda: gradient_of_all(columns))
    print(f"value and gradient / value   {few / plain:8.1f}   {len(NAMES)} varied inputs")
    print(
        f"                             {every / plain_of_all:8.1f}   all {len(columns)} inputs, each of them an array, "
        f"{GRADIENT_BATCH} at once"
    )

    few_points = random_points(6, seed=99)
    mine = jax.jit(complete)(jnp.asarray(few_points))
    script, worst = baseline(few_points, mine, given.repeats)
    print(
        f"SciPy script                 {script * 1e3:8.1f} ms each: {script / seconds:.2g} times as long (2 threads)"
    )
    print(
        f"largest relative difference  {worst:8.1e}   in forces, K_t and K_T of {few_points.shape[1]} joints"
    )
    print(f"every balance closed         {bool(jnp.all(chain(jnp.asarray(points))['solved']))!s:>8}")

    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    total = int(given.points)
    took, mean, low, high = stream(chain, total, given.chunk, 2)
    after = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    rate = f"{total / took:.3g} a second on 2 threads, random numbers included"
    print(f"streamed {total:.3g} points      {took:8.1f} s: {rate}")
    print(f"  K_T at the output: mean {mean:.4g}, smallest {low:.4g}, largest {high:.4g} N·m/rad")
    print(
        f"  peak memory {after:.0f} MiB, of which {after - before:.0f} came with this run; chunks follow each other"
    )


def all_inputs(points: jax.Array) -> tuple[list[jax.Array], Callable[[list[jax.Array]], jax.Array]]:
    """Every number of the joints as an array with one entry per point, and K_T as a function of these arrays."""
    leaves, tree = jax.tree.flatten(joint_of(points))
    finite = [isinstance(leaf, jax.Array) or np.isfinite(leaf) for leaf in leaves]

    def value(columns: list[jax.Array]) -> jax.Array:
        rest = iter(columns)
        whole = [next(rest) if keep else leaf for keep, leaf in zip(finite, leaves, strict=True)]
        return published_joint(jax.tree.unflatten(tree, whole)).stiffness.output

    columns = [
        jnp.full(points.shape[1:], leaf, float) for leaf, keep in zip(leaves, finite, strict=True) if keep
    ]
    return columns, value


if __name__ == "__main__":
    main()
