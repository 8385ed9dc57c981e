"""The joint that stands, as it is shown: its load, figures, contacts, sizes and assumptions."""

import math

import pytest
from shown_blocks import ARCMINUTE, amount, cells, four, tables, with_document

from asperity.views.blocks import Bullets, Heading
from asperity.views.joint import (
    OF_EVERY_JOINT,
    assumed,
    assumptions,
    capacity_text,
    contacts,
    drive,
    in_its_direction,
    key_figures,
    load,
    surfaces,
    verdict,
    verdict_words,
)
from asperity.views.screens import opening
from asperity.views.solved_view import SolvedView

FRICTION = 0.12  # of the paper's example
MODULUS = 206e9 / (2.0 * (1.0 - 0.3**2))  # E* of two bodies of its steel [Pa]
LENGTH = 5e-3  # of its contacts [m]
#: Of a surface and of its average over cut-offs [SI].
RA = {
    "fractal_dimension": 1.6,
    "fractal_roughness_m": 2e-10,
    "cut_off_m": 0.8e-3,
    "roughness_average_m": 0.2e-6,
    "roughness_average_low_m": 0.15e-6,
    "roughness_average_high_m": 0.25e-6,
}
#: Of its contacts: 1/R = 1/R_1 + 1/R_2, within the ring 1/R_1 - 1/R_2 [m].
RADIUS = {
    "sp": 1e-3 / (1.0 / 4.0 + 1.0 / 13.5),
    **dict.fromkeys(("pwr", "pwl"), 1e-3 / (1.0 / 13.5 + 1.0 / 5.0)),
    **dict.fromkeys(("wro", "wlo"), 1e-3 / (1.0 / 5.0 - 1.0 / 40.0)),
}
PIN_BEARING = '\n[pin_bearing]\ntype = "roller"\ndynamic_rating = "8 kN"\nstatic_rating = "9 kN"\ncount = 1\n'
BEARING_STEEL = 7833e-9  # density of 52100 [kg/mm^3], of the planetary example
#: Its axial creepage makes the sun's contact slide without a torque.
SKEWED = ("[lubrication]", '[rolling]\nskew = { sp = "20 mrad", pr = "-20 mrad" }\n\n[lubrication]')
CROWNED = ('contact_length = "5 mm" ', 'planet_crown_radius = "2 m"\ncontact_length = "5 mm" ')


def figures(view):
    return {figure.name: figure for figure in key_figures(view)}


def test_the_load_is_in_the_units_of_the_file(paper_view, planetary_view):
    assert load(paper_view).text.startswith("3 planets, sun at 6000 rpm, preload 1000 N (interference ")
    micrometres = 1e6 * float(paper_view.solved.result.interference)
    assert f"(interference {micrometres:.4g} µm), output torque 5 N·m" in load(paper_view).text
    assert "(interference 30 µm), output torque 10 N·m" in load(planetary_view).text


def test_sectors_are_counted_by_the_words_of_their_type(paper_view, view_of):
    assert load(paper_view).text.startswith("3 planets, sun at")
    assert load(view_of("multiroller")).text.startswith("4 rollers in each row, sun at")
    assert load(view_of("wheel_pair")).text.startswith("driver at")


def test_a_joint_at_another_temperature(view_of):
    """All parts are of one steel: the interference grows as the bore does."""
    sections = '\n[temperature]\nassembly = "20 degC"\nworking = "60 degC"\n'
    view = view_of("planetary", more=sections)
    said = load(view).text
    assert "; at 60 degC, assembled at 20 degC with " in said
    assert said.endswith("(30 µm)")
    assert float(said.partition("with ")[2].split()[0]) == four(
        view.document["preload"]["at_assembly"]["force_N"]
    )


def test_where_a_joint_gets_loose(paper_view):
    limits = [
        {"lost": "seat_between_rollers", "part": "held_ring", "temperature_degC": 70.0, "side": "above"},
        {"lost": "interference", "part": None, "temperature_degC": -90.0, "side": "below"},
    ]
    preload = paper_view.document["preload"] | {"temperature_limits": limits}
    assert load(with_document(paper_view, preload=preload)).text.endswith(
        "; loose below -90 degC; no pressure of held ring on its housing between the rollers above 70 degC"
    )


def test_of_a_side_the_first_limit_is_told_behind_the_working_temperature(paper_view):
    """On the way up the ring leaves its housing between the rollers before its fit is lost."""
    limits = [
        {"lost": "seat_between_rollers", "part": "ring", "temperature_degC": 70.0, "side": "above"},
        {"lost": "seat", "part": "ring", "temperature_degC": 95.0, "side": "above"},
    ]
    assembled = {
        "temperature_degC": 20.0,
        "working_temperature_degC": 60.0,
        "force_N": 900.0,
        "interference_m": 12e-6,
    }
    preload = paper_view.document["preload"] | {"temperature_limits": limits, "at_assembly": assembled}
    assert load(with_document(paper_view, preload=preload)).text.endswith(
        "; at 60 degC, assembled at 20 degC with 900 N (12 µm); no pressure of ring on its housing between the "
        "rollers above 70 degC"
    )
    preload |= {"temperature_limits": limits[1:], "at_assembly": None}
    assert load(with_document(paper_view, preload=preload)).text.endswith(
        "; no fit of ring in its housing above 95 degC"
    )


def test_a_loading_cam_is_told(view_of):
    cam = 'output_torque = "10 N*m"\ncam_force_per_torque = "20 N/Nm"'
    said = load(view_of("planetary", ('output_torque = "10 N*m"', cam))).text
    assert "; loading cam: " in said
    assert " plus 20 N/Nm, angle " in said
    assert said.endswith("arcmin at the output")


def test_key_figures_are_those_of_the_solution(planetary_view):
    shown, result = figures(planetary_view), planetary_view.solved.result
    stiffness = float(result.assembly.stiffness.output)
    expected = {
        "Stiffness at the output": (stiffness * ARCMINUTE, "N·m/arcmin"),
        "Drift per output turn": (float(result.rolling.drift_per_output_turn) / ARCMINUTE, "arcmin"),
        "Efficiency": (100.0 * float(result.rolling.power.efficiency), "%"),
        "Life": (float(result.rolling.life_hours.drive), "h"),
        "Outside diameter": (2.0 * (50.0 + 8.0), "mm"),
        "Speed ratio": (6.0, ""),
    }
    for name, (value, unit) in expected.items():
        assert (amount(shown[name].text), shown[name].unit) == (pytest.approx(value, rel=1e-3), unit), name
    in_si = {
        "Stiffness at the output": stiffness,
        "Drift per output turn": float(result.rolling.drift_per_output_turn),
        "Efficiency": float(result.rolling.power.efficiency),
        "Life": 3600.0 * float(result.rolling.life_hours.drive),
        "Outside diameter": 2.0 * (0.050 + 0.008),
    }
    assert {name: shown[name].si for name in in_si} == pytest.approx(in_si, rel=1e-12)
    assert f"{stiffness:.0f} N·m/rad" in shown["Stiffness at the output"].detail
    assert "assembled (upper bound: pins rigid)" in shown["Stiffness at the output"].detail
    # sun of 10 mm, three planets of 20 mm and a ring of 50 to 58 mm, each 10 mm long
    area = math.pi * (10.0**2 + 3.0 * 20.0**2 + 58.0**2 - 50.0**2)
    assert amount(shown["Mass"].text) == four(BEARING_STEEL * area * 10.0)
    assert shown["Speed ratio"].detail == "sun over carrier, ring grounded"


def test_figures_that_do_not_exist_say_why(paper_view, view_of):
    life = figures(paper_view)["Life"]
    assert (life.text, life.si) == ("–", None)
    assert life.detail.startswith("no rating life: at sp, pwr the Hertz pressure exceeds the shakedown limit")
    efficiency = figures(view_of("tutorial_joint"))["Efficiency"]
    assert efficiency.text == "–"
    assert efficiency.detail.startswith("the sun stands: drift and life are per turn")
    plastic = figures(view_of("planetary", ('"1.3e-7 mm"', '"1e-2 mm"')))
    for name in ("Stiffness at the output", "Drift per output turn"):
        assert plastic[name].text == "–"
        assert "every spot of" in plastic[name].detail


def test_the_capacity_stands_beside_what_limits_it(paper_view, planetary_view):
    rolling, standing = (
        float(getattr(planetary_view.solved.solution, name).output_torque)
        for name in ("rolling_capacity", "standing_capacity")
    )
    shown = figures(planetary_view)["Torque capacity"]
    assert amount(shown.text) == four(rolling)
    assert shown.detail == f"contact sp slips, in rolling; gross slip at {standing:.4g} N·m standing"
    nothing = figures(paper_view)["Torque capacity"]
    assert (nothing.text, nothing.si) == ("0 N·m", 0.0)
    assert nothing.detail.startswith("contact sp beyond first yield without torque; gross slip at 13.16 N·m")


@pytest.mark.parametrize(
    ("torque", "limit", "stands", "shown", "detail"),
    [
        (8.0, "gross_slip", 8.0, "8 N·m", "sp slips"),
        (7.0, "lift_off", 9.0, "7 N·m", "sp slips; lift-off at 9 N·m standing"),
        (7.0, "none", None, "7 N·m", "sp slips; standing, no contact slips at any torque"),
        (7.0, "contact_too_wide", 900.0, "7 N·m", "sp slips"),
        (None, "none", None, "–", "sp slips; standing, no contact slips at any torque"),
    ],
)
def test_a_capacity_against_the_torque(paper_view, torque, limit, stands, shown, detail):
    """Under -5 N·m the reverse capacities count."""
    document = paper_view.document
    standing = document["standing"]
    view = with_document(
        paper_view,
        torque_capacity={"reverse": {"output_torque_Nm": torque, "meaning": "sp slips"}},
        standing_torque_capacity={"reverse": {"output_torque_Nm": stands, "limit": limit}},
        standing=standing | {"forces": standing["forces"] | {"output_torque_Nm": -5.0}},
    )
    found = figures(view)["Torque capacity"]
    assert (found.text, found.detail) == (shown, detail)
    both = view.document["torque_capacity"]
    assert in_its_direction(view.document, both) is both["reverse"]
    assert in_its_direction(document, both) is both  # under 5 N·m


def test_the_verdict_is_one_paragraph_before_the_figures(paper_view, planetary_view):
    for view, passed in ((paper_view, False), (planetary_view, True)):
        paragraph = verdict(view.document)
        assert (paragraph.strong, paragraph.passed) == (True, passed)
        assert paragraph.text == verdict_words(view.document["verdict"])
        *_, before, shown = opening(view, "my.toml")
        assert before == paragraph
        assert [figure.name for figure in shown.items] == list(figures(view))
        assert len(shown.items) == 8
    unknown = paper_view.document["verdict"] | {"works": True, "holds": None}
    assert verdict({"verdict": unknown}).passed is None
    nearest = {"words": "slip at sp 3, 85 % of its limit"}
    said = {"title": "Works", "words": "All met.", "nearest": nearest}
    assert verdict_words(said) == "Works: All met. Tightest margin: slip at sp 3, 85 % of its limit."
    assert verdict_words(said | {"nearest": None}) == "Works: All met."


def test_contacts_are_in_the_units_of_their_heads(paper_view):
    """Traction by statics; width 2 b and pressure by Hertz: b² = 4 N R/(pi E* L), p = 2 N/(pi b L)."""
    standing = paper_view.document["standing"]
    shown = tables(contacts(paper_view))
    forces = shown["Contact forces at standstill, under the torque"]
    assert [head.partition("\n")[2] for head in forces.head] == ["", "N", "N", "mm", "MPa", "mm²", "-"]
    stiffness = shown["Contact stiffness"]
    assert [head.partition("\n")[2] for head in stiffness.head] == ["", *["N/µm"] * 4, "N·m/rad"]
    assert list(cells(forces)) == list(cells(stiffness)) == list(standing["contacts"])
    numbers = {name: [float(cell) for cell in row] for name, row in cells(forces).items()}
    # 5 N·m at a ratio of 9 on three planets around a sun of 4 mm; the planet passes it on to both loading rollers
    traction = 5.0 / 9.0 / (3.0 * 4e-3)
    assert numbers["sp"][1] == four(traction)
    assert numbers["pwr"][1] + numbers["pwl"][1] == four(traction)
    assert (numbers["wro"][1], numbers["wlo"][1]) == (numbers["pwr"][1], numbers["pwl"][1])
    for name, (normal, tangential, width, pressure, area, slip) in numbers.items():
        half_width = math.sqrt(4.0 * normal * RADIUS[name] / (math.pi * MODULUS * LENGTH))
        assert width == pytest.approx(2e3 * half_width, rel=1e-3)
        assert pressure == pytest.approx(1e-6 * 2.0 * normal / (math.pi * half_width * LENGTH), rel=1e-3)
        assert slip == pytest.approx(tangential / (FRICTION * normal), rel=1e-3)
        assert normal == four(standing["forces"]["normal_N"][name])
        assert area == four(1e6 * standing["contacts"][name]["real_contact_area_m2"])
    for name, row in cells(stiffness).items():
        contact = standing["contacts"][name]
        springs = [
            1e-6 * contact[f"{of}_{direction}_stiffness_N_per_m"]
            for of in ("asperity", "bulk")
            for direction in ("tangential", "normal")
        ]
        assert [float(cell) for cell in row] == [
            *map(four, springs),
            four(contact["contact_torsional_stiffness_Nm_per_rad"]),
        ]


def test_crowned_contacts_have_a_table_of_their_own(paper_view, view_of):
    assert "Crowned contacts" not in tables(contacts(paper_view))
    view = view_of("zou2025", CROWNED)
    shown = tables(contacts(view))["Crowned contacts"]
    assert [head.partition("\n")[2] for head in shown.head] == ["", "%", "-", "-"]
    found = view.document["standing"]["contacts"]
    for name in ("sp", "pwr", "pwl"):  # the planet touches them
        contact = found[name]
        assert [float(cell) for cell in cells(shown)[name]] == [
            four(100.0 * contact["loaded_length_share"]),
            four(contact["peak_line_load_ratio"]),
            four(contact["end_line_load_ratio"]),
        ]


def test_the_drive_in_degrees_grams_and_millimetres(paper_view):
    """Cosine rule in the triangle of 17.5, 18.5 and 35 mm; planets three to a circle of 17.5 mm."""
    shown = {name: cell for name, (cell,) in cells(drive(paper_view)).items()}
    assert shown["members"] == "sun in, carrier out, ring grounded"
    assert amount(shown["speed of the output"]) == four(-6000.0 / 9.0)
    wedge = math.degrees(math.acos((35.0**2 + 18.5**2 - 17.5**2) / (2.0 * 35.0 * 18.5)))
    alpha = math.degrees(math.acos((35.0**2 + 17.5**2 - 18.5**2) / (2.0 * 35.0 * 17.5)))
    assert amount(shown["wedge angle beta"]) == four(wedge)
    assert amount(shown["angle alpha between planet and loading roller"]) == four(alpha)
    assert amount(shown["direction theta from planet to loading roller"]) == four(wedge + alpha)
    assert shown["torque at the output"] == "5 N·m"
    assert amount(shown["torque at the input, without losses in rolling"]) == four(5.0 / 9.0)
    for body, radius in (("sun", 4.0), ("planet", 13.5), ("right loading roller", 5.0)):
        assert amount(shown[f"mass, {body}"]) == four(7850.0 * math.pi * radius**2 * 5.0 * 1e-6)
    gap = 2.0 * 17.5 * math.sin(math.pi / 3.0) - 2.0 * 13.5
    assert shown["smallest clearance"] == f"{gap:.4g} mm, planet to planet"
    # push angles of 0°: no radial force; tangentially both pins of three planets make the torque, at 35 mm
    pins = [shown[f"force on the pin, {side} loading roller"].split() for side in ("left", "right")]
    assert [pin[:4] + pin[5:] for pin in pins] == 2 * [["radial", "0", "N,", "tangential", "N,", "standing"]]
    assert sum(float(pin[4]) for pin in pins) * 3.0 * 35e-3 == pytest.approx(-5.0, rel=1e-3)
    # the drive and its mirror image slip at the sun alike
    capacity = float(paper_view.solved.solution.rolling_capacity.output_torque)
    turning = shown["torque capacity, rolling"]
    assert amount(turning) == four(capacity)
    assert turning.endswith(" N·m: contact sp slips (both directions)")
    assert amount(shown["interference to be made"]) == four(
        1e6 * float(paper_view.solved.result.interference)
    )
    without = SolvedView(paper_view.solved, paper_view.document)
    assert "interference to be made" not in cells(drive(without))


def test_a_pin_is_pressed_in_both_directions_and_a_gap_may_be_unknown(paper_view):
    forces = paper_view.document["standing"]["forces"] | {
        "pin_N": {"left_loading_roller": {"radial": -12.5, "tangential": 40.0}}
    }
    gaps = [{"name": "sun_to_ring", "gap_m": None}, {"name": "planet_to_planet", "gap_m": 2e-3}]
    changes = {
        "standing": paper_view.document["standing"] | {"forces": forces},
        "geometry": paper_view.document["geometry"] | {"clearances": gaps},
    }
    shown = cells(drive(with_document(paper_view, **changes)))
    assert shown["force on the pin, left loading roller"] == ("radial -12.5 N, tangential 40 N, standing",)
    assert shown["smallest clearance"] == ("2 mm, planet to planet",)
    changes["geometry"] = changes["geometry"] | {"clearances": gaps[:1]}
    assert "smallest clearance" not in cells(drive(with_document(paper_view, **changes)))


def test_a_spring_that_presses_wheels_travels(view_of):
    """1000 N on 50 N/mm."""
    assert "preload 1000 N (spring travel 20 mm)" in load(view_of("wheel_pair")).text


def test_losses_are_part_of_the_torque_at_the_input_in_rolling(planetary_view):
    """An oil whose drag the motor has to overcome: the power in over the speed."""
    shown = {name: cell for name, (cell,) in cells(drive(planetary_view)).items()}
    power = planetary_view.document["rolling"]["input_power_W"]
    torque = power / (1500.0 * math.pi / 30.0)
    assert amount(shown["torque at the input in rolling, all losses counted"]) == four(torque)
    assert "wedge angle beta" not in shown


def test_bearings_and_bodies_that_bend_have_a_row_each(paper_view, planetary_view, view_of):
    assert not any(name.startswith(("bearing", "rim")) for name, _ in drive(paper_view).rows)
    (said,) = cells(drive(view_of("planetary", more=PIN_BEARING)))["bearing life L10, planet pin"]
    # F = 10 N·m/(3·30 mm); 10^6 (C/F)^(10/3) turns at 250 rpm·50/20, less the creep
    hours = 1e6 * (8000.0 * 0.09 / 10.0) ** (10.0 / 3.0) / (60.0 * 625.0)
    assert (amount(said), said.split()[1]) == (pytest.approx(hours, rel=2e-3), "h")
    standing = view_of("planetary", ("1500 rpm", "0 rpm"), more=PIN_BEARING)
    assert cells(drive(standing))["bearing life L10, planet pin"] == ("–",)  # no hours
    ring = planetary_view.document["rims"]["ring"]
    (said,) = cells(drive(planetary_view))["rim of the ring"]
    assert said == f"yield safety {ring['yield_safety']:.4g}, fatigue safety {ring['fatigue_safety']:.4g}"
    unknown = with_document(planetary_view, rims={"ring": ring | {"fatigue_safety": None}})
    (said,) = cells(drive(unknown))["rim of the ring"]
    assert said == f"yield safety {ring['yield_safety']:.4g}"


def test_capacities_of_both_directions(paper_view):
    def entry(torque, meaning):
        return {"output_torque_Nm": torque, "meaning": meaning}

    slips, none = entry(12.5, "contact sp slips"), entry(None, "no limit is reached at any torque")
    assert capacity_text(slips | {"reverse": none}) == (
        "12.5 N·m: contact sp slips; reverse no limit is reached at any torque"
    )
    assert capacity_text(slips | {"reverse": slips}) == "12.5 N·m: contact sp slips (both directions)"
    assert capacity_text(none | {"reverse": none}) == "no limit is reached at any torque (both directions)"
    assert capacity_text(paper_view.document["torque_capacity"]) == (
        "0 N·m: contact sp beyond first yield without torque (both directions)"
    )


def test_capacities_in_rolling_are_worded_as_all_others(paper_view, view_of):
    """Skew of 20 mrad takes all friction: at the sun it is many times mu b/R = 0.001, the creepage of gross slip."""
    lowest = "contact sp becomes too wide for line-contact theory; the joint may carry more"
    one = {"output_torque_Nm": 12.5, "meaning": lowest}
    other = {"output_torque_Nm": None, "meaning": "no limit is reached at any torque"}
    for both, said in (
        (one | {"reverse": other}, f"12.5 N·m: {lowest}; reverse {other['meaning']}"),
        (other | {"reverse": other}, f"{other['meaning']} (both directions)"),
    ):
        changed = paper_view.document["rolling"] | {"torque_capacity": both}
        shown = cells(drive(with_document(paper_view, rolling=changed)))
        assert shown["torque capacity, rolling"] == (said,)
    skewed = view_of("planetary", SKEWED)
    (said,) = cells(drive(skewed))["torque capacity, rolling"]
    assert said == "0 N·m: contact sp slips (both directions)"


def test_what_is_assumed_in_short_and_in_full(planetary_view):
    """In short what a file leaves out has its name only, and what is so in every joint is left out."""
    told = planetary_view.document["assumptions"]
    assert all(any(sentence.startswith(start) for sentence in told) for start in OF_EVERY_JOINT)
    heading, every = assumptions(planetary_view.document)
    assert (heading, list(every.items)) == (Heading("Assumptions"), list(told))
    assert assumed(planetary_view.document) == every
    heading, short = assumptions(planetary_view.document, brief="in full with --all")
    assert heading == Heading("Assumptions (in full with --all)")
    assert isinstance(short, Bullets)
    names, law, oil, fatigue = short.items
    assert names.startswith(
        "not in the file: section [bearings], bearings.pin_diameter, compliance.pin_stiffness, section [play], "
    )
    assert "the bearings have no friction" not in names
    assert law.startswith("contact law zou_2025, since the file does not state model.contact_law: ")
    assert oil == "friction as stated: no traction data of the oil"
    assert fatigue.startswith("fatigue_strength of material 52100: 588 MPa of specimens")
    told = ["no section [play]: the output has no play", *OF_EVERY_JOINT, "crowns: of every roller, in full"]
    short = assumed({"assumptions": told}, in_full=False)
    assert list(short.items) == ["not in the file: section [play]", "crowns: of every roller, in full"]


def test_the_ra_of_every_surface(paper_view, view_of):
    """G is 1e-8 mm; Ra and its range are those of the document."""
    (shown,) = surfaces(paper_view.document)
    (row,) = shown.rows
    entry = paper_view.document["surfaces"][0]
    assert row[:4] == ("all", "1.4", "1e-8", "0.25")
    assert float(row[4]) == four(1e6 * entry["roughness_average_m"])
    low, high = row[5].split(" to ")
    assert float(low) < float(row[4]) < float(high)
    (shown,) = surfaces(paper_view.document | {"surfaces": [entry | RA | {"contacts": ["sp", "pwr"]}]})
    assert shown.rows == [("sp, pwr", "1.6", "2e-7", "0.8", "0.2", "0.15 to 0.25")]
    assert shown.head[2:] == ("G\nmm", "cut-off\nmm", "Ra\nµm", "95 % measured\nµm")
    of_two = {"surfaces": [RA | {"contacts": ["sp", "pr"]}], "standing": {"contacts": {"sp": {}, "pr": {}}}}
    assert surfaces(of_two)[0].rows == [("all", *shown.rows[0][1:])]
    assert surfaces(paper_view.document | {"surfaces": []}) == []  # by their heights
