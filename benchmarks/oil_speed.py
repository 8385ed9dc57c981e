"""What oil costs: a joint with a film over the same one without, at once and in a batch, in one run.

    python benchmarks/oil_speed.py [--points 4032] [--repeats 3]

Processor time of `asperity joint` in fresh processes without a cache, and of the points of a sweep over the torque with
all results of rolling, with and without the time in which their program is compiled. The joint is examples/oil.toml;
the dry one has the same friction and no oil.
"""

from __future__ import annotations

import argparse
import statistics
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from first_answer import EXAMPLES, processor_time

from asperity.joint_file.any_joint import results_of
from asperity.joint_file.reader import read_case
from asperity.joint_file.si_tables import si_values
from asperity.precision import use_double_precision
from asperity.study.batch import evaluate_points


def without_oil(text: str) -> str:
    """The file of a joint without its section of the oil."""
    start = text.index("[lubrication]")
    return text[:start] + text[text.index("[model]", start) :]


def of_batch(file: Path, points: int, repeats: int) -> tuple[float, float]:
    """Processor time of the first call, with its compilation, and of the fastest later one [s]."""
    values = si_values(read_case(file))
    names = tuple(name for name, row in results_of(values).items() if row.group == "rolling")
    torque = {"load.output_torque": np.linspace(0.1, 1.0, points) * values["load"]["output_torque"]}
    times = []
    for _ in range(1 + repeats):
        start = time.process_time()
        evaluate_points(values, torque, names)
        times.append(time.process_time() - start)
    return times[0], min(times[1:])


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--points", type=int, default=4032)
    parser.add_argument("--repeats", type=int, default=3)
    asked = parser.parse_args()
    use_double_precision()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        oil, dry = EXAMPLES / "oil.toml", folder / "dry.toml"
        dry.write_text(without_oil(oil.read_text(encoding="utf-8")), encoding="utf-8")
        program = [sys.executable, "-c", "from asperity.cli import main; main()", "joint"]
        turns = [
            [processor_time([*program, str(file)], folder) for file in (oil, dry)]
            for _ in range(asked.repeats)
        ]
        at_once = [statistics.median(times) for times in zip(*turns, strict=True)]
        batches = [of_batch(file, asked.points, asked.repeats) for file in (oil, dry)]
    compiled, run = zip(*batches, strict=True)
    for label, (with_oil, without) in (
        ("asperity joint", at_once),
        (f"{asked.points} points", run),
        ("the same with their compilation", compiled),
    ):
        print(f"{label:32} {with_oil:7.2f} s with oil, {without:6.2f} s without: {with_oil / without:5.1f}")


if __name__ == "__main__":
    main()
