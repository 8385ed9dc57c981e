"""``asperity wear``: tables, picture, document, and one clear message for what is refused."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"
WEAR = EXAMPLES / "wear.toml"


def test_text_and_picture(call, tmp_path):
    image = tmp_path / "wear.png"
    told = call("wear", WEAR, "--life", "8000 h", "--plot", image)
    assert told.code == 0, told.err
    for words in (
        "first contact slides",
        "nothing left",
        "after 8000 h",
        "Depth of wear at the start",
        "loading roller",
    ):
        assert words in told.out
    assert image.stat().st_size > 10_000


def test_document(call):
    told = call("wear", WEAR, "--json")
    assert told.code == 0, told.err
    found = json.loads(told.out)["wear"]
    assert found["life_hours"] == pytest.approx(10000.0)
    assert found["hours"][-1] == pytest.approx(found["nothing_left_hours"])
    assert found["first_slide_kt_s_per_Pa"] == pytest.approx(found["first_slide_hours"] * 3600.0 * 1e-17)


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--life", "10 um"), "--life: expected a time"),
        (("--life", "0 h"), "rolling.required_life: 0 h is not allowed; it must be above 0 h"),
    ],
)
def test_refusals(call, options, said):
    told = call("wear", WEAR, *options)
    assert (told.code, told.out) == (2, "")
    assert said in told.err
    assert len(told.err.strip().splitlines()) == 1


def test_a_preload_force(call):
    told = call("wear", EXAMPLES / "zou2025.toml")
    assert (told.code, told.out) == (2, "")
    assert "state load.interference" in told.err
    assert len(told.err.strip().splitlines()) == 1


def test_a_picture_of_nothing_that_changes(call, tmp_path):
    text = (EXAMPLES / "zou2025.toml").read_text()
    file = tmp_path / "cam.toml"
    file.write_text(
        text.replace('preload = "1000 N"', 'preload = "200 N"\ncam_force_per_torque = "160 N/Nm"')
    )
    told = call("wear", file, "--plot", tmp_path / "cam.png")
    assert (told.code, told.out) == (2, "")
    assert "ask for no picture" in told.err
    assert "--plot" in told.err
    told = call("wear", file)
    assert told.code == 0, told.err
    assert "the preload stays" in told.out


@pytest.mark.slow
def test_neither_jax_nor_matplotlib():
    code = (
        "import sys; from asperity.joint_file.reader import read_case;"
        "from asperity.joint_file.wear import wear_of_case;"
        f"wear_of_case(read_case({str(WEAR)!r})); print({{'jax', 'matplotlib'}} & set(sys.modules))"
    )
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert ran.stdout.strip() == "set()"
