"""The documentation keeps its promises: docstrings say formula, units and source; pages name what exists."""

import ast
import importlib
import importlib.util
import inspect
import pkgutil
import re
import tomllib
from pathlib import Path

import pytest

import asperity.body
import asperity.contact
import asperity.drive
import asperity.drive.stiffness
import asperity.drive.structure
import asperity.materials
from asperity.drive.layout import wedge_geometry
from asperity.zou2025 import branch, force_balance, kinematics, mechanism, series_stiffness

ROOT = Path(__file__).parents[1]
DOCS = ROOT / "docs"
FORMULA_ROOMS = (
    asperity.body,
    asperity.contact,
    asperity.drive,
    asperity.drive.stiffness,
    asperity.drive.structure,
)
FORMULA_MODULES = (
    asperity.materials,
    wedge_geometry,
    branch,
    force_balance,
    kinematics,
    mechanism,
    series_stiffness,
)
#: Equations of the paper, and our own: how many of each letter.
OURS = {"A": 14, "B": 14, "D": 3, "E": 7, "F": 6, "L": 4, "M": 5, "R": 4}
NUMBERS = {str(n) for n in range(1, 31)} | {
    f"{x}{n}" for x, count in OURS.items() for n in range(1, count + 1)
}


def _formula_modules():
    for room in FORMULA_ROOMS:
        for module in pkgutil.iter_modules(room.__path__, f"{room.__name__}."):
            if not module.ispkg:
                yield importlib.import_module(module.name)
    yield from FORMULA_MODULES


def _public(kind):
    return [
        pytest.param(thing, id=f"{module.__name__}.{name}")
        for module in _formula_modules()
        for name, thing in vars(module).items()
        if kind(thing) and not name.startswith("_") and thing.__module__ == module.__name__
    ]


def _is_function(thing):
    return inspect.isfunction(inspect.unwrap(thing)) if callable(thing) else False


def _sections(docstring):
    """Sections of a numpydoc docstring by title; the text before the first one is called Summary."""
    parts = re.split(r"^(\w[\w ]*)\n-{3,}$", inspect.cleandoc(docstring), flags=re.MULTILINE)
    return {"Summary": parts[0]} | dict(zip(parts[1::2], parts[2::2], strict=True))


def _entries(section):
    """Names, type and description of every entry of a Parameters or Returns section."""
    for head, text in re.findall(r"^(\S.*)\n((?:(?:[ ]+.*)?\n?)*)", section, flags=re.MULTILINE):
        names, _, kind = head.partition(" : ")
        yield [name.strip() for name in names.split(",")], kind, text


@pytest.mark.parametrize("function", _public(_is_function))
def test_formula_function_documents_itself(function):
    said = _sections(function.__doc__ or "")
    whole = inspect.cleandoc(function.__doc__ or "")
    assert {"Parameters", "Returns"} <= said.keys()
    described = {name for names, _, _ in _entries(said["Parameters"]) for name in names}
    assert described == set(inspect.signature(function).parameters)
    for names, kind, text in _entries(said["Parameters"]):
        if re.search(r"\b(Real|Array|float)\b", kind):
            assert re.search(r"\[[^\]]+\]|As for :func:", text), f"no unit for {names}"
    # a formula, or the number or the function that stands for it
    assert re.search(r"math::|:math:|[Ee]quations? \(|:func:|:mod:", whole), "no formula"
    assert "References" in said or re.search(r":func:|[Ee]quations? \(", whole), "no source"


@pytest.mark.parametrize("module_class", _public(inspect.isclass))
def test_formula_class_gives_units(module_class):
    said = _sections(module_class.__doc__ or "")
    fields = [name for name in getattr(module_class, "__dataclass_fields__", {}) if not name.startswith("_")]
    if not fields:
        return
    assert {name for names, _, _ in _entries(said["Parameters"]) for name in names} == set(fields)
    for names, kind, text in _entries(said["Parameters"]):
        if re.search(r"\b(Real|Array|float)\b", kind):
            assert re.search(r"\[[^\]]+\]", text), f"no unit for {names}"


def _rows(page):
    """Cells of every table row below its head."""
    for line in (DOCS / page).read_text(encoding="utf-8").splitlines():
        if line.startswith("|") and not re.match(r"\|[-| ]+\|$", line):
            yield [cell.strip() for cell in line.strip("|").split("|")]


def _numbers(cell):
    """Equation numbers in a cell; (1)–(5) is a range."""
    found = set(re.findall(r"\(([ABDEFLMR]?\d+)\)", cell))
    for first, last in re.findall(r"\((\d+)\)–\((\d+)\)", cell):
        found |= {str(n) for n in range(int(first), int(last) + 1)}
    return found


def _equation_rows():
    return [row for row in _rows("equations.md") if len(row) == 4 and _numbers(row[0])]


def test_every_equation_has_a_row():
    assert set().union(*(_numbers(row[0]) for row in _equation_rows())) == NUMBERS


@pytest.mark.parametrize("row", _equation_rows(), ids=lambda row: row[0].replace(" ", ""))
def test_equation_row_names_functions_and_tests_that_exist(row):
    functions = re.findall(r"\{py:func\}`~?([\w.]+)`", row[2])
    assert functions
    for path in functions:
        module, _, name = path.rpartition(".")
        assert callable(getattr(importlib.import_module(module), name))
    tests = re.findall(r"`(tests/[\w/]+\.py)::(\w+)`", row[3])
    assert tests, "no test"
    for file, name in tests:
        tree = ast.parse((ROOT / file).read_text(encoding="utf-8"))
        assert name in {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}, (
            f"{file}::{name}"
        )


def test_nomenclature_names_exist_in_the_code():
    words = set()
    for path in (ROOT / "src" / "asperity").rglob("*.py"):
        words |= set(re.findall(r"\w+", path.read_text(encoding="utf-8")))
    named = {name for row in _rows("nomenclature.md") for name in re.findall(r"^`(\w+)`|, `(\w+)`", row[0])}
    flat = {one or other for one, other in named}
    assert flat
    assert flat <= words, sorted(flat - words)


@pytest.mark.parametrize("name", ["generate_cli", "generate_results", "generate_joint_file"])
def test_generated_page_is_current(name):
    spec = importlib.util.spec_from_file_location(name, DOCS / f"{name}.py")
    generator = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(generator)
    current = generator.PAGE.read_text(encoding="utf-8") == generator.page()
    assert current, f"run `python docs/{name}.py`"


def test_every_dependency_is_explained():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    groups = [project["dependencies"], *project["optional-dependencies"].values()]
    names = {re.match(r"[\w-]+", requirement)[0] for group in groups for requirement in group}
    names -= {project["name"]}  # the extra 'all' names the package's other extras
    explained = set(re.findall(r"`([\w-]+)`", (DOCS / "architecture.md").read_text(encoding="utf-8")))
    assert names <= explained, sorted(names - explained)


def test_constraints_name_versions_only():
    lines = (ROOT / "constraints.txt").read_text(encoding="utf-8").splitlines()
    pins = [line for line in lines if line and not line.startswith("#")]
    assert pins
    assert [line for line in pins if not re.fullmatch(r"[\w.-]+==[\w.]+( ; [\w.<>='\" *!]+)?", line)] == []


@pytest.mark.parametrize(
    "page", [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted(DOCS.glob("*.md"))], ids=lambda p: p.name
)
def test_links_between_pages_lead_somewhere(page):
    targets = re.findall(r"\]\(([^)#\s]+)", page.read_text(encoding="utf-8"))
    missing = [t for t in targets if not re.match(r"https?:|mailto:", t) and not (page.parent / t).exists()]
    assert missing == []


def test_readme_marks_both_commands_for_ci():
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    for marker in ("the main job", "the tests"):
        block = re.search(rf"^<!-- {marker} -->\n```sh\n(.+)\n```$", readme, flags=re.MULTILINE)
        assert block, marker
        assert "\n" not in block[1], "one command, one line"


def test_readme_installs_for_the_pages_what_their_modules_import():
    """Sphinx imports every module: what one imports at its head must be in the extras that README names."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    installed = re.search(r"'\.\[([\w,]+)\]' && python -m sphinx", readme)[1].split(",")
    offered = {
        re.match(r"[\w-]+", package)[0].lower().replace("-", "_"): extra
        for extra, packages in project["optional-dependencies"].items()
        if extra in ("surface", "study", "bayes", "page", "report")
        for package in packages
    }
    needed = {}
    for module in sorted((ROOT / "src" / "asperity").rglob("*.py")):
        for name in re.findall(
            r"^(?:import|from) (\w+)", module.read_text(encoding="utf-8"), flags=re.MULTILINE
        ):
            if name.lower() in offered:
                needed[offered[name.lower()]] = module.name
    assert needed  # the page imports its server
    assert set(needed) <= set(installed), needed


def test_readme_names_examples_for_the_commands_that_need_more_than_any_joint():
    from asperity.joint_file.reader import read_case
    from asperity.joint_file.si_tables import numeric_keys

    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    dynamics, spread = (
        ROOT / re.search(rf"asperity {command} (examples/\w+\.toml)", readme)[1]
        for command in ("dynamics", "uncertainty")
    )
    assert read_case(dynamics).dynamics is not None
    assert any(entry.tolerance > 0.0 for entry in numeric_keys(read_case(spread)).values())
