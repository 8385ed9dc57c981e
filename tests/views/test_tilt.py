"""Tilted axes as they are shown: angles in milliradians, and edges without a pressure."""

from shown_blocks import cells, sentences, tables

from asperity.views.tilt import tilt

LINE = {
    "slope_rad": 0.598e-3,
    "skew_rad": None,
    "peak_over_mean": 1.41,
    "end_over_mean": 1.41,
    "edge": True,
    "peak_pressure_Pa": None,
    "sideways_over_friction": 0.37,
}
FREE = LINE | {"end_over_mean": 0.0, "edge": False, "peak_pressure_Pa": 1.5e9, "skew_rad": 1e-3}
DOCUMENT = {
    "axes": {"sun_axis": {"out_rad": 1e-3, "across_rad": 0.2e-3}},
    "contacts": {
        "sp": {"as_stated": LINE, "in_any_direction": FREE},
        "pr": {"as_stated": FREE, "in_any_direction": FREE},
    },
    "unknown_because": None,
    "notes": ["Edge: an end of the line carries load."],
}


def test_a_table_as_stated_and_one_in_the_worst_direction():
    shown = tables(tilt(DOCUMENT))
    stated, worst = shown
    assert stated == "Tilted axes, as stated: sun axis 1 mrad out and 0.2 mrad across"
    assert worst.startswith("Tilted axes, in the worst direction for each number: sun axis 1 mrad out")
    rows = cells(shown[stated])
    assert rows["sp"] == ("0.598", "–", "1.41", "1.41", "edge", "0.37")
    assert rows["pr"] == ("0.598", "1", "1.41", "0", "1500", "0.37")
    assert sentences(tilt(DOCUMENT)) == ["Edge: an end of the line carries load."]


def test_what_is_not_known_says_why():
    blocks = list(
        tilt(DOCUMENT | {"unknown_because": "not known: the joint slips", "contacts": {}, "notes": []})
    )
    assert tables(blocks) == {}
    assert sentences(blocks) == [
        "Tilted axes (sun axis 1 mrad out and 0.2 mrad across): not known: the joint slips."
    ]
