"""The types of drives: found by their files; what does not fit together is refused with the name of the file."""

import dataclasses
import sys
import types as modules

import numpy as np
import pytest

from asperity.drive import types
from asperity.drive.layout.drive import gaps, speed_ratio
from asperity.drive.layout.drive_type import DriveType, Pairing
from asperity.drive.layout.sizes import ContactLength
from asperity.drive.types import DEFAULT_TYPE, FORMER_NAMES, TYPES
from asperity.drive.types.planetary import PLANETARY, planetary_drive


def test_every_file_of_the_folder_is_a_type_and_one_of_them_needs_no_name():
    assert set(TYPES) >= {"wedge", "planetary", "multiroller", "stepped_planet", "planar"}
    assert (DEFAULT_TYPE, FORMER_NAMES["zou2025"]) == ("wedge", "wedge")
    assert [TYPES[name].rank for name in TYPES] == sorted(kind.rank for kind in TYPES.values())


def changed(**changes):
    """Fields of the planetary type, some of them changed."""
    fields = {
        field.name: getattr(PLANETARY, field.name) for field in dataclasses.fields(PLANETARY) if field.init
    }
    return {name: value for name, value in (fields | changes).items() if value is not None}


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"layout": None}, "missing 1 required keyword-only argument: 'layout'"),
        (
            {"contacts": (Pairing("sp", "sun", "moon"),)},
            "contact 'sp' joins 'moon', which is none of its parts",
        ),
        ({"output": "arm"}, "output = 'arm' is none of its members"),
        (
            {
                "contacts": PLANETARY.contacts[:1],
                "branches": dataclasses.replace(PLANETARY.branches, deviations={}),
            },
            "branches.deviations must name planet, the tracks off the axis",
        ),
        (
            {"sizes": tuple(each for each in PLANETARY.sizes if not isinstance(each, ContactLength))},
            "its sizes have no ContactLength",
        ),
    ],
)
def test_a_type_that_is_not_complete_cannot_be_made(changes, message):
    with pytest.raises(TypeError, match=message):
        DriveType(**changed(**changes))


def test_a_mistake_of_a_file_is_told_with_its_name(monkeypatch):
    empty = modules.ModuleType("asperity.drive.types.empty")
    monkeypatch.setitem(sys.modules, "asperity.drive.types.empty", empty)
    with pytest.raises(
        TypeError, match=r"drive/types/empty\.py: a file of this folder states one DriveType, this one 0"
    ):
        types._type_in("empty")

    def broken(name):
        raise TypeError("the drive type 'empty': output = 'arm' is none of its members")

    monkeypatch.setattr(types.importlib, "import_module", broken)
    with pytest.raises(TypeError, match=r"drive/types/empty\.py: the drive type 'empty': output"):
        types._type_in("empty")


def test_a_type_makes_the_drive_of_its_sizes():
    """R_s = 10, R_p = 20: a ring of 50 mm, a ratio of 1 + 50/10, planets at 30 mm; numbers may be whole."""
    drive = planetary_drive(sun_radius=10, planet_radius=20, planet_count=3)
    np.testing.assert_allclose(gaps(drive), 0.0, atol=1e-12)
    assert float(speed_ratio(drive)) == pytest.approx(6.0, rel=1e-14)
    np.testing.assert_array_equal(drive.centres[1], [0.0, 30.0])
    assert PLANETARY.sides_of_track("planet") == [("sp", "second"), ("pr", "first")]
