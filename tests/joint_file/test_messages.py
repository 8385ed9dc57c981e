import re

import pytest

from asperity.errors import InputError, nearest
from asperity.joint_file.reader import parse_case


def test_the_nearest_name_is_offered_and_a_far_one_is_not():
    assert nearest("sun_radus", ["sun_radius", "planets"]) == "; did you mean 'sun_radius'?"
    assert nearest("xyz", ["sun_radius", "planets"]) == ""


@pytest.mark.parametrize(
    ("path", "section"),
    [
        ("branch.1.right_roller_deviation", '[[branch]]\nright_roller_deviation = "1 um"'),
    ],
)
def test_what_only_the_papers_drive_has_says_so(planar_case, path, section):
    with pytest.raises(InputError) as refused:
        planar_case("planetary", ("[model]", f"{section}\n\n[model]"))
    assert (
        str(refused.value) == f'mine.toml: {path}: only for the paper\'s drive (type = "wedge", or no type)'
    )


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ('[sun_bearing]\ntype = "ball"', "sun_bearing: only for the paper's drive"),
        ('[bearings]\ncarrier_torque = "1 N*mm"', "bearings.carrier_torque: only for the paper's drive"),
    ],
)
def test_what_another_drive_calls_otherwise_is_told_by_its_name(planar_case, text, told):
    with pytest.raises(InputError) as refused:
        planar_case("planetary", ("[model]", f"{text}\n\n[model]"))
    name = {"sun": "input_bearing", "bea": "output_torque"}[told[:3]]
    assert str(refused.value).startswith(f"mine.toml: {told}")
    assert str(refused.value).endswith(f"; for this drive write '{name}'")


def test_a_forgotten_type_is_one_message(planar_case):
    with pytest.raises(InputError) as refused:
        planar_case("planetary", ('type = "planetary"\n', ""))
    assert str(refused.value) == (
        "mine.toml: drive.output: the paper's drive, which a file without a type describes, has no such key; for "
        'another drive write type = "planetary" or type = "planar" in the first line'
    )


def test_what_only_other_drives_have_names_them(planar_case, example_text):
    with pytest.raises(InputError, match=r'roller: only for drives of type "planar"$'):
        parse_case(example_text + '\n[[roller]]\nname = "x"\n', source="mine.toml")
    drives = '"wedge", "planetary", "stepped_planet"'
    with pytest.raises(InputError, match=rf"bore_diameter: only for drives of type {drives}$"):
        planar_case("multiroller", ("[load]", 'planet_bore_diameter = "2 mm"\n\n[load]'))


@pytest.mark.parametrize("kind", ["planetary", "multiroller"])
def test_an_unknown_key_of_all_surfaces_names_the_known_ones(planar_case, kind):
    with pytest.raises(InputError) as refused:
        planar_case(kind, ("[surface]", "[surface]\nxx = 3\nfinnish = 'ground'"))
    first, second = str(refused.value).split("\n  ")[1:]
    assert first.startswith("surface.xx: unknown key; known here are finish, ")
    assert "fractal_dimension" in first
    assert second == "surface.finnish: unknown key; did you mean 'finish'?"


MANY = {
    "sections": lambda text: text + "".join(f"\n[a{i}]" for i in range(60_000)),
    "keys": lambda text: text.replace("[drive]", "[drive]\n" + "".join(f"k{i} = 1\n" for i in range(40_000))),
    "loads": lambda text: text + "\n[[duty]]\nx = 1" * 40_000,
    "materials": lambda text: text + "".join(f"\n[materials.m{i}]\nlibrary = 'x'" for i in range(20_000)),
    "bodies": lambda text: text.replace(
        "[bodies]", "[bodies]\n" + "".join(f"k{i} = 'x{i}'\n" for i in range(40_000))
    ),
    "bodies and materials": lambda text: (
        text.replace("[bodies]", "[bodies]\n" + "".join(f"k{i} = 'x{i}'\n" for i in range(15_000)))
        + "".join(f"\n[materials.m{i}]" for i in range(15_000))
    ),
}


@pytest.mark.parametrize(
    "what", ["keys", *(pytest.param(what, marks=pytest.mark.slow) for what in MANY if what != "keys")]
)
def test_of_a_great_many_errors_the_first_are_told(what, example_text):
    text = MANY[what](example_text)
    with pytest.raises(InputError) as caught:
        parse_case(text, source="x.toml")
    first, *lines, last = str(caught.value).split("\n  ")
    count = int(re.fullmatch(r"x\.toml: (\d+) errors", first).group(1))
    assert count >= 20_000
    assert len(lines) == 20
    assert last == f"and {count - 20} more"
    assert len(str(caught.value)) < 15_000


def test_a_key_as_long_as_the_file_is_shortened(example_text):
    with pytest.raises(InputError, match=r"drive\.kkk.*…") as caught:
        parse_case(example_text.replace("[drive]", "[drive]\n" + "k" * 900_000 + " = 1"), source="x")
    assert len(str(caught.value)) < 1100
