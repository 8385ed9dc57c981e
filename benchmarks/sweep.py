"""A sweep through Dask into Zarr beside the bare kernel: the price of scheduling, writing and resuming.

Run: ``python benchmarks/sweep.py [points] [workers] [results]``, e.g. ``python benchmarks/sweep.py 1e7 2 published``.

The bare kernel is the same compiled program on the same batches in as many spawned processes with one thread each,
its results thrown away. Both are timed after compilation; the best of several interleaved runs counts.
"""

import multiprocessing
import sys
import tempfile
import time
from pathlib import Path

from asperity.precision import use_compilation_cache, use_double_precision

ROUNDS = 3
LARGE = 5e7  # points from which one round is enough: it takes minutes
FILE = Path(__file__).parents[1] / "examples" / "zou2025.toml"
RESULTS = {
    "published": ("published_stiffness_output",),
    "assembly": ("assembly_stiffness_output",),
    "all": ("all",),
}


def plan_of(points, names):
    from asperity.joint_file.reader import read_case
    from asperity.study.parameters import parse_axis
    from asperity.study.sweep.sweep_plan import make_plan

    n = max(round(points**0.25), 2)
    axes = [
        parse_axis(f"load.output_torque=0 N*m:10 N*m:{n}"),
        parse_axis(f"surface.fractal_dimension=1.3:1.9:{n}"),
        parse_axis(f"surface.fractal_roughness=1e-10 mm:1e-8 mm:{n}:log"),
        parse_axis(f"load.preload=800 N:2000 N:{n}"),
    ]
    return make_plan(read_case(FILE), axes, RESULTS[names])


def bare(plan, indices):
    """Seconds that the kernel takes for some blocks, without the first call's compilation."""
    import os

    os.environ["JAX_ENABLE_X64"] = "1"
    from asperity.study.batch import QUICK_POINTS
    from asperity.study.sweep.sweep_plan import block_results

    block_results(plan, plan.block(0), in_all=QUICK_POINTS + 1)
    start = time.perf_counter()
    for index in indices:
        block_results(plan, plan.block(index), in_all=QUICK_POINTS + 1)
    return time.perf_counter() - start


def timed_bare(plan, workers):
    import os

    from asperity.study.sweep.cluster import worker_environment

    os.environ.update(worker_environment())  # the pool's children inherit it
    shares = [list(range(plan.block_count))[k::workers] for k in range(workers)]
    with multiprocessing.get_context("spawn").Pool(workers) as pool:
        return max(pool.starmap(bare, [(plan, share) for share in shares]))


def timed_sweep(plan, workers, folder):
    """Seconds from the first finished block to the last, scaled to all blocks, and from start to end."""
    from asperity.study.sweep.cluster import run_on_cluster
    from asperity.study.sweep.store import open_store, prepare_store

    store = Path(folder) / f"{time.time_ns()}.zarr"
    blocks = prepare_store(store, plan)
    times = []
    start = time.perf_counter()
    run_on_cluster(
        plan,
        store,
        blocks,
        scheduler=None,
        workers=workers,
        finished=lambda _: times.append(time.perf_counter()),
    )
    whole = time.perf_counter() - start
    # the first block of each worker carries its start and compilation; the rest is the steady state
    steady = (times[-1] - times[workers - 1]) * len(blocks) / (len(blocks) - workers)
    assert int((open_store(store)["status"] != 0).sum()) == 0
    return steady, whole


def main(points=1e6, workers=2, names="published"):
    use_double_precision()
    use_compilation_cache()
    plan = plan_of(points, names)
    print(
        f"{plan.points} points, {plan.block_count} blocks of {plan.block_shape}, {names}, {workers} processes"
    )
    kernel, sweep, whole = [], [], []
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(ROUNDS if plan.points < LARGE else 1):
            kernel.append(timed_bare(plan, workers))
            steady, total = timed_sweep(plan, workers, folder)
            sweep.append(steady)
            whole.append(total)
            print(
                f"  bare kernel {kernel[-1]:.2f} s ({plan.points / kernel[-1]:.3g}/s), sweep {steady:.2f} s steady, "
                f"{total:.2f} s with the start of the processes, ratio {steady / kernel[-1]:.3f}"
            )
    print(
        f"best of {len(kernel)}: kernel {min(kernel):.2f} s, sweep {min(sweep):.2f} s, "
        f"ratio {min(sweep) / min(kernel):.3f}, with the start of the processes {min(whole) / min(kernel):.3f}"
    )
    return min(sweep) / min(kernel)


if __name__ == "__main__":
    given = sys.argv[1:]
    main(
        float(given[0]) if given else 1e6,
        int(given[1]) if len(given) > 1 else 2,
        given[2] if len(given) > 2 else "published",
    )
