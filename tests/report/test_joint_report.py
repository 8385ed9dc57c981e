"""The report of a joint: its sections, required and actual values, and the file from which it can be made again."""

import hashlib
import re
from pathlib import Path

import pytest

import asperity
from asperity.api.joint import DescribedJoint
from asperity.errors import InputError
from asperity.joint_file.reader import parse_case
from asperity.page.upload import refuse_downloads
from asperity.report.joint_report import ReportSource, choices_table, inputs_table, joint_report, label_of
from asperity.report.pdf import typst_source
from asperity.show.title_block import Title
from asperity.units import format_quantity
from asperity.views.blocks import Figures, Heading, Listing, Paragraph, Picture, Table
from asperity.views.html import report_html

TEXT = (Path(__file__).parents[2] / "examples" / "zou2025.toml").read_text(encoding="utf-8")


def report_of(text, **options):
    return joint_report(ReportSource("joint.toml", text, parse_case(text, source="joint.toml"), **options))


@pytest.fixture(scope="module")
def made():
    return report_of(TEXT)


def tables(report):
    return {block.title: block for block in report.blocks if isinstance(block, Table)}


@pytest.mark.long
def test_sections_in_the_order_of_a_review(made):
    assert made.sections == (
        "Summary", "Warnings", "Safety margins", "Stiffness", "Forces and contacts", "Loads of the structure",
        "Window of the torque", "Wind-up", "The joint in rolling", "Inputs", "Assumptions", "Drawing", "Versions",
        "Joint file",
    )  # fmt: skip
    assert len([block for block in made.blocks if isinstance(block, Picture)]) == 7
    assert [block.sheet for block in made.blocks if isinstance(block, Picture)].count(True) == 1


@pytest.mark.long
def test_the_page_knows_a_report_and_says_where_its_joint_file_is(made):
    with pytest.raises(InputError, match=r"report of a joint.*in the last section"):
        refuse_downloads(report_html(made).encode(), "joint.html")
    assert made.sections[-1] == "Joint file"


@pytest.mark.slow
def test_margins_are_required_actual_and_pass(made):
    rows = {row[0]: row[1:] for row in tables(made)["Safety margins"].rows}
    # T/(mu N) = 46.3/(0.12 * 1001) at the sun; tan(beta/2)/mu with beta = 13.158 deg
    assert rows["slip ratio T/(mu N)"] == ("function", "sp", "< 1", "0.3854", "pass")
    assert rows["self-locking ratio tan(beta/2)/mu"] == ("state", "", "< 1", "0.9611", "pass")
    concerns, where, required, actual, result = rows["Hertz pressure over first yield"]
    assert (concerns, where, required, result) == ("strength", "sp", "< 1", "FAIL")
    assert float(actual) == pytest.approx(1529.0 / (1.67 * 450.0), rel=1e-3)
    assert rows["fractal dimension D"][2] == "≥ 1.02 and ≤ 1.99"
    conditions, verdict = [
        block.text for block in made.blocks if isinstance(block, Paragraph) and block.strong
    ][:2]
    assert conditions.startswith("3 planets, sun at 6000 rpm")
    assert verdict.startswith("Is damaged: Hertz pressure over first yield 2.03 at sp, at most 1;")


@pytest.mark.slow
def test_every_row_has_as_many_cells_as_the_table_has_columns(made):
    for table in tables(made).values():
        assert {len(row) for row in table.rows} == {len(table.head)}, table.title


@pytest.mark.long
def test_the_report_follows_from_the_file_that_it_contains(made):
    (listing,) = [block for block in made.blocks if isinstance(block, Listing)]
    assert listing.text == TEXT
    digest = hashlib.sha256(TEXT.encode()).hexdigest()
    assert any(isinstance(block, Paragraph) and digest in block.text for block in made.blocks)
    again = report_of(listing.text)
    assert report_html(again) == report_html(made)
    names = [f"{number}.svg" for number in range(6)]
    assert typst_source(again, pictures=names) == typst_source(made, pictures=names)


@pytest.mark.long
def test_a_joint_without_torque_has_a_report_that_says_what_is_absent():
    text = TEXT.replace('"5 N*m"', '"0 N*m"').replace('"6000 rpm"', '"0 rpm"')
    report = report_of(text, title=Title(project="Wrist", date="2026-03-01"))
    assert tables(report)["Document"].rows[:2] == [("project", "Wrist"), ("date", "2026-03-01")]
    place = report.blocks.index(Heading("Wind-up"))
    assert report.blocks[place + 1].text.startswith("No wind-up: a wind-up needs a torque that is not zero")
    assert report_html(report)


@pytest.mark.slow
def test_loads_of_the_structure_are_those_of_the_balance(made):
    rows, part = {}, ""
    for row in tables(made)["Loads of the structure"].rows:
        part = row[0] or part  # said in the first of its rows
        rows[part, row[1]] = row[2:]
    # what the pins exert on the carrier, against its rotation's sense, which is against that of the input
    assert rows["carrier, on the axis, output", "torque of all pins"] == ("N·m", "0", "-5")
    assert (
        rows["carrier pin, left loading roller", "resultant force"][1] == "127.8"
    )  # 1000 N/(2 cos theta) sin beta
    assert "Hoop stress of bodies that bend, and their safety" not in tables(made)


@pytest.mark.long
def test_a_drive_of_another_type_has_all_sections():
    file = Path(__file__).parents[2] / "examples" / "multiroller.toml"
    text = file.read_text(encoding="utf-8")
    case = parse_case(text, source=file.name)
    report = joint_report(ReportSource(file.name, text, case))
    assert report.sections == (
        "Summary", "Warnings", "Safety margins", "Stiffness", "Forces and contacts", "Loads of the structure",
        "Window of the torque", "Wind-up", "The joint in rolling", "Inputs", "Assumptions", "Drawing", "Versions",
        "Joint file",
    )  # fmt: skip
    found = tables(report)
    assert len(found["Numbers of the joint file"].rows) > 20
    assert dict(found["Drive"].rows)["members"] == "sun in, ring out, carrier grounded"
    (figures,) = [block for block in report.blocks if isinstance(block, Figures)]
    assert {figure.name: figure.shown for figure in figures.items}["Speed ratio"] == "14.98"
    assert any(
        isinstance(block, Paragraph) and "4 rollers in each row" in block.text for block in report.blocks
    )
    assert [row[0] for row in found["Contacts in rolling"].rows] == ["sf", "fsl", "fsr", "sr"]
    assert {row[-1] for row in found["Safety margins"].rows if row[1] in ("function", "damage")} == {"pass"}
    assert "slip" in report_html(report)


@pytest.mark.long
def test_unequal_branches_have_tables_of_their_own():
    file = Path(__file__).parents[2] / "examples" / "zou2025.toml"
    branches = "".join(f'\n[[branch]]\nplanet_deviation = "{size} um"\n' for size in (1.0, 0.0, -1.0))
    text = file.read_text(encoding="utf-8").replace('preload = "1000 N"', 'interference = "13 um"')
    report = report_of(text + branches)
    assert "Branches by their own sizes" in report.sections
    assert [row[1] for row in tables(report)["Branches by their own sizes"].rows] == ["1", "0", "-1"]
    assert "sector 1 is pressed" in report_html(report)
    drive = dict(tables(report)["Drive"].rows)
    assert re.fullmatch(r"\S+ N·m at sp_3 .*; others carry the rest", drive["first slip, standing"])
    assert {row[-1] for row in tables(report)["Safety margins"].rows if row[1] == "function"} == {"pass"}
    rows = tables(report)["Loads of the structure"].rows
    first = next(number for number, row in enumerate(rows) if row[0] == "sun, on the axis, input")
    force = next(row for row in rows[first:] if row[1] == "resultant force")
    assert float(force[3]) > 100.0


@pytest.mark.long
def test_a_torque_that_only_the_branches_of_the_file_carry():
    """Planets 2 um too large at 13 N·m, where equal ones of nominal size carry 12.1."""
    file = Path(__file__).parents[2] / "examples" / "planetary.toml"
    text = file.read_text(encoding="utf-8").replace('output_torque = "10 N*m"', 'output_torque = "13 N*m"')
    equal = parse_case(text.replace('interference = "30 um"', 'interference = "34 um"'), source="equal")
    text += 3 * '\n[[branch]]\nplanet_deviation = "2 um"\n'
    report = joint_report(ReportSource(file.name, text, parse_case(text, source=file.name)))
    (angle,) = [
        row[1] for row in tables(report)["Figures of the wind-up"].rows if row[0].startswith("angle at")
    ]
    pressed = asperity.windup(DescribedJoint(equal, "equal"))  # as with an interference of 34 um
    assert angle == format_quantity(pressed["windup"].si, "arcmin")
    assert "nan" not in report_html(report)


def test_numbers_have_their_units_and_tolerances(joint_text):
    text = joint_text.replace('planet_radius = "13.5 mm"', 'planet_radius = "13.5 mm +- 5 um"')
    rows = {row[0]: tuple(row[1:]) for row in inputs_table(parse_case(text, source="x")).rows}
    assert rows["drive: planet radius"] == ("13.5 mm", "± 0.005 mm")
    assert rows["load: output torque"] == ("5 N·m", "")
    assert rows["surface: fractal roughness"] == ("1e-8 mm", "")


@pytest.mark.parametrize(
    ("path", "label"),
    [
        ("materials.52100.youngs_modulus", "materials 52100: Young's modulus"),
        ("materials.steel.poisson_ratio", "materials steel: Poisson's ratio"),
        ("drive.contact_length.sp", "drive: contact length, sp"),
        ("surface.sp.roughness_average", "surface sp: roughness average"),
        ("branch.1.deviation.left", "branch 1: deviation, left"),
        ("type", "type"),
    ],
)
def test_keys_have_labels_in_words(path, label):
    assert label_of(path) == label


def test_choices_are_listed_with_their_keys(case):
    assert ("model: closure", "elastic") in [tuple(row) for row in choices_table(case).rows]


def test_shares_of_a_duty_are_numbers_of_the_file(joint_text):
    duty = "".join(
        f'[[duty]]\noutput_torque = "{torque} N*m"\nsun_speed = "100 rpm"\nshare = {share}\n\n'
        for torque, share in ((5, 0.25), (2, 0.75))
    )
    table = inputs_table(parse_case(joint_text.replace("[model]", f"{duty}[model]"), source="x"))
    rows = {row[0]: row[1] for row in table.rows}
    assert (rows["duty 1: share"], rows["duty 2: share"]) == ("0.25", "0.75")
    assert rows["duty 2: output torque"] == "2 N·m"


EXAMPLES = Path(__file__).parents[2] / "examples"
REST = ("zou2025", "planetary_hollow", "multiroller", "stepped_planet", "planar", "wheel_pair")


@pytest.mark.parametrize(
    "name",
    [
        pytest.param("planetary", marks=pytest.mark.slow),
        *(pytest.param(n, marks=pytest.mark.long) for n in REST),
    ],
)
def test_no_cell_head_or_caption_has_a_raw_key(name):
    file = EXAMPLES / f"{name}.toml"
    text = file.read_text(encoding="utf-8")
    report = joint_report(ReportSource("joint.toml", text, parse_case(text, source=file.name)))
    said = [block.text for block in report.blocks if isinstance(block, Heading)]
    for block in report.blocks:
        if isinstance(block, Table):
            said += [block.title, *block.head, *(cell for row in block.rows for cell in row)]
        if isinstance(block, Figures):
            said += [word for figure in block.items for word in (figure.name, figure.shown, figure.detail)]
        if isinstance(block, Picture):
            said.append(block.title)
    assert [text for text in said if "_" in text] == []


@pytest.mark.slow
def test_the_smallest_film_stands_in_the_summary():
    """An oil between two surfaces: the smaller of both contacts, with who carries the load."""
    text = (EXAMPLES / "planetary.toml").read_text(encoding="utf-8")
    text = text.replace(
        'viscosity = "30 mPa*s"',
        'viscosity = "30 mPa*s"\npressure_coefficient = "20 1/GPa"\nroughness = "0.2 um"',
    )
    report = report_of(text)
    (figures,) = [block for block in report.blocks if isinstance(block, Figures)]
    film = figures.items[-1]
    assert film.name == "Film ratio λ, smallest"
    rows = tables(report)["Surfaces in rolling"].rows
    ratios = {row[0]: float(row[3]) for row in rows}
    contact = min(ratios, key=ratios.get)
    assert float(film.shown) == ratios[contact]
    assert film.detail.endswith(f"lubrication, at {contact}")
