"""The joint of the paper as a file, and its parsed case."""

from pathlib import Path

import jax
import numpy as np
import pytest

from asperity.compilation import compile_fast
from asperity.joint.evaluation import evaluate
from asperity.joint_file.build import with_values
from asperity.joint_file.reader import parse_case

FILE = Path(__file__).parents[2] / "examples" / "zou2025.toml"


@pytest.fixture(scope="session")
def zou_file() -> Path:
    return FILE


@pytest.fixture(scope="session")
def joint_text():
    return FILE.read_text()


@pytest.fixture(scope="session")
def case(joint_text):
    return parse_case(joint_text, source="zou2025.toml")


@pytest.fixture(scope="session")
def evaluated_directly(case):
    """What the chain says on a grid of axes, in one call without the machinery of studies."""

    def evaluated(axes):
        grid = np.meshgrid(*(axis.values for axis in axes), indexing="ij")
        joint = with_values(case, {axis.path: v.ravel() for axis, v in zip(axes, grid, strict=True)})
        numbers = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), joint)
        result = compile_fast(evaluate, numbers)(numbers)
        assert np.all(result.solved)
        return result

    return evaluated
