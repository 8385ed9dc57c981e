"""The chain by two programs, against the same by one."""

import jax
import numpy as np
import pytest

from asperity.joint.evaluated import chain_programs, evaluated
from asperity.joint.evaluation import evaluate


@pytest.mark.slow
def test_two_programs_find_what_one_finds(paper_joint):
    joint = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), paper_joint())
    found, expected = evaluated(joint), jax.jit(evaluate)(joint)
    assert jax.tree.structure(found) == jax.tree.structure(expected)
    for own, other in zip(jax.tree.leaves(found), jax.tree.leaves(expected), strict=True):
        np.testing.assert_allclose(own, other, rtol=1e-9, atol=1e-12)
    *_, shapes = chain_programs(joint)
    assert [each.shape for each in jax.tree.leaves(shapes)] == [each.shape for each in jax.tree.leaves(found)]
