"""What a view consists of: sections, figures as a table, and blocks for JSON."""

import json

from asperity.views.blocks import (
    Bullets,
    Figure,
    Heading,
    Listing,
    Paragraph,
    Picture,
    Report,
    Table,
    Warned,
    Warnings,
    block_documents,
    figures_table,
)
from asperity.views.screens import joint_screen, page_views, rolling_screen


def test_sections_are_the_headings_in_order():
    blocks = (
        Heading("Input"),
        Paragraph("a sentence"),
        Table("sizes", ("part", "mm"), [("sun", "4")]),
        Heading("Results"),
        Bullets(["one"]),
    )
    assert Report("title", blocks).sections == ("Input", "Results")
    assert Report("title", ()).sections == ()


def test_a_figure_without_a_number_has_no_unit():
    known = Figure("Life", "12", "h", "of the drive", 12.0)
    absent = Figure("Life", "–", "h", "it flows", None)
    ratio = Figure("Speed ratio", "6", "", "sun over carrier", 6.0)
    assert [figure.text for figure in (known, absent, ratio)] == ["12 h", "–", "6"]
    table = figures_table([known, absent])
    assert table.rows == [("Life", "12 h", "of the drive"), ("Life", "–", "it flows")]
    assert len(table.head) == 3


def test_blocks_for_json_have_their_kind_and_all_fields():
    warned = Warned("damage", "Damage", "it is hot", ("it melts",), "cool it")
    blocks = [Heading("a"), Warnings([warned]), Picture("b", "<svg/>", sheet=True), Listing("c")]
    found = json.loads(json.dumps(block_documents(blocks)))
    assert [block["kind"] for block in found] == ["heading", "warnings", "picture", "listing"]
    assert found[1]["items"] == [
        {
            "severity": "damage",
            "about": "Damage",
            "text": "it is hot",
            "meanings": ["it melts"],
            "remedy": "cool it",
        }
    ]
    assert found[2] == {"kind": "picture", "title": "b", "svg": "<svg/>", "sheet": True}


def with_lists(node):
    """A document as JSON has it: lists in place of tuples."""
    if isinstance(node, dict):
        return {name: with_lists(value) for name, value in node.items()}
    return [with_lists(each) for each in node] if isinstance(node, list | tuple) else node


def test_everything_that_is_shown_of_a_joint_is_json(paper_view, planetary_view, view_of):
    """Also of a sun that stands, and of contacts of which every spot is plastic."""
    plastic = view_of("planetary", ('"1.3e-7 mm"', '"1e-2 mm"'))
    for view in (paper_view, planetary_view, view_of("tutorial_joint"), plastic):
        for blocks in (joint_screen(view, "a.toml"), rolling_screen(view, "a.toml")):
            shown = block_documents(blocks)
            assert json.loads(json.dumps(shown, allow_nan=False)) == with_lists(shown)
        panels = page_views(view)
        assert json.loads(json.dumps(panels, allow_nan=False)) == with_lists(panels)
