"""Where commands run."""

import pytest


@pytest.fixture
def own_folder(monkeypatch, tmp_path):
    """Commands write into a folder of the test's own, and keep no compiled programs."""
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    monkeypatch.chdir(tmp_path)
    return tmp_path
