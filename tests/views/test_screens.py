"""What commands, notebook and page show of a joint, and in which order."""

from shown_blocks import UNLIKE, tables

from asperity.views.blocks import Figures, Heading, Paragraph, Warnings
from asperity.views.screens import closing, joint_screen, page_views, rolling_screen


def test_a_screen_begins_with_name_load_verdict_and_key_figures(paper_view, planetary_view):
    for screen in (joint_screen, rolling_screen):
        name, load, verdict, figures, *_ = screen(planetary_view, "my.toml")
        assert name == Heading("my.toml: planetary drive")
        assert (load.strong, verdict.strong, verdict.passed) == (True, True, True)
        assert isinstance(figures, Figures)
    name, *_ = joint_screen(paper_view, "my.toml")
    assert name.text.startswith("my.toml")


def test_the_joint_that_stands_in_order(paper_view):
    *blocks, last = joint_screen(paper_view, "my.toml")
    assert isinstance(last, Warnings)
    assert list(tables(blocks)) == [
        "Torsional stiffness",
        "Compliance of the assembled joint, by spring",
        "Contact forces at standstill, under the torque",
        "Contact stiffness",
        "Drive",
        "Ra to which D and G correspond, on each of two like bodies, measured over five cut-offs",
    ]


def test_the_joint_that_turns_in_order(planetary_view):
    *blocks, last = rolling_screen(planetary_view, "my.toml")
    assert last == Paragraph("No warnings: all limits are met.", strong=True)
    titles = [title.partition(";")[0] for title in tables(blocks)]
    assert titles == [
        "Position of the output: drift beside stiffness",
        "Losses",
        "Contacts in rolling",
        "Surfaces in rolling",
        "Rating life L10",
    ]


def test_unlike_branches_stand_before_the_warnings(view_of, planetary_view):
    view = view_of("planetary", more=UNLIKE)
    sizes = "Branches by their own sizes"
    assert sizes in tables(closing(view))
    assert sizes not in tables(closing(planetary_view))
    assert any(block.get("title") == sizes for block in page_views(view)["contacts"])


def test_every_panel_of_the_page_has_blocks(planetary_view):
    panels = page_views(planetary_view)
    assert set(panels) == {
        "headline", "cards", "levels", "budget", "numbers", "margins", "warnings", "contacts", "heat", "assumptions",
    }  # fmt: skip
    assert panels.pop("heat") == []  # the file states the temperature
    assert all(panels.values())
    assert [block["kind"] for block in panels["cards"]] == ["figures"]
    margins = panels["margins"][-1]
    assert (margins["kind"], margins["verdicts"], len(margins["shares"])) == (
        "table",
        True,
        len(margins["rows"]),
    )
    kinds = {block["kind"] for blocks in panels.values() for block in blocks}
    assert kinds <= {"figures", "paragraph", "bullets", "table", "warnings"}
