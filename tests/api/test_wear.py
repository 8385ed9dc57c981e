"""Wear in a script: what the command prints, as an object."""

from pathlib import Path

import pytest

import asperity
from asperity.errors import InputError

EXAMPLES = Path(__file__).parents[2] / "examples"


def test_document_frame_text_and_picture():
    found = asperity.wear(asperity.load(EXAMPLES / "wear.toml"), life="5000 h")
    assert found.document["wear"]["life_hours"] == pytest.approx(5000.0)
    frame = found.to_frame()
    assert list(frame.columns[:2]) == ["kt_s_per_Pa", "hours"]
    assert len(frame) == len(found.document["wear"]["hours"])
    assert "first contact slides" in repr(found)
    assert found.plot()._repr_png_().startswith(b"\x89PNG")


def test_what_is_refused():
    joint = asperity.load(EXAMPLES / "wear.toml")
    with pytest.raises(InputError, match="expected a time"):
        asperity.wear(joint, life="5 um")
    with pytest.raises(InputError, match="expected a joint"):
        asperity.wear("joint.toml")
    with pytest.raises(InputError, match=r"load\.preload"):
        asperity.wear(asperity.load(EXAMPLES / "zou2025.toml"))
