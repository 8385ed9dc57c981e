"""``asperity draw``: files of every kind, and refusals before anything is written."""

from pathlib import Path

import pytest

from asperity.joint.planar.solve import solve_planar
from asperity.joint_file.planar_build import planar_joint_from_case
from asperity.joint_file.reader import read_case

EXAMPLE = Path(__file__).parents[2] / "examples" / "zou2025.toml"


@pytest.mark.parametrize("suffix", ["svg", "pdf", "png"])
def test_drawing_is_written_and_does_not_change(call, joint_file, tmp_path, suffix):
    file, found = joint_file(), []
    for name in "ab":
        outcome = call("draw", file, "--out", tmp_path / f"{name}.{suffix}")
        assert (outcome.code, outcome.out) == (0, "")
        found.append((tmp_path / f"{name}.{suffix}").read_bytes())
    assert found[0] == found[1]


def test_dxf_has_the_radii_and_forces_of_the_file(call, joint_file, tmp_path):
    ezdxf = pytest.importorskip("ezdxf", reason="the extra 'report' is not installed")
    assert call("draw", joint_file(), "--forces", "--out", tmp_path / "d.dxf").code == 0
    document = ezdxf.readfile(tmp_path / "d.dxf")
    radii = [c.dxf.radius for c in document.query('CIRCLE[layer=="OUTLINE"]')]
    for radius, count in ((4.0, 1), (13.5, 3), (5.0, 6), (40.0, 1)):
        assert sum(abs(each - radius) < 1e-9 for each in radii) == count
    texts = {text.dxf.text for text in document.query("TEXT")}
    assert {"%%c80", "sun %%c8", "Torque at the sun 0.5556 N·m, at the carrier 5 N·m."} <= texts
    assert "sp: N = 1001 N" in texts  # machine.md and model.md: 1001.05 N at 5 N*m


def test_overlapping_rollers_are_drawn_with_a_warning(call, joint_file, tmp_path):
    outcome = call("draw", joint_file(("planets = 3", "planets = 4")), "--out", tmp_path / "d.svg")
    assert outcome.code == 0
    assert "neighbouring planets -2.251  OVERLAP" in outcome.err


@pytest.mark.parametrize(
    ("change", "arguments", "said"),
    [
        (("planets = 3", "planets = 3"), ("--out", "d.step"), "must end in .svg, .pdf, .png or .dxf"),
        (('"5 mm"\nring', '"3 mm"\nring'), ("--out", "d.svg"), "cannot be drawn"),
        (("5 N*m", "50 N*m"), ("--forces", "--out", "d.svg"), "beyond the torque capacity"),
    ],
)
def test_refusals_write_nothing(call, joint_file, tmp_path, monkeypatch, change, arguments, said):
    monkeypatch.chdir(tmp_path)
    outcome = call("draw", joint_file(change), *arguments)
    assert outcome.code == 2
    assert said in outcome.err
    assert not list(tmp_path.glob("d.*"))


@pytest.mark.slow
def test_a_ring_under_a_preload_is_as_small_as_one_under_the_interference_that_makes_it(call, tmp_path):
    """The force of 30 µm, from the solved joint, gives back 99.94 mm; beyond the capacity it is not known."""
    ezdxf = pytest.importorskip("ezdxf", reason="the extra 'report' is not installed")
    example = EXAMPLE.with_name("planetary.toml")
    result, text = solve_planar(planar_joint_from_case(read_case(example))).result, example.read_text()
    file = tmp_path / "joint.toml"
    for torque, inside in (("10", "99.94"), ("1e5", "100 less 2 × interference")):
        pressed = text.replace('interference = "30 um"', f'preload = "{float(result.preload)!r} N"')
        file.write_text(pressed.replace('output_torque = "10 N', f'output_torque = "{torque} N'))
        outcome = call("draw", file, "--out", tmp_path / "d.dxf")
        assert (outcome.code, outcome.out) == (0, "")
        texts = {each.dxf.text for each in ezdxf.readfile(tmp_path / "d.dxf").query("TEXT")}
        assert f"ring inside %%c{inside}" in texts
