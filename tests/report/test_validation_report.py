"""The evidence as a report says the same as the document that it is made of."""

from asperity.report.validation_report import shown, validation_report
from asperity.views.blocks import Paragraph, Table
from asperity.views.html import report_html


def check(passed, **changes):
    row = {
        "model": "Hertz line contact",
        "reference": "Johnson 1985",
        "quantity": "half-width",
        "unit": "µm",
        "expected": 122.47,
        "found": 122.474487139,
        "deviation": 3.664e-5,
        "tolerance": 1e-4,
        "absolute": False,
        "values": 1,
        "note": "",
        "passed": passed,
    }
    return row | changes


def document(*checks):
    failed = sum(not row["passed"] for row in checks)
    return {
        "asperity_version": "1.2.3",
        "python": "3.12.1",
        "platform": "Linux",
        "packages": {"jax": "0.10.2"},
        "source_sha256": "ab" * 32,
        "passed": len(checks) - failed,
        "failed": failed,
        "valid": not failed,
        "checks": list(checks),
    }


def test_one_table_for_each_model_with_versions_in_front():
    report = validation_report(document(check(True), check(True, model="Creep", absolute=True, unit="mm")))
    assert report.title == "Validation of asperity 1.2.3"
    assert report.blocks[0] == Paragraph("All 2 checks passed.", strong=True, passed=True)
    words = " ".join(block.text for block in report.blocks if isinstance(block, Paragraph))
    assert all(part in words for part in ("Python 3.12.1 on Linux; jax 0.10.2.", "ab" * 32))
    tables = [block for block in report.blocks if isinstance(block, Table)]
    assert [table.title for table in tables] == ["Hertz line contact", "Creep"]
    first, second = (table.rows for table in tables)
    assert first == [
        ("half-width [µm]: Johnson 1985", "1", "122.47", "122.47449", "3.7e-05", "0.0001", "pass")
    ]
    assert second[0][4:] == ("3.7e-05 mm", "0.0001 mm", "pass")


def test_what_fails_is_said_first_and_what_was_not_found_has_its_reason():
    report = validation_report(document(check(True), check(False, found=None, note="not a number")))
    assert report.blocks[0].text == "1 of 2 checks failed."
    (table,) = (block for block in report.blocks if isinstance(block, Table))
    assert table.rows[1][0] == "half-width [µm]: Johnson 1985; not a number"
    assert (table.rows[1][3], table.rows[1][-1]) == ("–", "FAIL")


def test_the_page_of_a_report_without_sections_has_no_list_of_them():
    page = report_html(validation_report(document(check(False, note="<b>no</b>"))))
    assert "<nav" not in page
    assert "&lt;b&gt;no&lt;/b&gt;" in page
    assert '<p class="strong fail">1 of 1 checks failed.</p>' in page
    assert "<td class=fail>FAIL</td>" in page


def test_numbers_for_people():
    assert [shown(None, 6), shown(2.0, 6), shown(1.23456789, 6), shown(1e-10, 2)] == [
        "–",
        "2",
        "1.23457",
        "1e-10",
    ]
