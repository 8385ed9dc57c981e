"""Sections [[form]]: which tracks their parts are, and what no part can have."""

from pathlib import Path

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.form_parts import form_errors, form_parts, refuse_floating_runout
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import numeric_keys, replace_values, si_values
from asperity.study.batch import evaluate_points

EXAMPLES = Path(__file__).parents[2] / "examples"


def case_with(example, *sections):
    text = (EXAMPLES / f"{example}.toml").read_text(encoding="utf-8")
    forms = "".join(f"\n[[form]]\n{section}\n" for section in sections)
    return parse_case(text + forms, source=example)


def errors_of(example, *sections):
    case = case_with(example, *sections)
    drive = joint_from_case(case).drive
    refuse_floating_runout(si_values(case), drive)
    return form_errors(
        si_values(case), form_parts(si_values(case), drive), drive, round(float(drive.sectors))
    )


def test_runout_is_twice_an_amplitude():
    (error,) = errors_of("zou2025", 'part = "ring"\nrunout = "6 um"\nphase = "90 deg"')
    assert (error.part, error.sector, error.harmonic) == ("ring", 0, 1)
    assert error.amplitude == pytest.approx(3e-6)
    assert error.phase == pytest.approx(1.5707963)
    assert error.sides == tuple((f"{name}_{of}", "second") for name in ("wro", "wlo") for of in (1, 2, 3))


def test_parts_of_every_sector_are_parts_of_their_own():
    errors = errors_of("zou2025", 'part = "planet"\nharmonics = { 2 = "0.5 um", 3 = "1 um" }')
    assert [(error.sector, error.harmonic) for error in errors] == [(s, n) for n in (2, 3) for s in (1, 2, 3)]
    assert errors[1].sides == (("sp_2", "second"), ("pwr_2", "first"), ("pwl_2", "first"))
    assert all(error.phase is None for error in errors)
    (alone,) = errors_of("zou2025", 'part = "planet"\nsector = 3\nharmonics = { 2 = "0.5 um" }')
    assert alone.sector == 3


def test_a_name_of_sizes_means_all_rollers_of_this_size():
    errors = errors_of("zou2025", 'part = "loading_roller"\nrunout = "2 um"')
    assert {error.part for error in errors} == {"right_loading_roller", "left_loading_roller"}
    assert len(errors) == 6
    (short,) = {error.part for error in errors_of("zou2025", 'part = "right_roller"\nrunout = "2 um"')}
    assert short == "right_loading_roller"


def test_tracks_of_a_stepped_roller_have_forms_of_their_own():
    errors = errors_of("stepped_planet", 'part = "planet_second"\nrunout = "2 um"\nsector = 1')
    assert [(error.part, error.sides) for error in errors] == [("planet_second", (("pr2_1", "first"),))]
    errors = errors_of("stepped_planet", 'part = "planet"\nrunout = "2 um"\nsector = 1')
    assert errors[0].sides == (("sp_1", "second"), ("pr1_1", "first"))


def test_a_drive_of_one_sector_keeps_its_names():
    (error,) = errors_of("wheel_pair", 'part = "driver"\nrunout = "2 um"')
    assert (error.sector, len(error.sides)) == (0, 1)
    assert "_" not in error.sides[0][0]


def test_contacts_of_neighbouring_sectors_are_found():
    """A roller that touches rollers of two sectors has its wave at the contacts of both."""
    case = case_with("multiroller", 'part = "sun"\nrunout = "1 um"')
    drive = joint_from_case(case).drive
    parts, sectors = form_parts(si_values(case), drive), round(float(drive.sectors))
    beside = [contact for contact in drive.contacts if contact.sector]
    assert beside
    errors = form_errors(si_values(case), parts, drive, sectors)
    assert errors
    from asperity.drive.layout.form import lobes_of
    from asperity.drive.layout.unfolding import unfolded

    whole = unfolded(drive, sectors=sectors)
    for name in parts:
        stated = case_with("multiroller", f'part = "{name}"\nharmonics = {{ 2 = "1 um" }}')
        for error in form_errors(si_values(stated), parts, drive, sectors):
            body = whole.bodies[lobes_of(whole, error.sides, 2).body].name
            assert body.endswith(f"_{error.sector}") or error.sector == 0


@pytest.mark.parametrize(
    ("section", "said"),
    [
        (
            'part = "planet"\nrunout = "4 um"',
            "form.1.runout = 4 um: the planet floats, no axis: leave it out",
        ),
        (
            'part = "planet"\nharmonics = { 1 = "2 um" }',
            "form.1.harmonics.1 = 2 um: the planet floats, no axis",
        ),
        ('part = "sun"\nharmonics = { 0 = "2 um" }', r"harmonic 0 is a size.*use \[\[branch\]\]"),
        ('part = "sun"\nharmonics = { two = "2 um" }', "whole numbers from 1 to 999.*got 'two'"),
        ('part = "sun"\nharmonics = { 1000 = "2 um" }', "whole numbers from 1 to 999"),
        ('part = "sun"', "runout, harmonics: one of both must be given"),
        ('part = "sun"\nrunout = "2 um"\nharmonics = { 1 = "1 um" }', "both are the eccentricity"),
        ('part = "sun"\nrunout = "0 um"', "runout: 0 um is not allowed"),
        ('part = "sun"\nrunout = 4', "form.1.runout"),
        ('part = "sunn"\nrunout = "4 um"', "form.1.part: the drive has no part 'sunn'; did you mean 'sun'"),
        (
            'part = "sun"\nsector = 1\nrunout = "4 um"',
            "form.1.sector = 1: all sectors share the sun; leave it out",
        ),
        (
            'part = "planet"\nsector = 4\nharmonics = { 2 = "1 um" }',
            "form.1.sector = 4: the drive has 3 sectors",
        ),
        ('part = "sun"\nrun_out = "4 um"', "did you mean 'runout'"),
    ],
)
def test_refusals(section, said):
    with pytest.raises(InputError, match=said):
        errors_of("zou2025", section)


def test_a_harmonic_is_stated_once():
    with pytest.raises(
        InputError, match=r"form.2: harmonic 2 of the ring stands in form.1 too; state it once"
    ):
        errors_of("zou2025", *['part = "ring"\nharmonics = { 2 = "1 um" }'] * 2)


def test_a_supported_planet_has_an_axis():
    text = (EXAMPLES / "zou2025.toml").read_text(encoding="utf-8")
    text = text.replace("[model]", '[compliance]\nplanet_support_stiffness = "5 N/um"\n\n[model]', 1)
    case = parse_case(text + '\n[[form]]\npart = "planet"\nrunout = "4 um"\n', source="a")
    drive = joint_from_case(case).drive
    assert len(form_errors(si_values(case), form_parts(si_values(case), drive), drive, 3)) == 3


def test_numbers_of_form_errors_have_paths():
    case = case_with("zou2025", 'part = "ring"\nrunout = "6 um"\nharmonics = { 3 = "1 um" }')
    keys = numeric_keys(case)
    assert keys["form.1.harmonics.3"].value == pytest.approx(1e-6)
    changed = replace_values(si_values(case), {"form.1.harmonics.3": 2e-6, "form.1.runout": 1e-6})
    assert changed["form"]["1"] == {"part": "ring", "runout": 1e-6, "harmonics": {"3": 2e-6}}


def test_a_floating_sun_has_no_axis():
    text = (EXAMPLES / "zou2025.toml").read_text(encoding="utf-8")
    text += '\n[[form]]\npart = "sun"\nrunout = "4 um"\n'
    for stiffness, refused in (("0 N/mm", True), ("100 N/mm", False)):
        stated = text.replace("[model]", f'[compliance]\nsun_support_stiffness = "{stiffness}"\n\n[model]', 1)
        case = parse_case(stated, source="a")
        drive = joint_from_case(case).drive
        if refused:
            with pytest.raises(InputError, match="the sun floats, no axis: leave it out"):
                refuse_floating_runout(si_values(case), drive)
            # and the same of a study
            values = si_values(case)
            with pytest.raises(InputError, match="the sun floats"):
                evaluate_points(values, {"load.output_torque": np.array([5.0])}, ("transmission_error",))
        else:
            refuse_floating_runout(si_values(case), drive)
            assert len(form_errors(si_values(case), form_parts(si_values(case), drive), drive, 3)) == 1
