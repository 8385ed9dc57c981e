"""The joint that turns, as it is shown: drift beside stiffness, losses, films, thrust and life."""

import math

import pytest
from shown_blocks import ARCMINUTE, amount, cells, four, sentences, tables, with_document

from asperity.views.blocks import Bullets
from asperity.views.rolling import films, rolling

POSITION = "Position of the output: drift beside stiffness"
SKEWED = (("[lubrication]", '[rolling]\nskew = { sp = "0.5 mrad", pr = "-0.8 mrad" }\n\n[lubrication]'),)
DUTY = "".join(
    f'\n[[duty]]\noutput_torque = "{torque} N*m"\nsun_speed = "{speed} rpm"\nshare = {share}\n'
    for torque, speed, share in ((10, 1500, 0.25), (-5, 3000, 0.75))
)
LIFE = '\n[rolling]\nrequired_life = "{} h"\n'


def with_rolling(view, **changes):
    return with_document(view, rolling=view.document["rolling"] | changes)


def losses_of(blocks):
    (table,) = (table for title, table in tables(blocks).items() if title.startswith("Losses"))
    return table


def test_drift_stands_beside_the_stiffness(planetary_view):
    """10 N·m on the stiffness come back; the drift of every turn does not."""
    result = planetary_view.solved.result
    stiffness = float(result.assembly.stiffness.output)
    expected = {
        "drift per output turn": (float(result.rolling.drift_per_output_turn) / ARCMINUTE, "arcmin"),
        "speed loss": (100.0 * float(result.rolling.speed_loss), "%"),
        "stiffness at standstill": (stiffness * ARCMINUTE, "N·m/arcmin"),
        "torque over stiffness": (10.0 / stiffness / ARCMINUTE, "arcmin"),
        "torque capacity, rolling": (
            float(planetary_view.solved.solution.rolling_capacity.output_torque),
            "N·m",
        ),
    }
    shown = cells(tables(rolling(planetary_view))[POSITION])
    assert list(shown) == list(expected)
    for name, (value, unit) in expected.items():
        text = shown[name][0]
        assert (amount(text), text.partition(" ")[2]) == (four(value), unit), name
    standing = float(planetary_view.solved.solution.standing_capacity.output_torque)
    assert f"standing: {standing:.4g} N·m" in shown["torque capacity, rolling"][1]
    assert shown["stiffness at standstill"][1].endswith("(upper bound: pins rigid)")


def test_losses_by_contact_and_in_all(planetary_view):
    """Power out over efficiency is power in, less the sum of all losses."""
    shown, turning = losses_of(rolling(planetary_view)), planetary_view.document["rolling"]
    assert shown.title == (
        f"Losses; efficiency {100.0 * turning['efficiency']:.4g} %, power in {turning['input_power_W']:.4g} W, out "
        f"{turning['output_power_W']:.4g} W"
    )
    rows = cells(shown)
    assert list(rows) == ["sp", "pr", "bearings and pins", "all"]
    for name, contact in turning["contacts"].items():
        creep, skew, hysteresis, oil, total = rows[name]
        losses = contact["losses_W"]
        assert (hysteresis, skew) == ("–", "0")  # the file states no hysteresis factor
        assert [float(cell) for cell in (creep, oil, total)] == [
            four(losses["creep"]),
            four(losses["oil"]),
            four(losses["creep"] + losses["oil"]),
        ]
    assert float(rows["all"][-1]) == four(turning["input_power_W"] - turning["output_power_W"])
    assert rows["bearings and pins"] == ("", "", "", "", "–")  # nor a section [bearings]


def test_losses_of_bearings_are_friction_times_speed(view_of):
    """Two bearings a shaft: 2·0.01 N·m at 1500 rpm and 2·0.03 N·m at a sixth of it, less the creep."""
    friction = '\n[bearings]\ninput_torque = "0.01 N*m"\noutput_torque = "0.03 N*m"\n'
    rows = cells(losses_of(rolling(view_of("planetary", more=friction))))
    power = (2.0 * 0.01 + 2.0 * 0.03 / 6.0) * 1500.0 * math.pi / 30.0
    *others, lost = rows["bearings and pins"]
    assert (others, float(lost)) == ([""] * 4, pytest.approx(power, rel=2e-3))


def test_a_sun_that_stands_has_no_losses_and_says_why(view_of):
    blocks = list(rolling(view_of("tutorial_joint")))
    assert not any(title.startswith("Losses") for title in tables(blocks))
    assert any(said.startswith("The sun stands: drift and life are per turn") for said in sentences(blocks))
    reasons = next(block for block in blocks if isinstance(block, Bullets))
    assert blocks.index(reasons) < blocks.index(tables(blocks)["Contacts in rolling"])
    drive = cells(tables(blocks)["Rating life L10"])["the drive"]
    assert drive[0] == "–"  # no time


def test_contacts_in_rolling_by_their_units(planetary_view):
    """Pressure by Hertz; slip ratio T/(mu N); creepage by Carter, in thousandths, times what the asperities add.

    b² = 4 N R/(pi E* L), p = 2 N/(pi b L), creepage mu b/R (1 - sqrt(1 - T/(mu N))); L = 10 mm, of two bodies of 52100.
    """
    modulus, friction, length = 203e9 / (2.0 * (1.0 - 0.29**2)), 0.08, 10e-3
    radii = {"sp": 1e-3 / (1.0 / 10.0 + 1.0 / 20.0), "pr": 1e-3 / (1.0 / 20.0 - 1.0 / 50.0)}
    shown = tables(rolling(planetary_view))["Contacts in rolling"]
    heads = [head.replace("\n", " ") for head in shown.head]
    for name, radius in radii.items():
        contact = planetary_view.document["rolling"]["contacts"][name]
        cells_of = zip(heads[1:], cells(shown)[name], strict=True)
        row = {head: float(cell) for head, cell in cells_of}
        normal, slip = contact["normal_N"], row["slip ratio -"]
        half_width = math.sqrt(4.0 * normal * radius / (math.pi * modulus * length))
        hertz = row["Hertz pressure MPa"]
        assert hertz == four(1e-6 * 2.0 * normal / (math.pi * half_width * length))
        assert 0.9 * hertz < row["rough pressure MPa"] < hertz
        assert row["traction T/N -"] == four(contact["traction_coefficient"])
        assert slip == pytest.approx(row["traction T/N -"] / friction, rel=1e-3)
        carter = friction * half_width / radius * (1.0 - math.sqrt(1.0 - slip))
        # the asperities yield some 3 % of what the bodies do, sideways as well, and widen the contact
        over_smooth = row["creepage over smooth times"]
        assert 1.0 < over_smooth < 1.1
        assert row["creepage 10⁻³"] == pytest.approx(1e3 * carter * over_smooth, rel=2e-3)
        assert row["over shakedown limit -"] == four(contact["shakedown_ratio"])


def test_film_and_flash_temperature_where_they_are_known(paper_view, planetary_view):
    """Between half and three times the roughness both carry the load; nothing of it known is no table."""
    assert list(films(paper_view.document)) == []
    (shown,) = films(planetary_view.document)
    turning = planetary_view.document["rolling"]
    for name, contact in turning["contacts"].items():
        rise, *others = cells(shown)[name]
        assert float(rise) == four(contact["flash_temperature_K"])
        assert others == ["–", "–", "–"]  # no pressure coefficient of the oil
    contacts = turning["contacts"]
    known = contacts["sp"] | {"film_thickness_m": 4e-7, "film_ratio": 1.6}
    changed = planetary_view.document | {"rolling": turning | {"contacts": contacts | {"sp": known}}}
    shown, bands = films(changed)
    assert cells(shown)["sp"][1:] == ("0.4", "1.6", "mixed")
    assert "mixed to 3, the oil film carries part of the load" in bands.text
    stated = changed["input"] | {"life": {"cleanliness": 0.5}}
    known = {name: contact | {"life_factor": None} for name, contact in contacts.items()}
    known["sp"] |= {"film_thickness_m": 4e-7, "film_ratio": 1.6, "life_factor": 0.4321}
    shown, _ = films(changed | {"input": stated, "rolling": turning | {"contacts": known}})
    assert shown.head[-1] == "film factor\nof the life"
    assert [cells(shown)[name][-1] for name in ("sp", "pr")] == ["0.4321", "–"]


def test_axes_that_are_parallel_give_no_thrust(planetary_view):
    blocks = list(rolling(planetary_view))
    assert "Axial thrust: none, the axes are parallel." in sentences(blocks)
    assert not any("xial" in title for title in tables(blocks))


def test_skew_gives_thrust_and_takes_friction(view_of):
    """What acts on the driven body of each contact, and on each body in all."""
    view = view_of("planetary", *SKEWED)
    turning = view.document["rolling"]
    shown = tables(rolling(view))
    forces = cells(shown["Axial force of each contact on its driven body"])
    assert {name: float(cell) for name, (cell,) in forces.items()} == {
        name: four(contact["axial_force_N"]) for name, contact in turning["contacts"].items()
    }
    thrust = cells(shown["Axial thrust on each body"])
    assert {name: float(cell) for name, (cell,) in thrust.items()} == {
        name: four(force) for name, force in turning["axial_thrust_N"].items()
    }
    assert any(float(cell) != 0.0 for (cell,) in thrust.values())


def test_a_contact_whose_friction_is_used_by_skew_slips_as_a_whole(planetary_view):
    """Of 0.08, 0.072 are left where skew takes a tenth, and 0.064 where it takes a fifth; the sun needs 0.068."""
    contacts = planetary_view.document["rolling"]["contacts"]

    def slipping(loss):
        used = contacts | {"sp": contacts["sp"] | {"capacity_loss": loss}}
        blocks = rolling(with_rolling(planetary_view, contacts=used))
        return [text for text in sentences(blocks) if "slips as a whole" in text]

    (said,) = slipping(0.20)
    assert said.startswith("sp: slips as a whole, because skew uses part of the friction")
    assert slipping(0.10) == slipping(0.0) == []


def test_lives_of_drive_and_bodies(planetary_view, view_of):
    turning = planetary_view.document["rolling"]
    lives = cells(tables(rolling(planetary_view))["Rating life L10"])
    assert list(lives) == ["the drive", "sun", "one planet", "ring"]
    assert [float(cell) for cell in lives["the drive"]] == [
        four(turning["life_hours"]),
        four(turning["life_output_turns"]),
    ]
    # turns of the output at 250 rpm less the creep
    speed = 250.0 * 60.0 * (1.0 - turning["speed_loss"])
    assert float(lives["one planet"][1]) == four(speed * float(lives["one planet"][0]))
    # no film factor enters L10; of 99 % it is another one
    assert "Rating life L1" in tables(rolling(with_rolling(planetary_view, reliability=0.99)))
    stepped = cells(tables(rolling(view_of("stepped_planet")))["Rating life L10"])
    assert {"held ring", "driven ring"} <= set(stepped)


def test_why_there_is_no_life(paper_view, planetary_view):
    assert any(said.startswith("No rating life: at sp, pwr") for said in sentences(rolling(paper_view)))
    assert not any("No rating life" in said for said in sentences(rolling(planetary_view)))
    assert cells(tables(rolling(paper_view))["Rating life L10"])["the drive"] == ("–", "–")


def test_a_duty_has_a_row_for_each_load(view_of):
    """Shares of the damage make the whole; Miner's rule on the lives under each load alone."""
    view = view_of("planetary", more=DUTY)
    shown = tables(rolling(view))
    turning = view.document["rolling"]
    rows = cells(shown["Duty, damage summed by Miner's rule"])
    assert rows["1"][:3] == ("10 N·m", "1500 rpm", "25 %")
    assert rows["2"][:3] == ("-5 N·m", "3000 rpm", "75 %")
    lives = {name: float(row[4]) for name, row in rows.items()}
    damage = {"1": 0.25 / lives["1"], "2": 0.75 / lives["2"]}
    for name, row in rows.items():
        assert amount(row[3]) == pytest.approx(100.0 * damage[name] / sum(damage.values()), rel=2e-3)
    under_duty = cells(shown["Rating life L10"])["the drive under the duty"]
    assert float(under_duty[0]) == pytest.approx(1.0 / sum(damage.values()), rel=2e-3)
    assert float(under_duty[1]) == four(turning["duty_life_output_turns"])


def test_what_a_life_has_to_reach_is_compared(view_of):
    """Of the drive and of the duty: met, not met."""
    for hours, said in ((1000, "met"), (10**9, "NOT met")):
        view = view_of("planetary", more=LIFE.format(hours))
        found = [
            text for text in sentences(rolling(view)) if f"required {hours:.4g}".replace("e+0", "e") in text
        ]
        assert [text.rpartition(": ")[2] for text in found] == [said], sentences(rolling(view))


def test_lives_of_bearings_and_lives_that_are_not_known(planetary_view):
    words = {"limit_shown": "20000 h", "meaning": "it lives", "severity": "damage", "infinite": False}
    entries = [
        words | {"name": f"required_{name}", "label": name, "contact": contact} | found
        for name, contact, found in (
            ("bearing_life", "planet_pin", {"value": 3.6e6, "shown": "1000 h", "ok": False, "known": True}),
            ("duty_life", None, {"value": None, "shown": "not known", "ok": False, "known": False}),
        )
    ]
    view = with_document(planetary_view, diagnostics=[*planetary_view.document["diagnostics"], *entries])
    assert [text for text in sentences(rolling(view)) if "required" in text] == [
        "bearing_life, planet pin 1000 h, required 20000 h: NOT met",
        "duty_life not known, required 20000 h; it lives",
    ]


def test_against_the_torque_the_reverse_capacity_counts(view_of):
    view = view_of("planetary", ('output_torque = "10 N*m"', 'output_torque = "-10 N*m"'))
    reverse = float(view.solved.solution.reverse_rolling_capacity.output_torque)
    shown = cells(tables(rolling(view))[POSITION])
    assert amount(shown["torque capacity, rolling"][0]) == four(abs(reverse))
    assert math.isfinite(amount(shown["drift per output turn"][0]))
