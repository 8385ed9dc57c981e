"""What import asperity offers, and what it loads."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import asperity

ROOT = Path(__file__).parents[2]
HEAVY = ("jax", "numpy", "scipy", "matplotlib", "pandas", "xarray", "pydantic", "click")


def python(script, *, cwd=ROOT, **environment):
    done = subprocess.run(
        [sys.executable, "-c", script],
        capture_output=True,
        text=True,
        cwd=cwd,
        env={**os.environ, "PYTHONPATH": str(ROOT / "src"), **environment},
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_import_and_dir_load_nothing_heavy():
    script = f"import sys, asperity; dir(asperity); print(*sorted(set(sys.modules) & set({HEAVY})))"
    assert python(script).split() == []


def test_no_name_is_that_of_a_room():
    """A room that is imported takes the place of the function: its name becomes an attribute of the package."""
    rooms = {path.stem for path in (ROOT / "src" / "asperity").iterdir()}
    assert set(asperity.__all__) & rooms == {"errors"}


@pytest.mark.slow
def test_load_and_solve_in_single_precision_jax_load_no_plotting_and_no_tables():
    script = (
        "import sys, asperity; s = asperity.load('examples/zou2025.toml').solve(); import jax; "
        "assert jax.config.jax_enable_x64; assert s.solution.result.published.output.dtype == 'float64'; "
        "print(*sorted(set(sys.modules) & {'matplotlib', 'pandas', 'xarray', 'scipy.optimize', 'rich', 'click'}))"
    )
    assert python(script, JAX_ENABLE_X64="0").split() == []


def test_dir_shows_all_that_is_offered():
    assert set(asperity.__all__) | {"__version__"} == set(dir(asperity))
    for name in asperity.__all__:
        assert getattr(asperity, name).__doc__
    assert asperity.errors.InputError.exit_code == 2


def test_what_is_not_offered_is_an_attribute_error():
    with pytest.raises(AttributeError, match="has no attribute 'solve_all'"):
        _ = asperity.solve_all


def test_a_notebook_shows_errors_as_one_message():
    error = asperity.errors.InputError("load.preload: -4 N is not allowed")
    assert error._render_traceback_() == ["InputError: load.preload: -4 N is not allowed"]


@pytest.mark.slow
def test_python_example_of_the_readme_runs(tmp_path):
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    (block,) = re.findall(r"<!-- the Python example -->\n```python\n(.*?)```", text, flags=re.DOTALL)
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    number, *words = python(block, cwd=tmp_path).split()
    assert words == ["N·m/arcmin", "at", "the", "output"]
    assert (tmp_path / "windup.png").stat().st_size > 10_000
    document = python(
        "import sys; sys.argv = ['asperity', 'joint', 'changed.toml', '--json']; from asperity.cli import main; main()",
        cwd=_with_preload(tmp_path, "1200 N"),
    )
    (expected,) = re.findall(
        r'"assembly": {\s*"input.*?"output_Nm_per_arcmin": ([\d.e+]+)', document, flags=re.DOTALL
    )
    assert float(number) == pytest.approx(float(expected), rel=1e-12)


def _with_preload(folder, preload):
    text = (ROOT / "examples" / "zou2025.toml").read_text(encoding="utf-8")
    changed = re.sub(r'(?m)^preload = "[^"]*"', f'preload = "{preload}"', text)
    assert changed != text
    (folder / "changed.toml").write_text(changed, encoding="utf-8")
    return folder
