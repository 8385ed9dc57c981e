"""What is done once JAX is imported, and that one joint does without it."""

import os
import subprocess
import sys

import jax
import pytest

from asperity.engine import jax_import
from asperity.engine.jax_import import when_jax_is_imported
from asperity.precision import use_double_precision


def succeeds(script, **environment):
    """Whether a process of its own ends well; what it says otherwise is the reason."""
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", script],
        env=os.environ | environment,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr


def test_at_once_where_jax_is_there():
    before, done = list(sys.meta_path), []
    when_jax_is_imported(lambda: done.append(jax))
    assert done == [jax]
    assert sys.meta_path == before


def test_double_precision_at_once_where_jax_is_there():
    with jax.enable_x64(False):
        use_double_precision()  # for the process; the block has its own
    assert jax.numpy.ones(1).dtype == "float64"


def test_one_joint_does_without_jax_and_later_programs_have_its_modules_in_double_precision():
    succeeds(
        """
import sys
import asperity.joint.solve
from asperity.joint.description import Joint
from asperity.precision import require_double_precision, use_double_precision

use_double_precision()
assert not [name for name in sys.modules if name.partition(".")[0] in ("jax", "jaxlib")]
import jax.numpy as jnp
import jax

assert jax.config.jax_enable_x64
assert jnp.ones(1).dtype == "float64"
require_double_precision()
empty = object.__new__(Joint)
for name in (*Joint.number_fields, *Joint.static_fields):
    empty.__dict__[name] = None
assert jax.tree.leaves(empty) == []  # known, or it would be a leaf
"""
    )


def test_jax_keeps_its_precision_where_nobody_asks_for_another():
    succeeds(
        """
import asperity.joint.solve
import jax

assert not jax.config.jax_enable_x64
""",
        JAX_ENABLE_X64="0",
    )


# a package of that name which is there at once, but for as long as a file is missing
STAND_IN = """
import os

if "BROKEN" in os.environ and not os.path.exists(os.environ["BROKEN"]):
    raise ImportError
ready = 1
"""
PREPARED = """
import importlib.util, sys
from asperity.engine.jax_import import when_jax_is_imported

done = []
when_jax_is_imported(lambda: done.append(sys.modules["jax"].ready))
when_jax_is_imported(lambda: done.append(2))
assert sum(type(finder).__name__ == "_Finder" for finder in sys.meta_path) == 1
"""
FINISHED = """
assert done == [1, 2], done
assert all(type(finder).__name__ != "_Finder" for finder in sys.meta_path)
when_jax_is_imported(lambda: done.append(3))
assert done == [1, 2, 3]
"""


@pytest.fixture
def stand_in(tmp_path):
    """The environment of a process that finds a package of the name of JAX, which does nothing."""
    (tmp_path / "jax").mkdir()
    (tmp_path / "jax" / "__init__.py").write_text(STAND_IN)
    (tmp_path / "jax" / "part.py").write_text("value = 5\n")
    paths = [str(tmp_path), *filter(None, [os.environ.get("PYTHONPATH")])]
    return {"PYTHONPATH": os.pathsep.join(paths), "PYTHONDONTWRITEBYTECODE": "1"}


@pytest.mark.parametrize(
    "imported", ["import jax", "import jax.part", "from jax import part", "importlib.import_module('jax')"]
)
def test_all_in_its_order_however_jax_is_imported(imported, stand_in):
    succeeds(PREPARED + "import json\nassert done == []\n" + imported + FINISHED, **stand_in)


def test_asking_whether_jax_is_installed_does_not_count_as_an_import(stand_in):
    """As other packages ask who can do without it."""
    asked = "for _ in range(2): assert importlib.util.find_spec('jax') is not None\nassert done == []\n"
    succeeds(PREPARED + asked + "import jax" + FINISHED, **stand_in)


def test_an_import_that_fails_may_be_tried_again(stand_in, tmp_path):
    tried = f"""
try:
    import jax
except ImportError:
    pass
assert done == []
open({str(tmp_path / "repaired")!r}, "w").close()
import jax
"""
    succeeds(PREPARED + tried + FINISHED, **stand_in, BROKEN=str(tmp_path / "repaired"))


def test_an_action_may_wait_for_jax_in_turn(stand_in):
    nested = "when_jax_is_imported(lambda: when_jax_is_imported(lambda: done.append(3)))\nimport jax\n"
    succeeds(PREPARED + nested + "assert done == [1, 2, 3], done\n", **stand_in)


def test_without_jax_its_import_fails_as_ever():
    """Of the standard library alone, as where JAX is not installed."""
    source = jax_import.__file__
    script = f"""
import importlib.util, sys
spec = importlib.util.spec_from_file_location("jax_import", {source!r})
module = importlib.util.module_from_spec(spec)
spec.loader.exec_module(module)
module.when_jax_is_imported(lambda: None)
assert importlib.util.find_spec("jax") is None
try:
    import jax
except ModuleNotFoundError as error:
    assert error.name == "jax"
else:
    raise AssertionError
import json
"""
    done = subprocess.run([sys.executable, "-I", "-S", "-c", script], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
