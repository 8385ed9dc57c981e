"""Sections of a list in another arrangement: comments stay with their section."""

import tomllib

import pytest

from asperity.errors import InputError
from asperity.joint_file.listed_sections import rearranged, rearranged_text

TEXT = """# a joint

[load]
preload = "1 kN"

# hovering
[[duty]]
share = 0.4  # most of the time
# until 2025: 0.5

# moving
[[duty]]
share = 0.6

# how it is made
[surface]
gamma = 1.5
"""


def test_places_of_the_file_and_new_ones():
    assert rearranged(["a", "b"], [2, 0, 1], name="duty") == ["b", {}, "a"]
    with pytest.raises(InputError, match=r"the file has no section 3 in \[\[duty\]\]"):
        rearranged(["a", "b"], [3], name="duty")


@pytest.mark.parametrize("places", [[1], [2], [2, 1], [1, 2, 0], [0], [], [1, 0, 2]])
def test_the_text_says_the_same_as_the_tables(places):
    before = tomllib.loads(TEXT)
    found = rearranged_text(TEXT, places, name="duty")
    after = tomllib.loads(found)
    assert after.pop("duty", []) == rearranged(before.pop("duty"), places, name="duty")
    assert after == before
    for place, remarks in ((1, ("# hovering", "# most of the time", "# until 2025")), (2, ("# moving",))):
        for remark in remarks:
            assert (remark in found) == (place in places)
    assert "# a joint" in found
    assert found.index("# how it is made\n[surface]")


def test_the_same_arrangement_is_the_same_text():
    assert rearranged_text(TEXT, [1, 2], name="duty") == TEXT


def test_sections_are_added_at_the_end_of_a_file_without_them():
    text = rearranged_text('[load]\npreload = "1 kN"', [0, 0], name="branch")
    assert text == '[load]\npreload = "1 kN"\n\n[[branch]]\n\n[[branch]]\n'


def test_tables_of_a_section_move_with_it():
    text = "[[branch]]\n[branch.deviation]\nleft = 1\n\n[[branch]]\n[branch.deviation] # two\nleft = 2\n"
    found = rearranged_text(text, [2, 1], name="branch")
    assert [each["deviation"]["left"] for each in tomllib.loads(found)["branch"]] == [2, 1]
    assert "# two" in found


@pytest.mark.parametrize(
    "text",
    ["duty = [{share = 0.4}, {share = 0.6}]  # inline\n", '[[duty]]\nnote = """\n[[duty]]\n"""\n[[duty]]\n'],
)
def test_a_file_that_is_laid_out_in_another_way_has_the_same_content(text):
    sections = tomllib.loads(text)["duty"]
    assert tomllib.loads(rearranged_text(text, [2], name="duty"))["duty"] == [sections[1]]
