"""The wind-up as it is shown: angles in arcminutes, stages, and what follows once the input turns."""

import pytest
from shown_blocks import ARCMINUTE, amount, cells, four, sentences, tables

import asperity
from asperity.views.windup import windup

FIGURES = "Figures of the wind-up"
DEGREE = 60.0 * ARCMINUTE


@pytest.fixture(scope="module")
def wound(zou_file):
    return asperity.windup(asperity.load(zou_file))


@pytest.fixture(scope="module")
def document(wound):
    return wound.document


def test_figures_of_the_loop(wound, document):
    curve = wound.curve
    shown = {name: cell for name, (cell,) in cells(tables(windup(document))[FIGURES]).items()}
    assert shown["largest torque of the curve"] == "5 N·m"
    for name, value in (
        ("angle at the largest torque", curve.angle[-1]),
        ("hysteresis (width of the loop at zero torque)", curve.hysteresis),
        ("lost motion (middle of the loop, between ±3 % of the torque)", curve.lost_motion),
    ):
        assert (amount(shown[name]), shown[name].split()[1]) == (four(float(value) / ARCMINUTE), "arcmin")
    assert amount(shown["energy lost per cycle"]) == four(float(curve.dissipated_energy))
    assert shown["torque capacity, standing"] == "13.16 N·m: contact sp slips (both directions)"
    assert sentences(windup(document))[0] == (
        "Wind-up at the output, input locked, assembled (upper bound: pins rigid)."
    )


def test_stages_are_secants_of_the_curve(wound, document):
    """A third of the torque each, over the angle between them."""
    title = "Stages of the loading curve (secant stiffness; upper bound: pins rigid)"
    shown = tables(windup(document))[title]
    assert [row[:3] for row in shown.rows] == [
        ("K1", "0", "1.667"),
        ("K2", "1.667", "3.333"),
        ("K3", "3.333", "5"),
    ]
    for row, stiffness in zip(shown.rows, wound.curve.stage_stiffness, strict=True):
        assert [float(cell) for cell in row[3:]] == [
            four(float(stiffness)),
            four(float(stiffness) * ARCMINUTE),
        ]


def test_without_a_bound_the_stages_have_none(document):
    plain = document | {"stiffness_bound": None, "of_own_branches": True}
    blocks = list(windup(plain))
    assert "Stages of the loading curve (secant stiffness)" in tables(blocks)
    assert sentences(blocks)[0].endswith("assembled, of its own branches.")


def test_both_directions_where_they_differ(document):
    """Backwards the angle is larger: figures, stages and the joint that turns show both."""
    other = document | {
        "windup_rad": 2.0 * ARCMINUTE,
        "reverse_windup_rad": 3.0 * ARCMINUTE,
        "stages": [stage | {"reverse_stiffness_Nm_per_rad": 1e4} for stage in document["stages"]],
    }
    blocks = list(windup(other))
    shown = cells(tables(blocks)[FIGURES])
    assert shown["angle at plus the largest torque"] == ("2 arcmin",)
    assert shown["angle at minus the largest torque"] == ("-3 arcmin",)
    stages = tables(blocks)["Stages of the loading curve (secant stiffness; upper bound: pins rigid)"]
    assert stages.head[-2:] == ("reverse\nN·m/rad", "reverse\nN·m/arcmin")
    assert [row[-2] for row in stages.rows] == ["10000"] * 3
    turning = tables(blocks)["When the input turns under 5 N·m"]
    assert turning.head[3:] == ("input, reverse\ndeg", "output, reverse\ndeg")
    assert {len(row) for row in turning.rows} == {5}
    assert any(" and, reverse, " in said for said in sentences(blocks))


def test_the_input_that_turns(document):
    """The output turns nine times less; each contact has rolled its width."""
    blocks = list(windup(document))
    shown = tables(blocks)["When the input turns under 5 N·m"]
    assert len(shown.rows) == 3
    for row in shown.rows:
        assert float(row[1]) == pytest.approx(9.0 * float(row[2]), rel=5e-3)
    turning = document["rolling"]
    limit = turning["static_curve_up_to"]["input_rad"] / DEGREE
    assert float(shown.rows[0][1]) == four(limit)
    drift = turning["drift_rad_per_output_turn"] / ARCMINUTE
    assert f"In steady rolling the output drifts by {drift:.4g} arcmin per output turn." in sentences(blocks)
    contacts = tables(blocks)["Contacts of the joint that begins to turn"]
    for name, contact in turning["contacts"].items():
        width, rolled, _, share = cells(contacts)[name]
        assert float(width) == four(1e6 * contact["width_m"])
        assert float(rolled) == four(contact["rolls_its_width_in"]["input_rad"] / DEGREE)
        assert float(share) == four(100.0 * contact["share_of_drift"])
    assert sum(float(row[-1]) for row in contacts.rows) == pytest.approx(100.0, abs=0.05)
    assert any(said.startswith("Stiffness and drift are two regimes.") for said in sentences(blocks))


def test_why_nothing_is_said_of_an_input_that_turns(document):
    unknown = document["rolling"] | {"unknown_because": ["no steady rolling: sp slips"]}
    blocks = list(windup(document | {"rolling": unknown}))
    assert sentences(blocks)[-1] == "When the input turns under 5 N·m: no steady rolling: sp slips."
    assert len(tables(blocks)) == 2
