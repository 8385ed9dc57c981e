"""What to type for an optional package depends on where the installation came from."""

import json
import sys
from importlib.metadata import PackageNotFoundError

import pytest

from asperity import extras
from asperity.errors import MissingExtraError
from asperity.extras import install_command, optional_module


@pytest.mark.parametrize(
    ("origin", "command"),
    [
        (None, "pip install 'asperity[study]'"),
        ({"url": "https://host/asperity-1.whl", "archive_info": {}}, "pip install 'asperity[study]'"),
        (
            {"url": "file:///home/a%20b/asperity", "dir_info": {}},
            "pip install '.[study]' in the folder /home/a b/asperity",
        ),
        (
            {"url": "file:///home/asperity", "dir_info": {"editable": True}},
            "pip install '.[study]' in the folder /home/asperity",
        ),
    ],
)
def test_the_command_fits_the_installation(monkeypatch, origin, command):
    class Installed:
        def read_text(self, name):
            assert name == "direct_url.json"
            return None if origin is None else json.dumps(origin)

    monkeypatch.setattr(extras, "distribution", lambda name: Installed())
    assert install_command("study") == command


def test_a_source_that_is_not_installed(monkeypatch, tmp_path):
    def absent(name):
        raise PackageNotFoundError(name)

    monkeypatch.setattr(extras, "distribution", absent)
    module = tmp_path / "src" / "asperity" / "extras.py"
    monkeypatch.setattr(extras, "__file__", str(module))
    assert install_command("bayes") == "pip install 'asperity[bayes]'"  # no source around it
    (tmp_path / "pyproject.toml").touch()
    assert install_command("bayes") == f"pip install '.[bayes]' in the folder {tmp_path}"


def test_a_missing_package_is_named_with_what_needs_it_and_what_installs_it(monkeypatch):
    assert optional_module("json", extra="study", needs="tables need") is json
    monkeypatch.setitem(sys.modules, "absent", None)
    with pytest.raises(
        MissingExtraError, match=r"^tables need the package 'absent', .*\[study\].*; text needs none$"
    ):
        optional_module("absent", extra="study", needs="tables need", otherwise="text needs none")
