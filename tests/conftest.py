"""Shared set-up: double precision, strict promotion, and where the optional shared measurement files live."""

import os
from pathlib import Path

import jax
import pytest

jax.config.update("jax_enable_x64", True)
jax.config.update("jax_numpy_dtype_promotion", "strict")

SHARED = Path(os.environ.get("ASPERITY_SHARED_DATA", Path(__file__).parents[2] / "shared"))


@pytest.fixture(scope="session")
def shared_data() -> Path:
    """Folder of measured instrument files; tests on them skip where it is absent."""
    folder = SHARED / "data"
    if not folder.is_dir():
        pytest.skip(f"measured files are not here: {folder} does not exist (set ASPERITY_SHARED_DATA)")
    return folder
