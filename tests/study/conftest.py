"""The paper's joint file, as the package ships it."""

from importlib.resources import files
from pathlib import Path

import pytest


@pytest.fixture(scope="session")
def zou_file() -> Path:
    return Path(str(files("asperity.case").joinpath("zou2025.toml")))
