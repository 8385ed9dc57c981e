"""Joint files with random mistakes: the command answers each with results or with one message.

The suite runs a small, fixed sample. For a long run: python tests/joint_file/test_mutated_files.py 100000 SEED [TYPE]
"""

import contextlib
import io
import random
import sys
import time
from pathlib import Path
from types import SimpleNamespace

import pytest

from asperity.views.blocks import Paragraph

EXAMPLES = Path(__file__).parents[2] / "examples"
TYPES = ("zou2025", "planetary", "planetary_hollow", "multiroller", "stepped_planet", "planar", "wheel_pair")
LONGEST_MESSAGE, LONGEST_SECONDS = 10_000, 60.0

NUMBERS = "0 -0 1 -1 5 1e-300 1e300 1e400 -1e9 nan inf -inf 1_000 0x10 true 1e-8 2.0 1.9999 0.5 100 9999999999999999999"
UNITS = [
    "mm",
    "m",
    "N",
    "MPa",
    "GPa",
    "rpm",
    "N*m",
    "Nm",
    "nm",
    "Nmm",
    "deg",
    "kg/m^3",
    "N/mm",
    "mm^99",
    "",
    "%",
]
UNITS += [
    "N*m/rad",
    "µm",
    "mm +- 1 mm",
    "mm +- 5 um, uniform",
    "N +- 1 N, normal 2 sigma",
    "/",
    "*",
    "(",
    "mm mm",
]
TEXTS = ["", "steel", "52100", "elastic", "bulk_and_asperities", "unity", "hertz_area", "constant_pin_force"]
TEXTS += [
    "\\u001b[31m",
    "\\u202e",
    "\\u009b2J",
    "\\ud800",
    "x" * 500,
    "\\n",
    "circular_spot",
    "sp",
    "../../x",
]
TABLES = ["[]", "{}", "[[]]", "{ sp = 1 }", "{ library = '52100' }", "{ library = 'x', file = '/dev/zero' }"]
TABLES += ["[" * 40 + "]" * 40, "2025-06-17", "{ a.b.c.d = 1 }", "[1, 'a', {}]", "{ library = 3 }"]
TABLES += ["{ library = '440C', density = '8 g/cm^3' }"]
LETTERS = [
    "\x00",
    "\x1b",
    "\x7f",
    "\u0085",
    "\u202e",
    "\ufeff",
    "\r",
    "\t",
    '"',
    "'",
    "[",
    "]",
    "{",
    "}",
    "=",
    "#",
]
LETTERS += [".", "\\"]
NAMES = [
    "sp",
    "pwr",
    "drive",
    "load",
    "surface.sp",
    "materials.steel",
    "bearings",
    "compliance",
    "a.b",
    "play",
    '"\\u001b"',
]
NAMES += ["roller", "contact", "surface.pr", "surface.sr"]
KEYS = [
    "planets",
    "pin_stiffness",
    "hardness",
    "library",
    "sun_torque",
    "preload",
    "planet_length",
    '""',
    "a b",
    "bodies",
]
KEYS += ["type", "ring_wall_thickness", "interference", "first", "place", "orbit", "internal", "grounded"]
TEXTS += ["ring", "carrier", "free", "axis", "pin", "rigid_housing", "springs", "planetary", "planar"]


def some_value(rng: random.Random) -> str:
    kind = rng.randrange(5)
    number = rng.choice(NUMBERS.split()) if rng.random() < 0.5 else f"{rng.uniform(0.1, 10.0):.3g}"
    if kind == 0:
        return number
    if kind in (1, 2):
        return f'"{number} {rng.choice(UNITS)}"'
    return f'"{rng.choice(TEXTS)}"' if kind == 3 else rng.choice(TABLES)


def mutated(rng: random.Random, example: str) -> bytes:
    """The example after one to three random mistakes."""
    lines = example.splitlines()
    for _ in range(rng.choice((1, 1, 1, 2, 3))):
        stated = [i for i, line in enumerate(lines) if "=" in line.partition("#")[0]]
        heads = [i for i, line in enumerate(lines) if line.startswith("[")]
        place = rng.choice(stated or [0])
        name, _, value = lines[place].partition("=")
        match rng.randrange(14):
            case 0 | 1 | 2:
                lines[place] = f"{name}= {some_value(rng)}"
            case 3:
                lines[place] = f"{name}={value.replace(rng.choice('0123456789'), rng.choice('0123456789'))}"
            case 4:
                lines[place] = f"{rng.choice(KEYS)} ={value}"
            case 5:
                lines[place] = "".join(rng.sample(name.strip(), len(name.strip()))) + f" ={value}"
            case 6:
                del lines[place]
            case 7:
                lines.insert(rng.randrange(len(lines) + 1), lines[place])
            case 8:
                lines.insert(rng.randrange(len(lines) + 1), lines.pop(place))
            case 9 if heads:
                lines[rng.choice(heads)] = rng.choice(("[{}]", "[[{}]]", "[{}")).format(rng.choice(NAMES))
            case 10 if heads:
                del lines[rng.choice(heads)]
            case 11:
                lines.insert(rng.choice(stated or [0]), f"{rng.choice(KEYS)} = {some_value(rng)}")
            case 12:
                line = lines[place]
                cut = rng.randrange(len(line) + 1)
                lines[place] = line[:cut] + rng.choice(LETTERS) + line[cut + rng.randrange(2) :]
            case 13:
                lines[place] = lines[place].lstrip("# ")
    content = "\n".join(lines).encode("utf-8", "surrogatepass")
    if rng.random() < 0.1 and content:
        cut = rng.randrange(len(content))
        content = content[:cut] + rng.randbytes(rng.randrange(4)) + content[cut + rng.randrange(20) :]
    return content


def answer(path: Path) -> tuple[int, str, str]:
    """Exit code, standard output and standard error of the command; any other exception is a failure."""
    from asperity.cli import main

    out, err = io.StringIO(), io.StringIO()
    arguments, sys.argv = sys.argv, ["asperity", "joint", str(path)]
    try:
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            main()
    except SystemExit as ended:
        return int(ended.code or 0), out.getvalue(), err.getvalue()
    finally:
        sys.argv = arguments
    raise AssertionError("the command did not end by itself")


def complaint(code: int, out: str, err: str, path: Path, only_read: bool) -> str:
    """What is wrong with an answer; empty if nothing is."""
    if not (out + err).replace("\n", "").isprintable():
        return "a control character in the output"
    if code == 0:
        return "" if "N·m/rad" in out and "nan" not in out and not err else "a success without a clean result"
    lines = err.rstrip("\n").split("\n")
    expected = {
        "exit code": code in (2, 3),
        "output beside the message": out == "",
        "beginning of the message": lines[0].startswith("asperity: error: "),
        "name of the file": not only_read or f"{path}: " in lines[0],
        "one sentence, or a list": all(line.startswith("  ") for line in lines[1:]),
        "length": len(err) < LONGEST_MESSAGE,
    }
    return ", ".join(what for what, holds in expected.items() if not holds)


def changed(content: bytes, example: str) -> str:
    """The lines that differ from the example."""
    same = {line.encode() for line in example.splitlines()}
    return "".join(f"    {line!r}\n" for line in content.split(b"\n") if line not in same)


def failures(
    count: int, seed: int, folder: Path, *, kind: str, only_read: bool
) -> tuple[dict[int, int], list[str]]:
    """How often each exit code came, and what went wrong."""
    example = (EXAMPLES / f"{kind}.toml").read_text(encoding="utf-8")
    rng, codes, wrong = random.Random(seed), {0: 0, 2: 0, 3: 0}, []
    path = folder / "joint.toml"
    for index in range(count):
        content = mutated(rng, example)
        path.write_bytes(content)
        start = time.perf_counter()
        try:
            code, out, err = answer(path)
        except Exception as error:
            wrong.append(f"{index}: {type(error).__name__}: {error}\n{changed(content, example)}")
            continue
        codes[code] = codes.get(code, 0) + 1
        problem = complaint(code, out, err, path, only_read)
        if time.perf_counter() - start > LONGEST_SECONDS:
            problem += " time"
        if problem:
            wrong.append(
                f"{index}: {problem}: {code} {out[-300:]!r} {err[:600]!r}\n{changed(content, example)}"
            )
    return codes, wrong


@pytest.mark.parametrize("kind", TYPES)
def test_any_mistake_is_answered(tmp_path, monkeypatch, kind):
    # reading alone: the numbers of a joint have tests of their own
    reads = "asperity.joint_file.solved_document"
    monkeypatch.setattr(f"{reads}.solve_joint", lambda joint: joint)
    monkeypatch.setattr(
        f"{reads}.solved_with_capacities", lambda joint, *_: SimpleNamespace(joint=joint, result=None)
    )
    monkeypatch.setattr(f"{reads}.laws_of_file", lambda *_: [])
    monkeypatch.setattr(f"{reads}.document_of", lambda case, solved: {"assumptions": []})
    monkeypatch.setattr("asperity.cli.runs.joint.joint_screen", lambda *_, in_full: [Paragraph("N·m/rad")])
    count = 400 if kind == "zou2025" else 80
    codes, wrong = failures(count, 1, tmp_path, kind=kind, only_read=True)
    assert wrong == []
    assert codes[2] > count // 2
    assert codes[0] > count // 20


if __name__ == "__main__":
    import tempfile

    with tempfile.TemporaryDirectory() as made:
        kind = sys.argv[3] if len(sys.argv) > 3 else "zou2025"
        found, problems = failures(int(sys.argv[1]), int(sys.argv[2]), Path(made), kind=kind, only_read=False)
    print(found, f"{len(problems)} problems", *problems[:20], sep="\n")
    sys.exit(bool(problems))
