"""Both kinds of joints asked alike."""

from types import SimpleNamespace

import pytest

from asperity.errors import InputError
from asperity.joint import either_kind
from asperity.joint.either_kind import refuse_no_room, solve_any, under_torque, unloaded_ratio
from asperity.joint_file.planar_build import planar_joint_from_case
from asperity.joint_file.reader import parse_case, read_case


def test_each_kind_has_its_solver_and_its_sense_of_rotation(zou_file, monkeypatch):
    planar, own = (
        planar_joint_from_case(read_case(zou_file.with_name(f"{name}.toml")))
        for name in ("planetary", "zou2025")
    )
    monkeypatch.setattr(either_kind, "solve", lambda joint: SimpleNamespace(kind="own"))
    monkeypatch.setattr(either_kind, "solve_planar", lambda joint: SimpleNamespace(kind="planar"))
    assert [solve_any(joint).kind for joint in (planar, own)] == ["planar", "own"]
    for joint, sense in ((planar, 1.0), (own, -1.0)):
        turned = under_torque(joint, -3.0)
        assert float(turned.output_torque) == -3.0
        assert float(turned.sun_speed) == pytest.approx(sense * float(joint.sun_speed))


@pytest.mark.parametrize(
    ("name", "message"), [("zou2025", "gap is .* it must be above 0 mm"), ("planetary", "overlap")]
)
def test_bodies_that_do_not_fit_are_refused(zou_file, name, message):
    """Thirty planets around a sun, where there were three."""
    text = zou_file.with_name(f"{name}.toml").read_text(encoding="utf-8")
    refuse_no_room(planar_joint_from_case(parse_case(text, source="x")))
    crowded = text.replace("planets = 3\n", "planets = 30\n")
    with pytest.raises(InputError, match=message):
        refuse_no_room(planar_joint_from_case(parse_case(crowded, source="x")))


@pytest.mark.parametrize(("name", "ratio"), [("zou2025", 9.0), ("planetary", 6.0), ("planar", -9.0)])
def test_ratio_without_creep(zou_file, name, ratio):
    """1 + R_o/R_s of the paper, against the sense of the sun; 1 + R_r/R_s of the planetary."""
    joint = planar_joint_from_case(read_case(zou_file.with_name(f"{name}.toml")))
    assert abs(unloaded_ratio(joint)) == pytest.approx(abs(ratio), rel=1e-9)
