"""The page is self-contained, shows every check, and escapes what it is given."""

from html.parser import HTMLParser

from asperity.validation.check import compared, failed
from asperity.validation.page import shown, validation_page
from asperity.validation.run import validation_document


class Page(HTMLParser):
    def __init__(self):
        super().__init__()
        self.tags, self.text = [], []

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))

    def handle_data(self, data):
        self.text.append(data)


def parsed(checks):
    page = Page()
    page.feed(validation_page(validation_document(checks)))
    return page


GOOD = compared(
    model="Hertz",
    reference="Johnson",
    quantity="width",
    unit="µm",
    expected=2.0,
    found=2.5,
    tolerance=1.0,
    absolute=True,
)


def test_every_check_is_a_row():
    page = parsed([GOOD, failed("Springs", ValueError("<b>no</b>"))])
    assert sum(tag == "tr" for tag, _ in page.tags) == 4
    assert "pass" in page.text
    assert "FAIL" in page.text
    assert "1 of 2 checks failed." in page.text
    assert "0.5 µm" in page.text
    assert "ValueError: <b>no</b>" in page.text
    assert "b" not in {tag for tag, _ in page.tags}


def test_nothing_is_loaded_and_nothing_runs():
    page = parsed([GOOD])
    assert not {"script", "link", "img", "iframe"} & {tag for tag, _ in page.tags}
    assert not any("src" in attributes or "href" in attributes for _, attributes in page.tags)
    assert "All 1 checks passed." in page.text


def test_numbers_for_people():
    assert [shown(None), shown(2.0), shown(1.23456789), shown(1e-10, 2)] == ["–", "2", "1.23457", "1e-10"]
