"""Joint files written back."""

import pytest
import tomlkit
from bronze import BRONZE

from asperity.joint_file import edited_text
from asperity.joint_file.edited_text import entered_key_at, entered_values, joint_file_text, set_texts
from asperity.joint_file.reader import parse_case, read_case
from asperity.joint_file.si_tables import numeric_keys, si_values


def test_unchanged_file_says_the_same(zou_file):
    case = read_case(zou_file)
    again = parse_case(joint_file_text(case, {}, comment="two\nlines"), source="test")
    assert si_values(again) == si_values(case)


def test_a_comment_with_the_name_of_any_file_is_one(zou_file):
    """TOML allows no control characters in a comment, and UTF-8 no lone surrogates."""
    case = read_case(zou_file)
    text = joint_file_text(
        case, {"load.preload": 900.0}, comment="Calibrated: we\x07lle\udcfc\r[x]\n  b.toml."
    )
    assert text.startswith("# Calibrated: we\\x07lle\\udcfc\n# [x]\n#   b.toml.\n")
    again = parse_case(text.encode().decode(), source="test")
    assert numeric_keys(again)["load.preload"].value == 900.0


def test_every_digit_survives(zou_file):
    case = read_case(zou_file)
    changes = {
        "load.preload": 1234.5678901234567,
        "surface.fractal_roughness": 3.3333333333333333e-12,
        "surface.fractal_dimension": 1.7182818284590452,
        "drive.contact_length.sp": 0.0123456789012345678,
        "materials.steel.youngs_modulus": 2.0612345678901234e11,
    }
    again = numeric_keys(parse_case(joint_file_text(case, changes, comment=""), source="test"))
    for path, value in changes.items():
        assert again[path].value == pytest.approx(value, rel=3e-16, abs=0.0)
    assert again["drive.contact_length.wlo"].value == 0.005


def test_the_shortest_decimal_is_written(zou_file):
    """Conversions to the unit and back make no digits up."""
    case = read_case(zou_file)
    changes = {"drive.contact_length": 6e-3, "drive.planet_radius": 10.4898e-3, "load.output_torque": 5.1}
    text = joint_file_text(case, changes, comment="")
    for line in ('contact_length = "6 mm"', 'planet_radius = "10.4898 mm"', 'output_torque = "5.1 N*m"'):
        assert line in text


def test_tolerances_stay(zou_file):
    text = zou_file.read_text().replace('planet_radius = "13.5 mm"', 'planet_radius = "13.5 mm +- 5 um"')
    case = parse_case(text, source="test")
    again = numeric_keys(
        parse_case(joint_file_text(case, {"drive.planet_radius": 0.0134}, comment=""), source="test")
    )
    assert again["drive.planet_radius"].value == pytest.approx(0.0134, rel=1e-15)
    assert again["drive.planet_radius"].tolerance == pytest.approx(5e-6, rel=1e-15)


def test_a_verdict_of_an_earlier_design_goes_with_its_numbers(zou_file):
    """What a design said of its joint does not hold for other numbers, nor stand below another verdict."""
    said = "# Designed by asperity from a.toml: smallest mass.\n# All limits are met.\n"
    designed = parse_case(said + said + zou_file.read_text(), source="test")
    assert joint_file_text(designed, {}, comment="") == designed.text
    for again in (
        joint_file_text(designed, {"load.preload": 900.0}, comment=""),
        joint_file_text(designed, {}, comment="new"),
    ):
        assert "All limits" not in again
        assert "The joint of S. Zou" in again


def test_comments_order_and_layout_stay(zou_file):
    text = zou_file.read_text()
    case = parse_case(text, source="test")
    assert joint_file_text(case, {}, comment="") == text
    again = joint_file_text(case, {"load.preload": 1234.5, "drive.planets": 4.0}, comment="one\n\ntwo")
    assert again.startswith("# one\n#\n# two\n")
    before, after = text.splitlines(), again.splitlines()[3:]
    gone = next(k for k, line in enumerate(before) if "a preload of 1000 N" in line)
    del before[gone : gone + 2]  # the sentence with the preload that the file no longer has
    changed = [(old, new) for old, new in zip(before, after, strict=True) if old != new]
    assert len(changed) == 2
    for old, new in changed:
        assert new.split("=")[0] == old.split("=")[0]
        assert new.partition("#")[2] == old.partition("#")[2]
    assert [new.partition("#")[0].split("=")[1].strip() for _, new in changed] == ["4", '"1234.5 N"']


def test_the_line_for_editors_stays_first(zou_file):
    text = "#:schema ./joint.schema.json\n" + zou_file.read_text()
    again = joint_file_text(parse_case(text, source="test"), {}, comment="new")
    assert again.startswith("#:schema ./joint.schema.json\n# new\n")


def test_distributions_stay(zou_file):
    text = zou_file.read_text().replace('"13.5 mm"', '"13.5 mm +- 5 um, normal 2 sigma"')
    case = parse_case(text, source="test")
    again = joint_file_text(case, {"drive.planet_radius": 0.0134}, comment="")
    assert 'planet_radius = "13.4 mm +- 0.005 mm, normal 2 sigma"' in again


def content(text, folder=None):
    return {
        path: key.value for path, key in numeric_keys(parse_case(text, source="again", folder=folder)).items()
    }


def test_entries_for_all_contacts_are_split_and_others_set_for_all(zou_file):
    case = read_case(zou_file)
    changes = {
        "surface.sp.fractal_dimension": 1.6,
        "drive.contact_length.wlo": 0.007,
        "load.friction_coefficient.pwr": 0.2,
    }
    again = joint_file_text(case, changes, comment="")
    found = content(again)
    for path, value in changes.items():
        assert found[path] == pytest.approx(value, rel=1e-15)
    assert found["surface.wro.fractal_dimension"] == 1.4
    assert found["drive.contact_length.sp"] == 0.005
    assert "# " in again
    twice = joint_file_text(parse_case(again, source="x"), {"surface.fractal_dimension": 1.3}, comment="")
    assert {
        content(twice)[f"surface.{name}.fractal_dimension"] for name in ("sp", "pwr", "pwl", "wro", "wlo")
    } == {1.3}


def test_sections_and_keys_that_the_file_leaves_out(zou_file):
    case = read_case(zou_file)
    changes = {"bearings.pin_diameter": 0.004, "compliance.pin_stiffness": 2e8, "drive.planet_length": 0.006}
    found = content(joint_file_text(case, changes, comment=""))
    assert {path: found[path] for path in changes} == pytest.approx(changes, rel=1e-15)
    assert found["bearings.sun_torque"] == found["bearings.pin_friction_coefficient"] == 0.0


def test_hardness_replaces_its_factor(zou_file):
    found = content(joint_file_text(read_case(zou_file), {"materials.steel.hardness": 2e9}, comment=""))
    assert found["materials.steel.hardness"] == 2e9
    assert "materials.steel.hardness_factor" not in found


def test_materials_of_libraries(zou_file, tmp_path):
    (tmp_path / "own.toml").write_text(BRONZE)
    text = (
        zou_file.read_text()
        .replace('sun = "steel"', 'sun = "52100" # bought')
        .replace('ring = "steel"', 'ring = "soft"')
        .replace(
            "[bodies]",
            '[materials.soft]\nlibrary = "bronze"\nfile = "own.toml"\nyield_strength = "250 MPa"\n\n[bodies]',
        )
    )
    case = parse_case(text, source="test", folder=tmp_path)
    changes = {"materials.52100.youngs_modulus": 2.1e11, "materials.soft.density": 9000.0}
    again = joint_file_text(case, changes, comment="")
    assert 'sun = "52100" # bought' in again
    assert "own.toml" not in again
    found = content(again, folder=tmp_path / "elsewhere")
    expected = {path: key.value for path, key in numeric_keys(case).items()} | changes
    assert found == pytest.approx(expected, rel=1e-14, abs=0.0)


@pytest.mark.parametrize(
    "text",
    [
        "[surface.sp]\n{0}\n[surface.pwr]\n{0}\n{1}\n[surface.pwl]\n{0}\n[surface.wro]\n{0}\n[surface.wlo]\n{0}\n",
        "surface = {{ {2} }}\n{1}",
        "surface.fractal_dimension = 1.5 # own\nsurface.fractal_roughness = '1e-8 mm'\n"
        "surface.frequency_ratio = 1.5\n{1}",
    ],
)
def test_layouts_that_nobody_expects(zou_file, text):
    keys = ["fractal_dimension = 1.5", 'fractal_roughness = "1e-8 mm"', "frequency_ratio = 1.5"]
    rest = zou_file.read_text().partition("[surface]")[0]
    written = text.format("\n".join(keys), rest, ", ".join(keys))
    case = parse_case(written, source="test")
    for path in ("surface.fractal_dimension", "surface.pwl.fractal_dimension"):
        found = content(joint_file_text(case, {path: 1.25}, comment=""))
        assert found[path if path in found else "surface.pwl.fractal_dimension"] == 1.25
        assert sum(value == 1.25 for value in found.values()) in (1, 5)


def test_a_case_without_a_text_is_written_from_its_tables(zou_file):
    case = read_case(zou_file).with_text("")
    assert case == read_case(zou_file)
    again = joint_file_text(case, {"drive.contact_length.sp": 0.006}, comment="")
    assert content(again)["drive.contact_length.sp"] == pytest.approx(0.006)
    assert si_values(parse_case(again, source="x"))["bodies"] == si_values(case)["bodies"]


def test_loads_of_the_duty_are_counted_from_one():
    """The second of two loads gets a key, and then loses it; the first stays."""
    document = tomlkit.parse("[[duty]]\nshare = 0.4\n[[duty]]\nshare = 0.6\n")
    edited_text._set(document, ("duty", "2", "share"), 0.5)
    assert document.unwrap() == {"duty": [{"share": 0.4}, {"share": 0.5}]}
    edited_text.leave_out(document, "duty.2.share")
    assert document.unwrap() == {"duty": [{"share": 0.4}, {}]}
    edited_text.leave_out(document, "duty.1.torque")
    assert document.unwrap() == {"duty": [{"share": 0.4}, {}]}


def test_an_rz_stays_where_no_number_changes(example_text):
    """As 'asperity serve' opens a file; a study, which varies Ra, writes Ra."""
    text = example_text.replace('fractal_roughness = "', 'mean_roughness_depth = "1.6 um" # was "')
    assert 'mean_roughness_depth = "1.6 um"' in text
    case = parse_case(text, source="x")
    assert joint_file_text(case, {}, comment="") == text
    plain = joint_file_text(case.with_text(""), {}, comment="")
    assert "roughness_average" not in plain
    assert parse_case(plain, source="y") == case
    changed = joint_file_text(case, {"load.preload": 900.0}, comment="")
    assert "mean_roughness_depth" not in changed
    assert "roughness_average" in changed


def section(text, name):
    """Keys of a section and where its first comment line stands, in the order of the file."""
    lines = text.split(f"[{name}]\n", 1)[1].split("\n[", 1)[0].splitlines()
    return [line.split(" ")[0] for line in lines if line]


def test_a_new_key_stands_where_the_replaced_one_stood(zou_file):
    """Not behind the sections that wait in the comments below: there it would go into another section with them."""
    again = joint_file_text(read_case(zou_file), {"load.interference": 13e-6}, comment="")
    found = section(again, "load")
    assert found[:4] == ["interference", "output_torque", "sun_speed", "friction_coefficient"]
    assert found[4] == "#"
    assert content(again)["load.interference"] == pytest.approx(13e-6, rel=1e-15)


def test_a_new_key_stands_after_the_last_one_of_its_section(zou_file):
    again = joint_file_text(read_case(zou_file), {"load.cam_force_per_torque": 20.0}, comment="")
    assert section(again, "load")[:6] == [
        "preload", "output_torque", "sun_speed", "friction_coefficient", "cam_force_per_torque", "#",
    ]  # fmt: skip
    waiting = "# [compliance]\n"
    started = again.replace(waiting, waiting[2:]).replace("# pin_stiffness", "pin_stiffness")
    assert content(started)["load.cam_force_per_torque"] == 20.0


def test_a_new_key_stands_after_one_with_a_table_in_its_line(zou_file):
    text = zou_file.read_text().replace(
        "friction_coefficient = 0.12 ",
        "friction_coefficient = { sp = 0.1, pwr = 0.1, pwl = 0.1, wro = 0.1, wlo = 0.1 } ",
    )
    case = parse_case(text, source="x")
    again = joint_file_text(case, {"load.cam_force_per_torque": 20.0}, comment="")
    assert section(again, "load")[3:6] == ["friction_coefficient", "cam_force_per_torque", "#"]


def test_a_new_word_stands_after_the_last_key_of_its_section(zou_file):
    document = tomlkit.parse(zou_file.read_text() + "\n# [rolling]\n# skew = 0\n")
    document["load"].pop("preload")
    edited_text.set_words(document, {"load.word": "new"})
    assert section(tomlkit.dumps(document), "load")[3:5] == ["word", "#"]


def test_an_rz_and_the_shares_of_a_file(joint_text):
    rough = joint_text.replace('fractal_roughness = "', 'mean_roughness_depth = "1.6 um +- 0.2 um" # was "')
    loads = '[[duty]]\noutput_torque = "1 N*m"\nsun_speed = "1 rpm"\nshare = {}\n\n'
    text = f"{rough}\n\n" + loads.format('"40 %"') + loads.format(0.6)
    found = entered_values(parse_case(text, source="x"))
    assert {path: entry.value for path, (_, entry) in found.items()} == pytest.approx(
        {"surface.mean_roughness_depth": 1.6e-6, "duty.1.share": 0.4, "duty.2.share": 0.6}
    )
    _, depth = found["surface.mean_roughness_depth"]
    assert (depth.text, depth.tolerance) == ("1.6 um +- 0.2 um", pytest.approx(0.2e-6))


@pytest.mark.parametrize("stated", ['"2e-8 mm^3/(N*m)"', "PARTS"])
def test_a_wear_coefficient_is_read_and_written_with_its_unit(zou_file, stated):
    parts = ("sun", "planet", "loading_roller", "ring")
    each = ", ".join(f'{part} = "2e-17 1/Pa"' for part in parts)
    text = zou_file.with_name("wear.toml").read_text(encoding="utf-8")
    text = text.replace(
        'coefficient = "1e-17 1/Pa" ', f"coefficient = {stated.replace('PARTS', f'{{ {each} }}')} ", 1
    )
    case = parse_case(text, source="x")
    paths = ["wear.coefficient"] if stated != "PARTS" else [f"wear.coefficient.{part}" for part in parts]
    found = {path: key.value for path, key in numeric_keys(case).items() if path.startswith("wear.")}
    assert found == dict.fromkeys(paths, pytest.approx(2e-17, rel=1e-12, abs=0.0))
    without_text = joint_file_text(case.with_text(""), {}, comment="")
    assert parse_case(without_text, source="x") == case


def test_paths_of_one_contact_and_of_other_keys():
    assert entered_key_at("surface.pr.mean_roughness_depth", "planetary").unit == "um"
    assert entered_key_at("duty.12.share", "wedge").unit == "1"
    assert entered_key_at("surface.roughness_average", "planetary") is None
    assert entered_key_at("mean_roughness_depth", "planetary") is None


def test_an_rz_takes_the_place_of_g_and_of_ra_and_gives_it_back():
    tables = {"surface": {"fractal_roughness": "1 nm", "frequency_ratio": 1.5}}
    set_texts(
        tables, {"surface.mean_roughness_depth": "1.6 um", "surface.partner_mean_roughness_depth": "1 um"}
    )
    assert "fractal_roughness" not in tables["surface"]
    set_texts(tables, {"surface.partner_roughness_average": "0.1 um"})
    assert set(tables["surface"]) == {"frequency_ratio", "mean_roughness_depth", "partner_roughness_average"}
    set_texts(tables, {"surface.roughness_average": "0.2 um"})
    assert "mean_roughness_depth" not in tables["surface"]
    set_texts(tables, {"surface.sp.mean_roughness_depth": "1.6 um"})
    assert tables["surface"]["sp"]["mean_roughness_depth"] == "1.6 um"
    assert "roughness_average" in tables["surface"]["wlo"]
