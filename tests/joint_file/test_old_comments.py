"""Comments that new numbers have made false, by hand."""

import pytest

from asperity.joint_file.edited_text import joint_file_text
from asperity.joint_file.old_comments import comment_start, without_old_comments
from asperity.joint_file.reader import parse_case

BEFORE = """# A drive of 8 mm of wall, pressed by 30 um.
# It stands on its own.
wall = "8 mm"     # thinner than 9 mm bends too much
length = "10 mm"  # or { sp = "10 mm" }
friction = 0.08   # traction fluid
# pin = "8 mm"    # thinner pins
interference = "30 um +- 1 um"  # on the radius
"""


def test_comments_that_state_a_number_which_is_gone_go():
    after = BEFORE.replace('wall = "8 mm"', 'wall = "7.5 mm"').replace('"30 um +-', '"31 um +-')
    assert without_old_comments(after, BEFORE).splitlines() == [
        "# It stands on its own.",
        'wall = "7.5 mm"',
        'length = "10 mm"  # or { sp = "10 mm" }',
        "friction = 0.08   # traction fluid",
        '# pin = "8 mm"    # thinner pins',
        'interference = "31 um +- 1 um"  # on the radius',
    ]


def test_without_a_change_everything_stays():
    assert without_old_comments(BEFORE, BEFORE) == BEFORE


@pytest.mark.parametrize(
    ("comment", "stays"),
    [
        ("# friction of 0.08 is usual", False),
        ("# friction of 0.085 is usual", True),
        ("# a friction of 10.08 is not", True),
        ("# see table 0.08.1", True),
    ],
)
def test_a_number_is_the_whole_of_it(comment, stays):
    before = f"{comment}\nfriction = 0.08\n"
    found = without_old_comments(before.replace("= 0.08\n", "= 0.1\n"), before)
    assert (comment in found) is stays


def test_one_entry_of_several_that_changes_leaves_the_others_true():
    before = '# the ring is 12 mm wide.\n# the sun is 10 mm wide.\nlength = { sp = "10 mm", pr = "12 mm" }\n'
    after = before.replace('"10 mm"', '"11 mm"')
    assert without_old_comments(after, before).splitlines()[0] == "# the ring is 12 mm wide."
    assert "the sun" not in without_old_comments(after, before)


def test_a_sign_of_a_comment_in_quotes_is_none():
    assert comment_start('a = "x # y"  # z') == 13
    assert comment_start("a = '#'") == 7


def test_a_sentence_goes_with_all_of_its_lines():
    before = """# First.
# A wall of 8 mm, which
# bends.
# Last:
# no end

wall = "8 mm"
"""
    found = without_old_comments(before.replace('"8 mm"', '"9 mm"'), before)
    assert found.splitlines() == ["# First.", "# Last:", "# no end", "", 'wall = "9 mm"']


def test_a_written_joint_file_says_nothing_of_the_numbers_before_it(zou_file):
    text = zou_file.with_name("planetary.toml").read_text()
    case = parse_case(text.replace("# One surface", "# Pressed by 30 um.\n# One surface"), source="test")
    text = joint_file_text(case, {"load.interference": 25e-6}, comment="")
    assert "30 um" not in text
    assert 'interference = "25 um"\n' in text
    assert "# One surface for all contacts" in text
