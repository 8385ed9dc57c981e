"""Points as they are printed: units of the key, counts of each status, nan as a dash."""

import numpy as np
import pytest

from asperity.cli.study_output import (
    show_points,
    show_status,
    status_counts,
)
from asperity.joint.status import STATUS_NAMES

xarray = pytest.importorskip("xarray")
SLIPS = STATUS_NAMES.index("beyond_torque_capacity")


@pytest.fixture
def found():
    """Two preloads by two planet radii in SI units; one point slips."""
    dims = ("load.preload", "drive.planet_radius")
    stiffness = np.array([[5.0e6, 4.5e6], [4.0e6, np.nan]])
    return xarray.Dataset(
        {
            "status": (dims, np.array([[0, 0], [0, SLIPS]], dtype=np.int8)),
            "published_stiffness_output": (dims, stiffness),
        },
        coords={"load.preload": [1000.0, 800.0], "drive.planet_radius": [0.0135, 0.0136]},
    )


def test_counts_of_an_array_and_of_chunks(found):
    assert status_counts(found) == {0: 3, SLIPS: 1}
    pytest.importorskip("dask")
    assert status_counts(found.chunk({"load.preload": 1})) == {0: 3, SLIPS: 1}


def test_status_in_words(found, capsys):
    show_status(found)
    found["status"][0, 0] = -1
    show_status(found)
    told = capsys.readouterr().out.splitlines()
    slips = "  1 not solved: the output torque is beyond the torque capacity: a contact slips"
    assert told == [
        "4 points, 3 solved",
        slips,
        "4 points, 2 solved",
        "  1 not solved: not computed",
        slips,
    ]


def test_points_are_shown_in_the_unit_of_the_key(found, capsys):
    show_points(found)
    lines = capsys.readouterr().out.splitlines()
    head = lines[1].split("  ")
    for text in ("preload [N]", "planet radius [mm]", "published stiffness output [N·m/rad]", "status"):
        assert text in [word.strip() for word in head]
    rows = [line.split() for line in lines if line.strip().startswith(("1000", "800"))]
    assert rows == [
        ["1000", "13.5", "5e+06"],
        ["1000", "13.6", "4.5e+06"],
        ["800", "13.5", "4e+06"],
        ["800", "13.6", "-", "beyond", "torque", "capacity"],
    ]


def test_results_of_contacts_have_a_column_each_and_contacts_their_names(capsys):
    dims = ("load.preload",)
    contacts = ["sp", "pwr", "pwl", "wro", "wlo"]
    pressure = np.arange(1.0, 11.0).reshape(5, 2) * 1e8
    made = xarray.Dataset(
        {
            "status": (dims, np.zeros(2, dtype=np.int8)),
            "hertz_pressure": (("contact", *dims), pressure),
            "limiting_contact": (dims, np.array([0.0, 4.0]), {"categories": "sp pwr pwl wro wlo none"}),
        },
        coords={"load.preload": [800.0, 1000.0], "contact": contacts},
    )
    show_points(made)
    rows = [line.split() for line in capsys.readouterr().out.splitlines()]
    assert ["800", "100", "300", "500", "700", "900", "sp"] in rows  # MPa
    assert ["1000", "200", "400", "600", "800", "1000", "wlo"] in rows
