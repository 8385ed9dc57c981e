"""What a report consists of: its sections are its headings, in their order."""

from asperity.report.content import Bullets, Heading, Paragraph, Report, Table


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
