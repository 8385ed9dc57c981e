"""Drawings of drives: every roller at its place, sizes as in the file."""

import functools
import io
import math
from itertools import pairwise
from types import SimpleNamespace

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from asperity.drive.layout.existence import refuse_impossible
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.stated_parts import stated_parts
from asperity.show.box import Box, text_box
from asperity.show.drive_sheet import drive_sheet
from asperity.show.drive_sizes import drive_clearances, sizes
from asperity.show.sheet import Circle, Line, Text
from asperity.show.sheet_dxf import dxf_text, sheet_dxf
from asperity.show.sheet_figure import sheet_figure
from asperity.show.taken import distance
from asperity.show.title_block import Title

EXAMPLES = ("planetary", "planetary_hollow", "multiroller", "stepped_planet", "zou2025", "wheel_pair")
LONG = "the_right_hand_loading_roller_of_hardened_steel"
#: Drives that leave little room, or none: changes of the examples.
ODD = {
    "tiny sun": ("planetary", {'sun_radius = "10 mm"': 'sun_radius = "3.2 mm"'}),
    "large sun": (
        "planetary",
        {'sun_radius = "10 mm"': 'sun_radius = "60 mm"', 'planet_radius = "20 mm"': 'planet_radius = "4 mm"',
         '"8 mm"': '"1.5 mm"', "planets = 3": "planets = 8"},
    ),
    "many planets": (
        "planetary",
        {"planets = 3": "planets = 30", 'sun_radius = "10 mm"': 'sun_radius = "200 mm"'},
    ),
    "thin walls": (
        "planetary_hollow",
        {'ring_wall_thickness = "30 mm"': 'ring_wall_thickness = "0.5 mm"', '"26 mm"': '"39 mm"'},
    ),
    "view that fills its room": (
        "planetary",
        {'sun_radius = "10 mm"': 'sun_radius = "15 mm"', 'planet_radius = "20 mm"': 'planet_radius = "25 mm"',
         '"8 mm"': '"9.9 mm"'},
    ),
    "tracks of nearly one size": ("stepped_planet", {'"18 mm"': '"19.8 mm"'}),
    "twelve stepped rollers": (
        "multiroller",
        {"rollers_per_row = 4": "rollers_per_row = 6", 'sun_radius = "10 mm"': 'sun_radius = "20 mm"'},
    ),
    "first roller at the side": (
        "planar",
        {"90 deg": "10 deg", "103.9 deg": "23.9 deg", "76.1 deg": "-3.9 deg", "sectors = 3": "sectors = 2"},
    ),
    "long names": ("planar", {'"right"': f'"{LONG}"', 'right = "5': f'{LONG} = "5', '"pwr"': f'"contact_of_{LONG}"'}),
}  # fmt: skip


@pytest.fixture(scope="module")
def sheet(planar_case):
    @functools.cache
    def draw(name, forces=False):
        example, replaced = ODD.get(name, (name, {}))
        case = planar_case(example, replaced=replaced)
        joint = joint_from_case(case)
        refuse_impossible(joint.drive)
        if forces == "section":
            return drive_sheet(
                joint, name=name, stated=stated_parts(case, joint), title=Title(project="Wrist")
            )
        count, pins = len(joint.drive.contacts), len(joint.drive.pinned)
        made_up = SimpleNamespace(
            normal=np.full(count, 1234.5),
            tangential=np.full(count, 123.45),
            pins=np.full(pins, 123.45),
            input_torque=1.5,
            output_torque=7.5,
        )
        return drive_sheet(joint, name=name, result=SimpleNamespace(forces=made_up) if forces else None)

    return draw


def letters_of(text, scale):
    """The box of a text without its margin and without what is below its base line."""
    box, margin = text_box(text, scale), 0.8 / scale
    return Box(box.left + margin, box.right - margin, text.at[1], box.high - margin)


def sizes_of(name, planar_case):
    example, replaced = ODD.get(name, (name, {}))
    joint = joint_from_case(planar_case(example, replaced=replaced))
    return sizes(joint, 1.0), drive_clearances(joint)


@pytest.mark.parametrize(
    "forces", [*(pytest.param(forces, marks=pytest.mark.long) for forces in (False, True)), "section"]
)
@pytest.mark.parametrize("name", [*(pytest.param(name, marks=pytest.mark.slow) for name in EXAMPLES), *ODD])
def test_every_text_is_inside_the_frame_and_covers_no_other(sheet, name, forces):
    figure = sheet_figure(sheet(name, forces))
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    texts = [text for text in figure.axes[0].texts if text.get_text()]
    boxes = [text.get_window_extent(canvas.get_renderer()) for text in texts]
    margin = 10.0 / 25.4 * figure.dpi
    for index, (text, box) in enumerate(zip(texts, boxes, strict=True)):
        assert margin < box.x0 < box.x1 < figure.bbox.width - margin, text
        assert margin < box.y0 < box.y1 < figure.bbox.height - margin, text
        assert not [
            other.get_text()
            for other, area in zip(texts[index + 1 :], boxes[index + 1 :], strict=True)
            if box.overlaps(area)
        ], text


@pytest.mark.parametrize("forces", [False, True, "section"])
@pytest.mark.parametrize("name", [*EXAMPLES, *ODD])
def test_no_leader_runs_through_a_text_or_an_arrow_of_a_force(sheet, name, forces):
    drawn = sheet(name, forces)
    lines = [item for item in drawn.items if isinstance(item, Line)]
    leaders = [line for line in lines if line.style == "thin" and (line.arrows or len(line.points) == 3)]
    arrows = [line.points for line in lines if line.style == "force"]
    boxes = [
        (item.text, letters_of(item, drawn.scale))
        for item in drawn.items
        if isinstance(item, Text) and item.text.strip()
    ]
    assert leaders
    for leader in leaders:
        for part in pairwise(leader.points):
            assert not [text for text, box in boxes if box.is_crossed_by(*part)]
            assert all(distance(part, arrow) > 0.0 for arrow in arrows)


@pytest.mark.parametrize("forces", [False, True, "section"])
@pytest.mark.parametrize("name", [*EXAMPLES, *ODD])
def test_every_size_is_said_once(sheet, planar_case, name, forces):
    """In the view, or in the list; the list may break a line."""
    texts = sheet(name, forces).texts
    together = "".join("".join(texts).split())
    wanted, clearances = sizes_of(name, planar_case)
    for size in wanted:
        listed = "".join(f"{size.of}:".split())
        if size.label not in texts:
            assert listed in together
            assert "".join(size.listed.split()) in together[together.index(listed) :], size
    for gap in clearances:
        assert "".join(f"{gap.words} {gap.size:.4g}".split()) in together


def test_words_of_the_list(sheet):
    """Neighbouring planets: 2 * 30 mm * sin(60 deg) less 40 mm."""
    texts = sheet("planetary").texts
    assert {"sun ⌀20", "3 × planet ⌀40", "axes of planet ⌀60", "ring inside ⌀99.94", "wall of ring 8"} <= set(
        texts
    )
    gap = f"{60.0 * math.sin(math.pi / 3.0) - 40.0:.4g}"
    assert {f"A {gap}", f"A  planet to planet {gap}"} <= set(texts)
    assert "sun in, carrier out, ring grounded" in texts
    assert "pins of the carrier: planet" in texts
    assert {"Contacts, length 10", "sp: sun – planet"} <= set(texts)
    assert "tracks of stepped rollers lie in different planes" not in joined(texts)


TOLERANCED = {
    'sun_radius = "10 mm"': 'sun_radius = "10 mm +- 2 um"',
    'planet_radius = "20 mm"': 'planet_radius = "20 mm +- 3 um"\nplanet_crown_radius = "4 m"',
    'contact_length = "10 mm"': 'contact_length = "10 mm +- 50 um"',
    'interference = "30 um"': 'interference = "30 um +- 2 um"',
    'fractal_roughness = "1.3e-7 mm"': 'roughness_average = "0.2 um"\npartner_roughness_average = "0.1 um"',
}


def test_a_sheet_states_tolerances_materials_crowns_and_surfaces(planar_case):
    """Widths of 4 t on the diameter: 8, 12 and 8 µm; IT4 of 20 mm is 6, IT5 of 40 mm 11, IT3 of 99.94 mm 6 µm."""
    case = planar_case("planetary", replaced=TOLERANCED)
    joint = joint_from_case(case)
    drawn = drive_sheet(
        joint, name="a.toml", stated=stated_parts(case, joint), title=Title(revision="B"), section=True
    )
    assert {
        "sun ⌀20.0000 ±0.0040 (IT4)",
        "3 × planet ⌀40.0000 ±0.0060 (IT5)",
        "ring inside ⌀99.9400 ±0.0040 (IT3)",
        "axes of planet ⌀60",
        "sp, pr: 10.000 ±0.050",
        "A–A developed",
        "B",
    } <= set(drawn.texts)
    said = joined(drawn.texts)
    assert "3 × planet: 52100, hardness 746 HV, of steel 62 HRC" in said
    assert "crown of track sp, pr: radius 4000 along the axis" in said
    assert "surface of all contacts: Ra 0.2 µm, its partner Ra 0.1 µm" in said


def test_words_of_a_drive_with_wedges(planar_case):
    """Angles by the law of cosines in the triangle of 17.5, 18.5 and 35 mm; a planet ends 9 mm inside the ring."""
    stated = {"contact_length =": 'planet_length = "20 mm"\ncontact_length ='}
    joint = joint_from_case(planar_case("zou2025", replaced=stated))
    texts = joined(drive_sheet(joint, name="a").texts)
    assert "Wedge traction drive" in texts
    assert "angle alpha, planet to loading roller, 13.925°; wedge angle beta 13.158°" in texts
    assert "length of planet 20" in texts
    assert "planet to ring 9" in texts
    assert "A planet to planet 3.311" in texts


def test_contacts_of_unlike_lengths_have_their_own(planar_case):
    case = planar_case(
        "planetary", replaced={'contact_length = "10 mm"': 'contact_length = { sp = "9 mm", pr = "12 mm" }'}
    )
    texts = drive_sheet(joint_from_case(case), name="a").texts
    assert {"Contacts", "sp: sun – planet, length 9"} <= set(texts)
    assert "pr: planet – ring, length 12, interference 30 µm" in joined(texts)


def joined(texts):
    """The lines of the list as they are before they are broken."""
    return " ".join(" ".join(texts).split())


WARM = '[temperature]\nassembly = "20 degC"\nworking = "60 degC"\n\n[model]'


@pytest.mark.parametrize(
    ("name", "replaced", "interference", "words"),
    [
        ("planetary", {}, None, "pr: planet – ring, interference 30 µm on the radius, in the ⌀ of the ring"),
        (
            "planetary", {"[model]": WARM}, None,
            "pr: planet – ring, interference 30 µm on the radius at 20 °C, in the ⌀ of the ring",
        ),
        (
            "stepped_planet", {}, None, "driven ring, interference 30 µm on the radius, in the ⌀ of the driven ring",
        ),
        (
            "planetary", {'interference = "30 um"': 'preload = "1000 N"'}, 28.31e-6,
            "pr: planet – ring, interference 28.31 µm on the radius, in the ⌀ of the ring",
        ),
        (
            "planetary", {'interference = "30 um"': 'preload = "1000 N"'}, None,
            "pr: planet – ring, interference by a preload of 1000 N",
        ),
        ("planar", {}, 13e-6, "ring, interference 13 µm on the radius, in the ⌀ of the ring"),
    ],
)  # fmt: skip
def test_the_list_says_the_interference(planar_case, name, replaced, interference, words):
    joint = joint_from_case(planar_case(name, replaced=replaced))
    texts = joined(drive_sheet(joint, name="a", interference=interference).texts)
    assert words in texts
    assert "sp: sun – planet, interference" not in texts


def test_leaders_end_on_the_outlines_that_they_measure(sheet):
    """Each arrow lies on a circle of the radius that its text says, around the right centre."""
    drawn = sheet("planetary_hollow")
    orbit = [
        (30.0 * math.cos(turn), 30.0 * math.sin(turn))
        for turn in np.pi * np.array([0.5, 7.0 / 6.0, 11.0 / 6.0])
    ]
    found = {item.text: before for before, item in pairwise(drawn.items) if isinstance(item, Text)}
    for text, radius, centres in (
        ("sun ⌀20", 10.0, [(0.0, 0.0)]),
        ("3 × planet ⌀40", 20.0, orbit),
        ("3 × planet, bore ⌀26", 13.0, orbit),
        ("axes of planet ⌀60", 30.0, [(0.0, 0.0)]),
    ):
        tip = found[text].points[0]
        assert found[text].arrows == "start"
        assert min(abs(math.dist(tip, centre) - radius) for centre in centres) < 1e-9, text
    across = found["ring inside ⌀99.94"]
    assert [point[0] for point in across.points] == pytest.approx([-50.0, 50.0])
    assert across.arrows == "both"
    gap = found["A 11.96"].points[0]  # halfway between two planets: 15 mm from the axis
    assert math.hypot(*gap) == pytest.approx(15.0)


def test_a_size_without_room_stays_in_the_list(sheet):
    texts = sheet("planetary_hollow").texts
    assert "ring: wall 30, broken off at the wavy line" in texts
    assert not any(text.startswith("wall of") for text in texts)


def test_a_thick_wall_is_broken_off_and_bores_are_drawn(sheet):
    """30 mm around an inner radius of 50 mm: drawn up to 60 mm; planets with a bore of 26 mm."""
    drawn = sheet("planetary_hollow")
    assert sorted({round(circle.radius, 6) for circle in outlines(drawn)}) == [10.0, 13.0, 20.0, 50.0]
    (wavy,) = [item for item in drawn.items if isinstance(item, Line) and len(item.points) > 9]
    radii = np.hypot(*np.array(wavy.points).T)
    assert radii.mean() == pytest.approx(60.0, rel=1e-3)


def test_axes_go_through_the_centres(sheet):
    drawn = sheet("planetary")
    (orbit,) = [item for item in drawn.items if isinstance(item, Circle) and item.style == "axis"]
    assert orbit.radius == pytest.approx(30.0)
    lines = [item.points for item in drawn.items if isinstance(item, Line) and item.style == "axis"]
    crosses = [points for points in lines if max(map(math.hypot, *zip(*points, strict=True))) < 100.0]
    middles = [np.mean(points, axis=0) for points in crosses]
    assert sorted(round(float(np.hypot(*middle)), 6) for middle in middles) == [0.0] * 2 + [30.0] * 6
    for points, middle in zip(crosses, middles, strict=True):
        if np.hypot(*middle) > 1.0:  # one along the radius, one across it
            along = np.subtract(*points) / math.dist(*points)
            assert abs(abs(float(along @ middle)) / 30.0 - 0.5) == pytest.approx(0.5, abs=1e-9)
            assert 20.0 < 0.5 * math.dist(*points) <= 25.0


def outlines(drawn):
    return [item for item in drawn.items if isinstance(item, Circle) and item.style == "outline"]


def test_the_planetary_has_three_planets_that_touch_sun_and_ring(sheet):
    drawn = sheet("planetary")
    planets = [circle for circle in outlines(drawn) if circle.radius == pytest.approx(20.0)]
    assert len(planets) == 3
    for planet in planets:
        assert math.hypot(*planet.centre) == pytest.approx(30.0)
    assert {round(c.radius, 6) for c in outlines(drawn)} == {10.0, 20.0, 50.0, 58.0}
    assert "ratio 6" in drawn.texts
    assert "Planetary traction drive" in drawn.texts
    assert {"sp", "pr"} <= set(drawn.texts)


def test_the_multiroller_has_two_tracks_on_eight_rollers(sheet):
    drawn = sheet("multiroller")
    radii = [round(circle.radius, 6) for circle in outlines(drawn)]
    assert [radii.count(radius) for radius in (16.0, 18.0, 9.4)] == [4, 4, 4]
    assert radii.count(10.0) == 5  # the sun, and the small tracks of the first row
    assert "tracks of stepped rollers lie in different planes" in joined(drawn.texts)


def test_a_dxf_file_has_the_texts_and_the_true_lengths_of_the_sheet(sheet):
    ezdxf = pytest.importorskip("ezdxf", reason="the extra 'report' is not installed")
    drawn = sheet("planetary")
    document = ezdxf.read(io.StringIO(sheet_dxf(drawn)))
    assert not document.audit().has_errors
    assert {text.dxf.text for text in document.query("TEXT")} == {dxf_text(text) for text in drawn.texts}
    measured = {each.dxf.text: each.get_measurement() for each in document.modelspace().query("DIMENSION")}
    gap = 60.0 * math.sin(math.pi / 3.0) - 40.0
    sizes_of_file = {
        "sun %%c20": 20.0,
        "3 × planet %%c40": 40.0,
        "axes of planet %%c60": 60.0,
        "wall of ring 8": 8.0,
    }
    assert measured == pytest.approx(sizes_of_file | {"ring inside %%c99.94": 100.0, "A 11.96": gap})
    shown = {text.dxf.text for text in document.modelspace().query("TEXT")}
    assert not shown & set(measured)  # each stands in the block of its dimension, once


@pytest.mark.long
def test_a_long_list_has_letters_of_normal_height_on_the_sheet(idlers_case):
    drawn = drive_sheet(joint_from_case(idlers_case(12)), name="a")
    _, _, low, high = drawn.window
    rows = [item for item in drawn.items if isinstance(item, Text) and "–" in item.text[:-1]]
    assert len(rows) > 24
    assert all(low < item.at[1] < high - 10.0 / drawn.scale for item in rows)
    assert {item.height for item in rows} == {2.5}
    for one, other in pairwise(rows):
        assert (
            not text_box(one, drawn.scale)
            ._replace(low=one.at[1])
            .meets(text_box(other, drawn.scale)._replace(high=other.at[1] + other.height / drawn.scale))
        )
