"""Run the commands that the pages show, and write what they print: `python docs/recompute.py [PAGE ...]`.

With `--check` nothing is written: what differs is printed, and the exit code is 1. Comments on the pages say what runs:

    <!-- output: asperity roll joint.toml | from "Rating life" until "No warnings" -->
    a text block follows, which becomes what the command prints, or the lines from one to before another, by their
    beginnings, in which * stands for anything

    <!-- numbers: asperity joint joint.toml --json
    33 431 N·m/rad = torsional_stiffness/assembly/output_Nm_per_rad
    63.4 arcmin = position/drift_rad in arcmin
    0.73 = max diagnostics/name:slip_ratio/value
    -->
    each of these numbers stands in the section around, as it is written on the left

    <!-- file: duty.toml from joint.toml -->
    a TOML block follows, which is appended to a copy of the file

    <!-- file: free.toml from joint.toml with drive.ring_support = "free"; load.preload = "900 N" -->
    a copy of the file with other values; `without KEY, KEY` leaves lines out

Commands run in a copy of `examples/`, or above it where they name that folder. A number that differs by less than its
last digit, or where only rounding is left, is the same: processors differ.
"""

from __future__ import annotations

import json
import os
import re
import shlex
import shutil
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from click.testing import CliRunner

import asperity
from asperity.cli.commands import asperity as command_line
from asperity.units import from_si

ROOT = Path(__file__).parents[1]
MARK = re.compile(r"<!-- (output|numbers|file): (.*?)-->\n", re.DOTALL)
NUMBER = re.compile(r"[-−]?\d(?:[\d  ]*\d)?(?:\.\d+)?(?:e[+-]?\d+)?")
BLOCK = re.compile(r"```(?:text|toml)\n(.*?)```\n", re.DOTALL)
#: A number below this, in whatever unit, is what rounding leaves of 0.
ROUNDING = 1e-12


def pages() -> list[Path]:
    """All pages with something to run."""
    every = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
    ours = (page for page in every if "_build" not in page.parts)
    return [page for page in ours if MARK.search(page.read_text(encoding="utf-8"))]


def recomputed(text: str) -> tuple[str, list[str]]:
    """The text of a page as it must be, and what differed."""
    differences: list[str] = []
    with _examples() as run:
        mark = MARK.search(text)
        while mark is not None:
            position = mark.end()
            if mark[1] == "output":
                text = _with_output(text, mark, run, differences)
            elif mark[1] == "file":
                block = BLOCK.match(text, position)
                _make_file(mark[2].strip(), block[1] if block else "")
            else:
                text, position = _with_numbers(text, mark, run, differences)
            mark = MARK.search(text, position)
    return text, differences


@contextmanager
def _examples() -> Iterator[Callable[[str], str]]:
    """A copy of the examples, and what runs a command in it and returns what it prints, each command once."""
    printed: dict[str, str] = {}
    before = Path.cwd()
    with tempfile.TemporaryDirectory() as folder:
        copied = Path(shutil.copytree(ROOT / "examples", Path(folder) / "examples"))

        def run(command: str) -> str:
            if command not in printed:
                os.chdir(copied.parent if "examples/" in command else copied)
                arguments = shlex.split(command.removeprefix("asperity "))
                done = CliRunner().invoke(command_line, arguments, catch_exceptions=False)
                if done.exit_code != 0:
                    raise ValueError(f"{command}: exit code {done.exit_code}: {done.stderr}")
                printed[command] = "".join(f"{line.rstrip()}\n" for line in done.stdout.splitlines())
            return printed[command]

        os.chdir(copied)
        try:
            yield run
        finally:
            os.chdir(before)


def _with_output(text: str, mark: re.Match[str], run: Callable[[str], str], differences: list[str]) -> str:
    """The text with the block behind this mark as the command prints it."""
    block = BLOCK.match(text, mark.end())
    if block is None:
        raise ValueError(f"no text block follows {mark[0]}")
    command, _, excerpt = mark[2].strip().partition(" | ")
    shown = run(command).splitlines(keepends=True)
    for word, beginning in re.findall(r'(from|until) "(.*?)"', excerpt):
        begins = re.compile(re.escape(beginning).replace(r"\*", ".*"))
        found = [place for place, line in enumerate(shown) if begins.match(line)]
        if not found:
            raise ValueError(f"{command}: no line begins with {beginning!r}")
        shown = shown[found[0] :] if word == "from" else shown[: found[0]]
    wanted = "".join(shown).strip("\n") + "\n"
    if _alike(block[1], wanted):
        return text
    differences.append(f"{mark[2].strip()}\n{wanted}")
    return f"{text[: block.start(1)]}{wanted}{text[block.end(1) :]}"


def _alike(one: str, other: str) -> bool:
    """Whether two texts have the same words, and numbers that differ by their last digit at most."""
    if NUMBER.sub("#", one) != NUMBER.sub("#", other):
        return False
    pairs = zip(NUMBER.findall(one), NUMBER.findall(other), strict=True)
    return all(_close(first, _value(second)) for first, second in pairs)


def _value(written: str) -> float:
    return float(re.sub(r"[  ]", "", written).replace("−", "-"))


def _last_digit(written: str, *, rounded: bool = True) -> float:
    """What one in the last digit of a number is; of a rounded whole number zeros at the end are none."""
    mantissa, _, power = re.sub(r"[  ]", "", written).partition("e")
    whole, point, decimals = mantissa.partition(".")
    zeros = len(whole) - len(whole.rstrip("0")) if rounded and not point else 0
    return 10.0 ** (int(power or 0) + (-len(decimals) if point else zeros))


def _close(written: str, value: float) -> bool:
    shown = _value(written)
    return (
        abs(shown - value) < 1.01 * _last_digit(written, rounded=False)
        or max(abs(shown), abs(value)) < ROUNDING
    )


def _make_file(said: str, block: str) -> None:
    """Write `NAME from BASE`, with the block behind it, or `with KEY = VALUE; ...`."""
    names, word, changed = (
        re.split(r" (with|without) ", said) if re.search(" with(out)? ", said) else (said, "", "")
    )
    name, _, base = names.partition(" from ")
    if word != "with":
        lines = Path(base).read_text(encoding="utf-8").splitlines(keepends=True)
        left_out = tuple(changed.split(", ")) if changed else ()
        text = "".join(line for line in lines if not (left_out and line.startswith(left_out)))
        Path(name).write_text(f"{text}\n{block}", encoding="utf-8")
        return
    pairs = (pair.split("=", 1) for pair in changed.split("; "))
    changes = {key.strip(): json.loads(value) for key, value in pairs}
    asperity.load(base).with_values(changes).save(name)


def _with_numbers(
    text: str, mark: re.Match[str], run: Callable[[str], str], differences: list[str]
) -> tuple[str, int]:
    """The text with the numbers that this mark names as they are computed, and where its comment ends."""
    command, *lines = mark[2].strip().splitlines()
    document = json.loads(run(command))
    position = mark.end()
    for line in lines:
        written, _, said = line.partition(" = ")
        value, number = _computed(document, said), NUMBER.search(written)
        places = [place for place in _places(text, written, mark.start()) if number is not None]
        if number is None or not places:
            raise ValueError(f"{command}: {written!r} does not stand in the section")
        if abs(_value(number[0]) - value) <= 0.51 * _last_digit(number[0]):
            continue
        new = written.replace(number[0], _as_written(number[0], value), 1)
        differences.append(f"{command}: {written!r} is {value:.6g}")
        comment = text.index(line, text.index(mark[2].splitlines()[0]))
        for begin, end in sorted([*places, (comment, comment + len(written))], reverse=True):
            text = f"{text[:begin]}{new}{text[end:]}"
            position += (len(new) - (end - begin)) * (begin < position)
    return text, position


def _places(text: str, written: str, position: int) -> list[tuple[int, int]]:
    """Where this stands in the section around a position, outside of comments."""
    headings = [heading.start() for heading in re.finditer(r"^#+ ", text, re.MULTILINE)]
    begin = max((heading for heading in headings if heading < position), default=0)
    end = min((heading for heading in headings if heading > position), default=len(text))
    plain = re.sub(r"<!--.*?-->", lambda comment: "\0" * len(comment[0]), text[:end], flags=re.DOTALL)
    pattern = re.compile(r"(?<![\d.])" + re.escape(written).replace(r"\ ", r"\s"))
    return [place.span() for place in pattern.finditer(plain, begin)]


def _as_written(written: str, value: float) -> str:
    """The value with as many digits as the number that is written, and its groups of three."""
    mantissa, _, power = written.partition("e")
    if power:
        return f"{value:.{len(mantissa.partition('.')[2])}e}".replace("e+0", "e").replace("e-0", "e-")
    step = _last_digit(written)
    number = f"{round(value / step) * step:.{len(mantissa.partition('.')[2])}f}"
    return re.sub(r"(?<=\d)(?=(\d{3})+$)", " ", number) if " " in mantissa else number


def _computed(document: object, said: str) -> float:
    """A number of a JSON document in SI units: `PATH`, `max PATH`, `min PATH` or `PATH over PATH`, and `in UNIT`."""
    path, _, unit = said.partition(" in ")
    over = path.split(" over ")
    if len(over) == 2:
        return _computed(document, over[0]) / _computed(document, over[1])
    least, place = re.fullmatch(r"(max |min )?(.*)", path.strip()).groups("")
    found = [document]
    for key in place.split("/"):
        name, chosen, wanted = key.partition(":")
        if key == "*":
            found = [entry for one in found for entry in (one.values() if isinstance(one, dict) else one)]
        elif chosen:
            found = [entry for one in found for entry in one if entry[name] == wanted]
        else:
            found = [one[int(key)] if isinstance(one, list) else one[key] for one in found]
    values = [float(one) for one in found]
    value = {"": values[0], "max": max(values), "min": min(values)}[least.strip()]
    if not unit:
        return value
    return value / float(unit) if re.fullmatch(r"[\de.]+", unit) else from_si(value, unit)


def main() -> int:
    """Recompute the pages named on the command line, or all of them."""
    asked = [Path(name).resolve() for name in sys.argv[1:] if name != "--check"] or pages()
    stale = 0
    for page in asked:
        text = page.read_text(encoding="utf-8")
        new, differences = recomputed(text)
        for difference in differences:
            print(f"{page.relative_to(ROOT)}: {difference}")
        stale += bool(differences)
        if new != text and "--check" not in sys.argv:
            page.write_text(new, encoding="utf-8")
    return int(bool(stale) and "--check" in sys.argv)


if __name__ == "__main__":
    sys.exit(main())
