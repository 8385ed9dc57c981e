"""``asperity roll``: the two numbers side by side, powers by hand, a sun that stands, and refusals."""

import json

import pytest

ARCMINUTE = 3.141592653589793 / 10800.0
EXTRAS = """
[rolling]
skew = "1 mrad"
hysteresis_factor = 0.01

[[duty]]
output_torque = "5 N*m"
sun_speed = "6000 rpm"
share = 1.0
"""


@pytest.mark.slow
def test_document_and_picture(call, joint_file, tmp_path):
    warm = 'yield_strength = "1200 MPa"\nthermal_conductivity = "50 W/m/K"\nspecific_heat_capacity = "460 J/kg/K"'
    file = joint_file(('yield_strength = "450 MPa"', warm))
    file.write_text(file.read_text() + EXTRAS)
    outcome = call("roll", file, "--json", "--plot", tmp_path / "r.svg")
    assert outcome.code == 0
    assert "wrote" in outcome.err
    found = json.loads(outcome.out)
    losses, rolling = found["losses_W"], found["rolling"]
    assert losses["oil"] is None
    counted = sum(losses[cause] for cause in ("creep", "skew", "hysteresis", "bearings"))
    assert losses["total"] == pytest.approx(counted, rel=1e-9)
    carrier = 6000.0 * 3.141592653589793 / 30.0 / 9.0 * (1.0 - found["speed_loss"])
    assert rolling["output_power_W"] == pytest.approx(5.0 * carrier, rel=1e-9)
    assert found["efficiency"] == pytest.approx(5.0 * carrier / (5.0 * carrier + counted), rel=1e-9)
    assert rolling["duty_life_hours"] == pytest.approx(
        found["life_hours"], rel=1e-6
    )  # one load, all the time
    sun, width = rolling["contacts"]["sp"], found["standing"]["contacts"]["sp"]["hertz_half_width_m"]
    power = (sun["losses_W"]["creep"] + sun["losses_W"]["skew"]) / (3.0 * 5e-3)
    speed = 4e-3 * (6000.0 * 3.141592653589793 / 30.0 + carrier)
    even = 1.11 * power / ((2.0 * width) ** 0.5 * 2.0 * (50.0 * 7850.0 * 460.0 * speed) ** 0.5)
    slips = 1.0 - sun["stick_fraction"]
    assert 1.0 < sun["flash_temperature_K"] / (even / slips**0.5) < 1.1
    assert sun["film_thickness_m"] is None
    assert rolling["duty"] == {
        "1": {
            "damage_share": pytest.approx(1.0),
            "film_ratio": None,
            "life_hours": pytest.approx(found["life_hours"], rel=1e-9),
            "shakedown_ratio": pytest.approx(
                max(each["shakedown_ratio"] for each in found["rolling"]["contacts"].values())
            ),
        }
    }
    # mu N_0 9 n R_s is 12.96; of a smooth sun 1 mrad takes 3.3 % of it, with 3.24e-3 and 4.63e-3 at gross slip; the
    # left loading roller's ring contact, from which the torque takes normal force, has less left and slips first
    share = (1.0 / 4.63) ** 2
    smooth = ((1.0 - share) / (1.0 - share + share * 4.63 / 3.24)) ** 0.5
    assert 10.0 < rolling["torque_capacity_Nm"] < 12.96 * smooth
    assert min(c["axial_force_N"] for c in rolling["contacts"].values()) > 0.0
    assert (tmp_path / "r.svg").read_text().count("gross slip") >= 1


def test_table_of_a_standing_sun(call, joint_file):
    outcome = call("roll", joint_file(("6000 rpm", "0 rpm")))
    assert (outcome.code, outcome.err) == (0, "")
    lines = [" ".join(line.split()) for line in outcome.out.splitlines()]
    (drift,) = [line for line in lines if line.startswith("drift per output turn")]
    assert 35.3 < float(drift.split()[4]) < 60.0
    assert "arcmin" in drift
    assert any(line.startswith("stiffness at standstill") and "N·m/arcmin" in line for line in lines)
    assert any(line.startswith("The sun stands: drift and life are per turn") for line in lines)
    assert "Axial thrust: none, the axes are parallel." in lines
    (drive,) = [line for line in lines if line.startswith("the drive")]
    assert drive.split()[2] == "–"
    assert drive.split()[3] == "–"
    assert any(line.startswith("No rating life: at sp, pwr the Hertz pressure exceeds") for line in lines)
    titles = ["Position of", "Contacts", "Axial thrust", "Rating life", "Warnings", "Assump"]
    places = [next(i for i, line in enumerate(lines) if line.startswith(title)) for title in titles]
    assert places == sorted(places)


@pytest.mark.parametrize(
    ("change", "arguments", "said"),
    [
        (
            ("5 N*m", "50 N*m"),
            (),
            "is beyond the standing torque capacity 13.16 N·m, at which contact sp slips",
        ),
        (
            ("5 N*m", "5 N*m"),
            ("--plot", "r.xyz"),
            "r.xyz: the name of an image must end in .png, .svg or .pdf",
        ),
    ],
)
def test_refusals(call, joint_file, change, arguments, said):
    outcome = call("roll", joint_file(change), *arguments)
    assert (outcome.code, outcome.out) == (2, "")
    assert said in outcome.err
