import pytest

import asperity
from asperity.errors import InputError, NoSolutionError

pytestmark = pytest.mark.slow

DESIGN = """
joint = "zou2025.toml"
[variables]
load.preload = { lower = "300 N", upper = "3000 N" }
[objective]
maximise = "stiffness"
[constraints]
pressure_over_first_yield = { at_most = %s }
shakedown_ratio = { at_most = 2.0 }
[search]
starts = 1
"""


@pytest.fixture(scope="module")
def folder(zou_file, tmp_path_factory):
    made = tmp_path_factory.mktemp("design")
    (made / "zou2025.toml").write_text(zou_file.read_text(encoding="utf-8"), encoding="utf-8")
    (made / "design.toml").write_text(DESIGN % 2.0)
    (made / "impossible.toml").write_text(DESIGN % 0.1)
    return made


@pytest.fixture(scope="module")
def found(folder):
    return asperity.design(folder / "design.toml")


@pytest.mark.long
def test_values_are_those_of_the_command(found, folder, printed):
    document = printed("design", folder / "design.toml")
    assert found["load.preload"].si == pytest.approx(document["variables"]["load.preload"], rel=1e-9)
    assert found.to_frame().loc["load.preload", "unit"] == "N"
    assert found.result.objective_after == pytest.approx(document["objective"]["after"], rel=1e-9)


@pytest.mark.long
def test_the_designed_joint_keeps_its_limit_when_it_is_solved(found):
    """The limit is active: pressure rises with the preload, and so does the stiffness."""
    solution = found.joint.solve()
    assert 2.0 * (1.0 - 1e-3) < solution["pressure_over_first_yield"].si.max() <= 2.0 * (1.0 + 1e-7)
    assert solution["stiffness"].si == pytest.approx(found.result.objective_after, rel=1e-9)


@pytest.mark.long
def test_text_and_figure(found):
    text = repr(found)
    assert (
        "All limits of the design file are met, which allows: Hertz pressure over first yield 2 at sp" in text
    )
    assert "load.preload" in text
    assert found.plot().axes
    with pytest.raises(InputError, match=r"no free number of the design 'drive.planets'"):
        found["drive.planets"]


@pytest.mark.long
def test_limits_that_conflict_are_one_message(folder):
    with pytest.raises(NoSolutionError, match="Hertz pressure over first yield"):
        asperity.design(folder / "impossible.toml")
