"""Lists of sections that a request adds to, shortens, or fits to the number of branches."""

import tomllib

import pytest

from asperity.errors import InputError
from asperity.joint_file.case_types import CASES, DefaultCase
from asperity.page.joint_request import JointRequest
from asperity.page.list_changes import (
    ONE_PER_BRANCH,
    lists_of,
    places_of_lists,
    rearranged,
    rearranged_text,
    stated_lists,
    without_lists,
)

LOADS = """
# hovering
[[duty]]
output_torque = "2 N*m"
sun_speed = "1500 rpm"
share = "40 %"

# moving
[[duty]]
output_torque = "-1 N*m"
sun_speed = "3000 rpm"
share = 0.6
"""
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


@pytest.fixture
def planetary_text(zou_file):
    return zou_file.with_name("planetary.toml").read_text(encoding="utf-8")


def test_the_lists_are_those_that_a_file_may_leave_out():
    assert lists_of(DefaultCase) == {"duty": None, "branch": "drive.planets", "form": None}
    assert lists_of(CASES["planar"]) == {"duty": None, "branch": "drive.sectors", "form": None}
    assert lists_of(CASES["multiroller"])["branch"] == "drive.rollers_per_row"


def test_a_load_is_added_and_one_left_out(planetary_text):
    new = {"output_torque": "3 N*m", "sun_speed": "100 rpm", "share": 0.4}
    changes = {"duty": "2 0", **{f"duty.2.{key}": value for key, value in new.items()}}
    request = JointRequest("a.toml", planetary_text + LOADS, changes)
    case = request.case()
    assert [load.output_torque.value for load in case.duty] == [-1.0, 3.0]
    text = request.file_text()
    assert "# moving" in text
    assert "# hovering" not in text
    assert JointRequest("a.toml", text).case() == case


def test_all_loads_leave(planetary_text):
    request = JointRequest("a.toml", planetary_text + LOADS, {"duty": ""})
    assert request.case().duty is None
    assert "[[duty]]" not in request.file_text()


def test_shares_that_do_not_add_up_have_the_message_of_the_file(planetary_text):
    with pytest.raises(InputError, match=r"shares of \[\[duty\]\] must add up to 1, they add up to 0.6"):
        JointRequest("a.toml", planetary_text + LOADS, {"duty": "2"}).case()


def test_branches_are_as_many_as_planets(planetary_text):
    changes = {
        "branch": ONE_PER_BRANCH,
        "branch.3.planet_deviation": "2 um",
        "branch.4.planet_deviation": "1 um",
    }
    three = JointRequest("a.toml", planetary_text, changes)
    assert [each.planet_deviation and each.planet_deviation.text for each in three.case().branch] == [
        None, None, "2 um",
    ]  # fmt: skip
    four = JointRequest("a.toml", planetary_text, {**changes, "drive.planets": "4"})
    assert four.case().branch[3].planet_deviation.text == "1 um"
    assert JointRequest("a.toml", four.file_text()).case() == four.case()
    fewer = JointRequest("a.toml", four.file_text(), {"branch": ONE_PER_BRANCH, "drive.planets": 3})
    assert fewer.case() == three.case()
    equal = JointRequest("a.toml", four.file_text(), {"branch": ""})
    assert equal.case().branch is None


def waves_of(entry):
    """Number of waves → amplitude [m] of a section of form errors."""
    return {int(waves): size.value for waves, size in entry.harmonics.items()}


def waves(expected):
    return pytest.approx(expected, rel=1e-12, abs=0.0)


def test_form_errors_of_a_part_are_added(planetary_text):
    changes = {
        "form": "0 0",
        "form.1.runout": "3 um",
        "form.1.harmonics.2": "1 um",
        "form.1.part": "ring",
        "form.2.part": "planet",
        "form.2.harmonics.12": "0.1 um",
        "form.2.phase": "10 deg",
    }
    request = JointRequest("a.toml", planetary_text, changes)
    ring, planet = request.case().form
    assert (ring.part, ring.runout.value, waves_of(ring)) == (
        "ring",
        pytest.approx(3e-6, abs=0.0),
        waves({2: 1e-6}),
    )
    assert (planet.part, planet.runout, waves_of(planet)) == ("planet", None, waves({12: 1e-7}))
    text = request.file_text()
    assert JointRequest("a.toml", text).case() == request.case()
    assert 'part = "ring"\nharmonics = {2 = "1 um"}' in text.replace('runout = "3 um"\n', "")
    lists = stated_lists(request.case(), tomllib.loads(text))["form"]
    assert lists["words"] == {"part": ["sun", "planet", "ring"]}
    assert lists["keys"] == ["runout", "harmonics.2", "harmonics.3", "harmonics.12", "phase"]
    assert lists["of_file"][0] == {"part": "ring", "runout": "3 um", "harmonics.2": "1 um"}


def test_form_errors_change_their_part_and_leave(zou_file):
    text = zou_file.with_name("accuracy.toml").read_text(encoding="utf-8")
    changes = {"form": "4 2", "form.1.part": "sun", "form.1.runout": "", "form.2.harmonics.2": ""}
    request = JointRequest("a.toml", text, changes)
    sun, planet = request.case().form
    assert (sun.part, waves_of(sun)) == ("sun", waves({2: 1e-6, 3: 5e-7, 6: 2e-7}))
    assert (planet.part, waves_of(planet)) == ("planet", waves({3: 2e-7}))
    assert JointRequest("a.toml", request.file_text()).case() == request.case()
    assert JointRequest("a.toml", text, {"form": ""}).case().form is None
    for wrong, said in (
        ({"form.1.part": ""}, r"form\.1\.part: this key is missing"),
        ({"form.9.part": "sun"}, "do not fit the sections"),
    ):
        with pytest.raises(InputError, match=said):
            JointRequest("a.toml", text, wrong).case()


@pytest.mark.parametrize(
    ("drive", "parts"),
    [
        (
            "zou2025",
            ["sun", "planet", "right_loading_roller", "loading_roller", "left_loading_roller", "ring"],
        ),
        ("planar", ["sun", "planet", "right", "left", "ring"]),
        ("wheel_pair", ["driver", "driven"]),
    ],
)
def test_parts_that_may_have_form_errors_have_one_name_each(zou_file, drive, parts):
    request = JointRequest("a.toml", zou_file.with_name(f"{drive}.toml").read_text(encoding="utf-8"))
    assert stated_lists(request.case(), request.file_tables)["form"]["words"] == {"part": parts}


def test_another_number_of_planets_alone_is_refused_as_the_file_refuses_it(planetary_text):
    text = JointRequest("a.toml", planetary_text, {"branch": ONE_PER_BRANCH}).file_text()
    with pytest.raises(InputError, match=r"has 4 planets, but there are 3 sections \[\[branch\]\]"):
        JointRequest("a.toml", text, {"drive.planets": 4}).case()
    with pytest.raises(InputError, match=r"drive\.planets"):
        JointRequest("a.toml", text, {"branch": ONE_PER_BRANCH, "drive.planets": "many"}).case()


def test_branches_of_a_listed_drive_name_their_rollers(zou_file):
    text = zou_file.with_name("planar.toml").read_text(encoding="utf-8")
    preload = {"load.interference": "10 um"}  # which branches need
    request = JointRequest(
        "a.toml", text, {**preload, "branch": ONE_PER_BRANCH, "branch.1.deviation.left": "1 um"}
    )
    case = request.case()
    lists = stated_lists(case, request.file_tables)
    assert lists["branch"]["keys"] == ["deviation.planet", "deviation.right", "deviation.left"]
    assert lists["branch"]["of_file"] == []
    assert lists["branch"]["most"] == 100
    assert JointRequest("a.toml", request.file_text()).case() == case
    gone = JointRequest("a.toml", request.file_text(), {"branch.1.deviation.left": ""})
    assert not gone.case().branch[0].deviation


def test_what_the_file_says_of_each_section(planetary_text):
    request = JointRequest("a.toml", planetary_text + LOADS, {"duty": "2 1"})
    found = stated_lists(request.case(), request.file_tables)["duty"]
    assert found["keys"] == ["output_torque", "sun_speed", "share"]
    assert [each["share"] for each in found["of_file"]] == ["40 %", "0.6"]
    assert found["meaning"].startswith("Loads and their shares of the time")
    assert found["most"] == 50


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"duty": "1,2"}, "wanted as their places"),
        ({"duty": ONE_PER_BRANCH}, "wanted as their places"),
        ({"duty": "1 2 3"}, "the file has no section 3"),
        ({"duty": "1 2" + 60 * " 0"}, "at most 50 loads|share"),
        ({"duty.3.share": 0.1}, "do not fit the sections"),
        ({"branch.1.planet_deviation": "1 um"}, "do not fit the sections"),
    ],
)
def test_arrangements_that_are_refused(planetary_text, changes, said):
    with pytest.raises(InputError, match=said):
        JointRequest("a.toml", planetary_text + LOADS, changes).case()


def test_a_section_that_is_no_list_is_said(planetary_text):
    with pytest.raises(InputError, match=r"expected sections \[\[duty\]\]"):
        JointRequest("a.toml", f"duty = 3\n{planetary_text}", {"duty": ""}).case()


def test_only_changes_beyond_the_branches_wait():
    changes = {
        "branch": ONE_PER_BRANCH,
        "branch.2.a": 1,
        "branch.3.a": 1,
        "load.preload": 1,
        "duty.9.share": 1,
    }
    places = {"branch": [1, 2]}
    assert set(without_lists(changes, places)) == {"branch.2.a", "load.preload", "duty.9.share"}
    assert places_of_lists({"drive": {"planets": 2}}, changes, DefaultCase) == {"branch": [0, 0]}


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
