"""What machine code says of itself is what JAX says of the program, and nothing of it is made on the way."""

import pickle

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from jax.experimental import serialize_executable

from asperity.kept_programs import without_the_cache_of_jax
from asperity.machine_code import check_names, said


def _machine_code():
    def named_thus(x):
        return jnp.outer(x, x), jnp.sum(x), jnp.argmax(x)

    with without_the_cache_of_jax():
        compiled = jax.jit(named_thus).lower(jax.ShapeDtypeStruct((3,), np.float64)).compile()
    return serialize_executable.serialize(compiled)[0]


def test_the_name_of_the_function_and_the_shapes_of_its_results_are_said():
    code = _machine_code()
    check_names(code)
    found = said(code)
    assert "named_thus" in found.name
    assert found.kinds == [([3, 3], "float64"), ([], "float64"), ([], "int64")]


@pytest.mark.parametrize(
    "content", [b"", b"damaged", pickle.dumps(5), pickle.dumps(([1, 2],)), pickle.dumps(print)]
)
def test_what_is_no_machine_code_says_nothing(content):
    assert said(content) is None


def test_half_of_it_says_nothing():
    code = _machine_code()
    assert said(code[: len(code) // 2]) is None


def test_what_is_named_is_not_made():
    with pytest.raises(ValueError, match=r"print is no part of machine code"):
        check_names(pickle.dumps(print))
