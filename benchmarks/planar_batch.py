"""Speed of the batch evaluator for other drives: joints per second on every level, gradient over value, compilation.

    python benchmarks/planar_batch.py [--types planetary,multiroller] [--points 4096] [--repeats 5]

One evaluation is one complete joint of an example file under its own torque: the state at rest, standing and rolling by
Newton's method, the contacts, and the stiffness of the level. The gradient is that of one result by every number of
the file, over the evaluation of as many joints that differ in every number. Wall times, the best of several repeats:
on a shared machine they only ever err upwards.
"""

import argparse
import functools
import time
from pathlib import Path

import numpy as np

from asperity.joint_file.reader import read_case
from asperity.joint_file.si_tables import numeric_keys, si_values
from asperity.precision import use_double_precision
from asperity.study.batch import DERIVATIVE_BATCH, QUICK_POINTS, derivatives_at, evaluate_points

EXAMPLES = Path(__file__).parents[1] / "examples"
LEVELS = ("published", "series_with_bulk", "assembly")


def timed(work) -> float:  # type: ignore[no-untyped-def]
    started = time.perf_counter()
    work()
    return time.perf_counter() - started


def first_and_best(work, repeats: int) -> tuple[float, float]:  # type: ignore[no-untyped-def]
    """Time of the first call, which compiles, and of the fastest later one."""
    first = timed(work)
    return first, min(timed(work) for _ in range(repeats))


def measure(kind: str, points: int, repeats: int) -> None:
    """Print the figures of one type of drive."""
    case = read_case(EXAMPLES / f"{kind}.toml")
    values, inputs = si_values(case), numeric_keys(case)
    torque = values["load"]["output_torque"] * np.linspace(0.3, 0.8, points)

    def evaluated(name: str, column: np.ndarray) -> None:
        evaluate_points(values, {"load.output_torque": column}, (name,), in_all=QUICK_POINTS + 1)

    for name in (*(f"{level}_stiffness_output" for level in LEVELS), "standing_torque_capacity"):
        column = torque if name != "standing_torque_capacity" else torque[: points // 64]
        first, best = first_and_best(functools.partial(evaluated, name, column), repeats)
        print(f"{kind:15} {name:36} {column.size / best:9.0f} joints/s, compiled in {first - best:5.1f} s")
    at = {path: np.full(DERIVATIVE_BATCH, entry.value) for path, entry in inputs.items()}
    name = (f"{LEVELS[-1]}_stiffness_output",)
    _, value = first_and_best(lambda: evaluate_points(values, at, name, in_all=QUICK_POINTS), repeats)
    _, slopes = first_and_best(lambda: derivatives_at(values, at, name, tuple(inputs)), repeats)
    print(
        f"{kind:15} gradient by {len(inputs)} numbers {1e3 * slopes / DERIVATIVE_BATCH:.3g} ms a joint, "
        f"{slopes / value:.1f} values"
    )


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--types", default="planetary,multiroller,stepped_planet,planar")
    parser.add_argument("--points", type=int, default=4096)
    parser.add_argument("--repeats", type=int, default=5)
    options = parser.parse_args()
    use_double_precision()
    for kind in options.types.split(","):
        measure(kind, options.points, options.repeats)


if __name__ == "__main__":
    main()
