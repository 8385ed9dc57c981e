"""Every number of a joint file can be the only one that varies, also one that the force balance does not see."""

import jax
import jax.numpy as jnp
import pytest

from asperity.joint.results import RESULTS
from asperity.joint_file.values import si_values
from asperity.study.points import numbers, point_kernel


@pytest.mark.parametrize(
    "path",
    [
        "load.output_torque",
        "surface.fractal_dimension",
        "surface.sp.fractal_roughness",
        "materials.steel.hardness",
        "compliance.pin_stiffness",
    ],
)
def test_one_result_for_each_point(case, path):
    values = si_values(case)
    kernel = point_kernel(values, (path,), tuple(RESULTS))
    code, found = jax.eval_shape(kernel, numbers(values), jax.ShapeDtypeStruct((7,), jnp.float64))
    assert code.shape == (7,)
    assert {name: value.shape for name, value in found.items()} == {
        name: (5, 7) if RESULTS[name].per_contact else (7,) for name in RESULTS
    }
