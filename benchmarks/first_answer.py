"""Time of first answers: commands in fresh processes without any cache, over that of `import jax` alone.

    python benchmarks/first_answer.py [--repeats 5] [FILE ...]

Prints processor time (user and system) of each command as the median of the repeats, and its ratio to the median of
`import jax`, measured in turn with the commands. Without FILE: every joint of examples/, then planetary drives with
skew, crowns, a housing and unlike branches, then wear and accuracy over a turn. Then what the page needs: its first
answer, one more, and its memory after answers about many structures.
"""

from __future__ import annotations

import argparse
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

EXAMPLES = Path(__file__).parents[1] / "examples"
JOINTS = (
    "planetary",
    "planetary_hollow",
    "multiroller",
    "stepped_planet",
    "planar",
    "tutorial_joint",
    "zou2025",
    "oil",
    "heat",
)
COMMANDS = ("roll", "windup", "loads", "draw", "crown", "dynamics")
#: Commands about a joint over a turn and over its years, with their examples.
OVER_YEARS = (
    ("wear", "wear"),
    ("wear", "planetary"),
    ("wear", "oil"),
    ("accuracy", "accuracy"),
    ("joint", "wear"),
    ("joint", "accuracy"),
)
OPTIONS = {"draw": ("--out", "drawing.svg"), "crown": ("--tilt", "0.5 mrad")}
#: Features of the planetary example → texts of the file, and what takes their places.
FEATURES = {
    "skew": ("[lubrication]", '[rolling]\nskew = { sp = "0.4 mrad", pr = "-0.3 mrad" }\n\n[lubrication]'),
    "crowns": ("output = ", 'planet_crown_radius = "5 m"\noutput = '),
    "housing": (
        'ring_support = "free"',
        'ring_support = "elastic_housing"',
        "[model]",
        '[housing]\nouter_diameter = "200 mm"\ninterference = "60 um"\nfriction_coefficient = 0.12\n\n[model]',
        'ring = "52100"',
        'ring = "52100"\nhousing = "6061-T6"',
    ),
    "branches": (
        "[dynamics]",
        '[[branch]]\nplanet_deviation = "2 um"\n\n[[branch]]\nplanet_deviation = "-1 um"\n\n[[branch]]\n\n[dynamics]',
    ),
}


def with_features(names: tuple[str, ...]) -> str:
    """The planetary example with some features."""
    text = (EXAMPLES / "planetary.toml").read_text(encoding="utf-8")
    for name in names:
        changes = FEATURES[name]
        for old, new in zip(changes[::2], changes[1::2], strict=True):
            assert old in text, old
            text = text.replace(old, new, 1)
    return text


def processor_time(command: list[str], folder: Path) -> float:
    """User and system time of a process without a cache [s]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    environment = os.environ | {"ASPERITY_CACHE_DIR": ""}
    ended = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if ended.returncode not in (0, 3):
        print(f"  {' '.join(command)} ended with {ended.returncode}: {ended.stderr.strip()[:200]}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="*", type=Path)
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--structures", type=int, default=0, help="structures that the page is asked about")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        joints = [file.absolute() for file in asked.files] or _files(folder)
        program = [sys.executable, "-c", "from asperity.cli import main; main()"]
        commands = [(f"joint {file.stem}", [*program, "joint", str(file)]) for file in joints]
        if not asked.files:
            commands += [
                (f"{command} planetary", [*program, command, str(joints[0]), *OPTIONS.get(command, ())])
                for command in COMMANDS
            ]
            commands += [
                (f"{command} {name}", [*program, command, str(EXAMPLES / f"{name}.toml")])
                for command, name in OVER_YEARS
            ]
        alone = [sys.executable, "-c", "import jax"]
        times: dict[str, list[float]] = {label: [] for label, _ in commands}
        of_jax = []
        for _ in range(asked.repeats):
            of_jax.append(processor_time(alone, folder))
            for label, command in commands:
                times[label].append(processor_time(command, folder))
    unit = statistics.median(of_jax)
    print(f"{'import jax':45} {unit:6.2f} s")
    for label, measured in times.items():
        median = statistics.median(measured)
        print(f"{label:45} {median:6.2f} s {median / unit:6.1f}")
    _page(asked.structures)


def _files(folder: Path) -> list[Path]:
    """The examples, and the planetary one with features."""
    files = [EXAMPLES / f"{name}.toml" for name in JOINTS]
    for names in (("skew",), ("crowns",), ("skew", "crowns"), ("housing",), ("branches",), tuple(FEATURES)):
        file = folder / f"planetary_{'_'.join(names)}.toml"
        file.write_text(with_features(names), encoding="utf-8")
        files.append(file)
    return files


def _page(structures: int) -> None:
    """Answers of the page in this process, without a browser."""
    from asperity.page.answer import joint_answer
    from asperity.page.joint_request import joint_request

    text = (EXAMPLES / "planetary.toml").read_text(encoding="utf-8")
    for label in ("page, first answer", "page, an answer more"):
        start = time.perf_counter()
        joint_answer(joint_request({"name": "joint.toml", "toml": text}))
        print(f"{label:45} {time.perf_counter() - start:6.2f} s")
    for number in range(structures):  # other numbers of planets, drives and features are other structures
        names = [name for bit, name in enumerate(FEATURES) if number >> bit & 1]
        planets = 3 + number // 16 % 2  # two do not carry the torque, and five do not fit
        changed = with_features(tuple(names)).replace("planets = 3", f"planets = {planets}")
        if "branches" in names and planets != 3:
            continue
        joint_answer(joint_request({"name": "joint.toml", "toml": changed}))
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(f"{f'page, memory after {structures} structures':45} {memory:6.0f} MB")


if __name__ == "__main__":
    main()
