"""Stiffness on every level with what bounds it, laws, intervals, and where the compliance comes from."""

import pytest
from shown_blocks import ARCMINUTE, cells, four, sentences, tables, with_document

from asperity.units import format_quantity
from asperity.views.stiffness import LEVEL_WORDS, budget, law_range_words, stiffness

LEVELS = "Torsional stiffness"
LAWS = "Contact laws side by side"
BUDGET = "Compliance of the assembled joint, by spring"
AVERAGE = (
    'fractal_dimension = 1.4\nfractal_roughness = "1e-8 mm"\nfrequency_ratio = 1.5',
    'finish = "ground"\nroughness_average = "0.2 um"',
)
CAM = ('output_torque = "10 N*m"', 'output_torque = "10 N*m"\ncam_force_per_torque = "20 N/Nm"')
AS_SPRINGS = (
    ('bodies = "exact"', 'bodies = "springs"'),
    ('ring_support = "free"', 'ring_support = "rigid_housing"'),
)


@pytest.fixture(scope="module")
def drawn(view_of):
    """The paper's joint with a surface that is known by its Ra: an interval, and several laws."""
    return view_of("zou2025", AVERAGE)


def test_levels_by_their_units_and_the_fullest_first(paper_view):
    """At the sun by the square of the ratio of 9; an arcminute is pi/10800."""
    result = paper_view.solved.result
    shown = tables(stiffness(paper_view))[LEVELS]
    assert [head.partition("\n")[2] for head in shown.head] == ["", "N·m/arcmin", "N·m/rad", "N·m/rad"]
    assert shown.head[-1].startswith("sun\n")
    outputs = [
        float(each.output) for each in (result.assembly.stiffness, result.series_with_bulk, result.published)
    ]
    for row, output, (_, said) in zip(shown.rows, outputs, LEVEL_WORDS, strict=True):
        assert row[0].startswith(said)
        assert [float(cell) for cell in row[1:]] == [
            four(output * ARCMINUTE),
            four(output),
            four(output / 81.0),
        ]


def test_a_bound_stands_beside_the_assembled_level_alone(paper_view):
    heads = [row[0] for row in tables(stiffness(paper_view))[LEVELS].rows]
    assert [head.endswith(" (upper bound: pins rigid)") for head in heads] == [True, False, False]


def test_the_table_names_the_member_that_drives(planetary_view):
    geometry = planetary_view.document["geometry"] | {"input": "driving_ring"}
    shown = tables(stiffness(with_document(planetary_view, geometry=geometry)))[LEVELS]
    assert shown.head[-1] == "driving ring\nN·m/rad"


def test_a_held_cam_has_its_own_stiffness(view_of):
    """Without the spring of the cam: the assembly's compliance less its share."""
    view = view_of("planetary", CAM)
    assembly = view.solved.result.assembly
    held = float(assembly.stiffness.output) / (1.0 - float(assembly.loading_cam_share))
    *_, row = tables(stiffness(view))[LEVELS].rows
    assert row[0] == "assembled, loading cam held by its friction (upper bound: pins rigid)"
    assert [float(cell) for cell in row[1:]] == [four(held * ARCMINUTE), four(held), four(held / 36.0)]


def test_why_there_is_no_stiffness(view_of):
    view = view_of("planetary", ('"1.3e-7 mm"', '"1e-2 mm"'))
    blocks = list(stiffness(view))
    assert {cell for row in tables(blocks)[LEVELS].rows for cell in row[1:]} == {"–"}
    assert any(said.startswith("No value: every spot of sp") for said in sentences(blocks))
    (said,) = sentences(budget(view.document))
    assert said.startswith(f"{BUDGET}: none, every spot of sp")


def test_the_drift_stands_below_every_stiffness(paper_view, view_of):
    rolling = paper_view.solved.result.rolling
    drift, loss = float(rolling.drift_per_output_turn) / ARCMINUTE, 100.0 * float(rolling.speed_loss)
    (said,) = (text for text in sentences(stiffness(paper_view)) if "drifts" in text)
    assert f"drifts by {drift:.4g} arcmin in each of its turns under this torque ({loss:.4g} %" in said
    nothing = view_of("planetary", ('"1.3e-7 mm"', '"1e-2 mm"'))
    assert any(text.startswith("Drift: ") for text in sentences(stiffness(nothing)))


def limit(name, value, contact, **more):
    entry = {
        "name": name,
        "label": name,
        "contact": contact,
        "value": value,
        "shown": f"{value}",
        "ok": False,
        "known": True,
        "severity": "model",
        "remedy": "choose another law",
    }
    return entry | more


def test_the_range_of_the_law_is_a_sentence_with_the_largest_values():
    found = [limit("area", 8.0, "sp"), limit("area", 3.0, "pwr"), limit("spot", 40.0, "sp")]
    assert law_range_words({"diagnostics": found}) == (
        "asperities alone: outside the range of this law, area up to 8.0, spot up to 40.0; choose another law"
    )
    infinite = limit("spot", None, "pwr", infinite=True)
    assert "spot infinite" in law_range_words({"diagnostics": [*found, infinite]})
    # what is not known is not outside the range
    unknown = [limit(name, None, "pr", infinite=False, known=False) for name in ("area", "heat")]
    assert law_range_words({"diagnostics": unknown}) == ""
    assert law_range_words({"diagnostics": [*found, *unknown]}) == law_range_words({"diagnostics": found})
    kept = [entry | {"ok": True} for entry in found]
    damage = limit("yield", 2.0, "sp", severity="damage")
    assert law_range_words({"diagnostics": [*kept, damage]}) == ""


def test_the_range_of_the_law_stands_beside_the_levels(paper_view):
    (said,) = (text for text in sentences(stiffness(paper_view)) if text.startswith("Asperities alone"))
    crossed = [
        entry["label"]
        for entry in paper_view.document["diagnostics"]
        if entry["severity"] == "model" and not entry["ok"]
    ]
    assert crossed
    assert all(label in said for label in crossed)


def test_laws_side_by_side_have_a_row_each(paper_view, view_of):
    """A file with a law in use and another one that its surfaces allow."""
    assert LAWS not in tables(stiffness(paper_view))
    entry = {"law": "zou_2025", "used": False, "over_boundary_elements": [0.045, 0.5]}
    numbers = {"assembly_Nm_per_rad": 7000.0, "drift_rad_per_output_turn": 2.0 * ARCMINUTE}
    laws = [
        entry | dict.fromkeys(numbers),
        entry | numbers | {"law": "exponential", "used": True, "over_boundary_elements": [0.39, 1.24]},
    ]
    shown = tables(stiffness(with_document(paper_view, contact_laws=laws)))[LAWS]
    assert shown.rows == [
        ("zou_2025", "–", "–", "0.045 to 0.5", ""),
        ("exponential", "7000", "2", "0.39 to 1.24", "used here"),
    ]


def test_the_law_of_the_file_has_the_stiffness_of_the_joint(drawn):
    laws = cells(tables(stiffness(drawn))[LAWS])
    assert len(laws) > 1
    (used,) = (row for row in laws.values() if row[-1] == "used here")
    result = drawn.solved.result
    assert float(used[0]) == four(float(result.assembly.stiffness.output))
    assert float(used[1]) == four(float(result.rolling.drift_per_output_turn) / ARCMINUTE)


def test_the_interval_over_what_ra_leaves_open(paper_view, drawn):
    assert not any("Interval" in title for title in tables(stiffness(paper_view)))
    interval = drawn.document["stiffness_interval"]
    blocks = list(stiffness(drawn))
    rows = tables(blocks)[interval["title"]].rows
    for (level, said), row in zip(LEVEL_WORDS, rows, strict=True):
        assert row[0].startswith(said)
        assert [float(cell) for cell in row[1:]] == [
            four(interval[level][f"{end}_Nm_per_rad"]) for end in ("low", "high")
        ]
    low, high = (
        format_quantity(interval["drift"][f"{end}_rad_per_output_turn"], "arcmin") for end in ("low", "high")
    )
    assert f"Drift from {low} to {high} per output turn." in sentences(blocks)
    assert interval["words"] in sentences(blocks)
    # the joint itself lies within
    low, high = (interval["assembly"][f"{end}_Nm_per_rad"] for end in ("low", "high"))
    assert low < float(drawn.solved.result.assembly.stiffness.output) < high


def test_the_parts_of_an_interval_in_newtons_per_micrometre(paper_view):
    bounds = {"low_Nm_per_rad": 7000.0, "high_Nm_per_rad": None}
    levels = {level: bounds for level, _ in LEVEL_WORDS}
    ends = {"both": [1.5e8, 6.25e8], "contact_law": [2e8, 5.5e8], "rms_height": [2.5e8, 3.5e9]}
    directions = ("asperity_normal_stiffness_N_per_m", "asperity_tangential_stiffness_N_per_m")
    interval = levels | {
        "drift": {"low_rad_per_output_turn": 10.0 * ARCMINUTE, "high_rad_per_output_turn": None},
        "title": "Interval",
        "words": "D from 1.15 to 1.5.",
        "contacts": {"sp": dict.fromkeys(directions, ends)},
    }
    blocks = list(stiffness(with_document(paper_view, stiffness_interval=interval)))
    assert [row[1:] for row in tables(blocks)["Interval"].rows] == [("7000", "–")] * 3
    assert "Drift from 10 arcmin to – per output turn." in sentences(blocks)
    assert tables(blocks)["Asperities of the contacts in this interval"].rows == [
        ("sp", "150 to 625", "200 to 550", "250 to 3500", "150 to 625")
    ]


def test_what_an_unstated_clearance_leaves_open(view_of):
    view = view_of("planetary_hollow", ("[model]", '[bearings]\npin_diameter = "26 mm"\n\n[model]'))
    words = view.document["pin_clearance_interval"]["words"]
    assert f"{words[0].upper()}{words[1:]}." in sentences(stiffness(view))


def test_shares_of_the_compliance_are_sorted_and_make_the_whole(paper_view):
    shown = tables(budget(paper_view.document))[BUDGET]
    found = paper_view.document["stiffness_budget"]
    normal, tangential = (found[f"{kind}_share"] for kind in ("normal", "tangential"))
    assert [(row[0], float(row[1])) for row in shown.rows] == [
        ("contacts, normal (rollers free to move)", four(100.0 * sum(normal.values()))),
        ("contacts, tangential", four(100.0 * sum(tangential.values()))),
    ]
    assert sum(shown.shares) == pytest.approx(1.0)
    first = max(normal, key=normal.get)
    assert shown.rows[0][2].startswith(f"{first} {100.0 * normal[first]:.3g}, ")


def test_whole_bodies_are_named_where_they_are_elastic(planetary_view, view_of):
    (said,) = sentences(budget(planetary_view.document))
    assert said.endswith("such as the bending of a free ring.")
    assert sentences(budget(view_of("planetary", *AS_SPRINGS).document)) == []


def test_a_share_below_nothing_is_shown_and_explained(paper_view):
    """It was left out, although the others then made more than the whole."""
    shares = {"normal_share": {"sp": 1.25, "left_pair": -0.125}, "pin_share": -0.125, "bodies_share": 0.0}
    document = paper_view.document | {"stiffness_budget": shares, "input": {"model": {"bodies": "springs"}}}
    blocks = list(budget(document))
    assert tables(blocks)[BUDGET].rows == [
        ("contacts, normal (rollers free to move)", "112.5", "sp 125, left pair -12.5"),
        ("carrier pins", "-12.5", ""),
    ]
    (said,) = sentences(blocks)
    assert said.startswith("A negative share: the other forces on its bodies deflect this spring")
    whole = {"normal_share": {"sp": 0.75}, "pin_share": 0.25}
    assert sentences(budget(document | {"stiffness_budget": whole})) == []


def test_a_joint_without_torque_has_no_budget(paper_view):
    nothing = {"bodies_share": None, "normal_share": {"sp": None}}
    document = paper_view.document | {"stiffness_budget": nothing, "stiffness_unknown_because": None}
    assert sentences(budget(document)) == [f"{BUDGET}: none, the joint transmits no torque."]
