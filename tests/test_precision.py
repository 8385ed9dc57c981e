"""Double precision is asked for, never assumed."""

import jax
import pytest

from asperity.errors import PrecisionError
from asperity.precision import require_double_precision, use_compilation_cache


def test_single_precision_is_refused_with_the_remedy():
    with jax.enable_x64(False), pytest.raises(PrecisionError, match="use_double_precision"):
        require_double_precision()


def test_double_precision_passes():
    require_double_precision()
    assert jax.numpy.ones(1).dtype == "float64"


def test_empty_cache_directory_switches_the_cache_off(monkeypatch):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    before = jax.config.jax_compilation_cache_dir
    use_compilation_cache()
    assert jax.config.jax_compilation_cache_dir == before
