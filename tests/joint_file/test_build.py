"""Joints of other drives from their files."""

import math

import numpy as np
import pytest
from assumed import assumptions

from asperity.joint.bores import pin_compliances
from asperity.joint_file.build import (
    joint_from_case,
    joint_from_values,
    toleranced_tracks,
)
from asperity.joint_file.si_tables import replace_values, si_values
from asperity.surface.roughness_average import roughness_average


def test_the_joint_has_the_sizes_of_the_file(planar_case):
    joint = joint_from_case(planar_case("planetary_hollow"))
    assert joint.contact_names == ("sp", "pr")
    assert [shape.kind for shape in joint.shapes] == ["solid", "hollow", "ring"]
    assert (float(joint.shapes[1].size), float(joint.shapes[2].size)) == pytest.approx((26e-3, 30e-3))
    np.testing.assert_allclose(joint.drive.second_radius, [20e-3, 50e-3])
    assert joint.preload is None
    assert float(joint.interference) == pytest.approx(30e-6)


def test_numbers_for_each_contact(planar_case):
    case = planar_case(
        "planetary", ('contact_length = "10 mm"', 'contact_length = { sp = "10 mm", pr = "12 mm" }')
    )
    assert joint_from_case(case).contact_lengths == pytest.approx((10e-3, 12e-3))


def test_skew_of_all_contacts_or_of_each(planar_case):
    def skew(text):
        case = planar_case("multiroller", ("[model]", f"[rolling]\nskew = {text}\n\n[model]"))
        return case, joint_from_case(case).rolling.skew

    assert joint_from_case(planar_case("multiroller")).rolling.skew is None
    case, one = skew('"0.5 mrad"')
    assert one == pytest.approx((5e-4,))
    _, each = skew('{ sr = "-1 mrad", fsl = "2 mrad", sf = "0 rad", fsr = "0 rad" }')
    assert each == pytest.approx((0.0, 2e-3, 0.0, -1e-3))
    changed = replace_values(si_values(case), {"rolling.skew.sr": 1e-3})
    assert joint_from_values(changed).rolling.skew == pytest.approx((5e-4, 5e-4, 5e-4, 1e-3))
    added = replace_values(si_values(planar_case("multiroller")), {"rolling.skew.sf": 1e-3})
    assert joint_from_values(added).rolling.skew == pytest.approx((1e-3, 0.0, 0.0, 0.0))


def test_crowns_of_both_tracks_of_a_contact_add(planar_case):
    """1/R_c of the first track and of the second one; a track that is not mentioned is a cylinder."""

    def curvatures(name, old, new):
        return joint_from_case(planar_case(name, (old, new))).crown_curvatures

    assert joint_from_case(planar_case("multiroller")).crown_curvatures is None
    found = curvatures(
        "multiroller",
        "[load]",
        'first_row_small_crown_radius = "2 m"\nring_crown_radius = "5 m"\nsecond_row_crown_radius = "0.5 m"\n\n[load]',
    )
    assert found == pytest.approx((0.0, 2.5, 2.5, 0.2))
    found = curvatures("stepped_planet", "[load]", 'planet_second_crown_radius = "1 m"\n\n[load]')
    assert found == pytest.approx((0.0, 0.0, 1.0))
    crown = 'second_radius = "40 mm"\nsecond_crown_radius = "4 m"\n'
    case = planar_case("planar", ('second_radius = "40 mm"\n', crown))
    assert joint_from_case(case).crown_curvatures == pytest.approx((0.0, 0.0, 0.0, 0.25, 0.25))
    changed = replace_values(si_values(case), {"contact.2.first_crown_radius": 2.0})
    assert joint_from_values(changed).crown_curvatures == pytest.approx((0.5, 0.5, 0.5, 0.25, 0.25))
    assert any(told.startswith("crowned rollers: in slices") for told in assumptions(case))


def test_surfaces_for_each_contact(planar_case):
    one = 'fractal_dimension = 1.5\nfractal_roughness = "1.3e-7 mm"    # superfinished, towards the rough end'
    text = "[surface]\n" + one + "\nfrequency_ratio = 1.5"
    tables = "".join(
        f'[surface.{name}]\nfractal_dimension = {d}\nfractal_roughness = "1e-8 mm"\nfrequency_ratio = 1.5\n'
        for name, d in (("pr", 1.3), ("sp", 1.6))
    )
    surfaces = joint_from_case(planar_case("planetary", (text, tables))).surfaces
    assert [surface.fractal_dimension for surface in surfaces] == [1.6, 1.3]


def test_springs_of_the_structure_are_rigid_unless_stated(planar_case):
    rigid = joint_from_case(planar_case("planetary"))
    assert (rigid.pin_stiffness, rigid.input_shaft_stiffness) == (None, math.inf)
    assert float(pin_compliances(rigid)[0]) == 0.0
    stated = joint_from_case(
        planar_case("planetary", ("# [compliance]", "[compliance]"), ("# pin_stiffness", "pin_stiffness"))
    )
    assert stated.pin_stiffness == pytest.approx(1e8)
    assert stated.output_shaft_stiffness == math.inf


def test_a_surface_may_be_stated_by_its_ra(planar_case):
    """Two bodies of one Ra: the equivalent surface has the square root of two times as much."""
    given = (
        'fractal_dimension = 1.5\nfractal_roughness = "1.3e-7 mm"    # superfinished, towards the rough end\n'
    )
    average = 'finish = "superfinished"\nroughness_average = "0.1 um"\n'
    law = ("[model]\n", '[model]\ncontact_law = "zou_2025"\n')
    case = planar_case("planetary", (given + "frequency_ratio = 1.5\n", average), law)
    assert case.surface.fractal_dimension.tolerance > 0.0
    (surface,) = joint_from_case(case).surfaces
    found = roughness_average(
        fractal_dimension=surface.fractal_dimension,
        fractal_roughness=surface.fractal_roughness,
        cut_off=0.25e-3,
    )
    assert found == pytest.approx(math.sqrt(2.0) * 0.1e-6)


def test_bearings_play_and_duty(planar_case):
    joint = joint_from_case(planar_case("planetary"))
    assert joint.bearings is None
    assert (joint.play.angle, joint.rolling.duty) == (0.0, ())
    sections = (
        '[bearings]\ninput_torque = "1 N*mm"\nroller_torque = "2 N*mm"\n'
        'pin_friction_coefficient = 0.01\npin_diameter = "4 mm"\n\n'
        '[play]\nangle = "1 mrad"\ntake_up_torque = "0.1 N*m"\n\n'
        '[[duty]]\noutput_torque = "1 N*m"\nsun_speed = "1 rad/s"\nshare = 1.0\n\n[model]'
    )
    joint = joint_from_case(planar_case("planetary", ("[model]", sections)))
    assert vars(joint.bearings) == {
        "input_torque": 1e-3,
        "roller_torque": 2e-3,
        "output_torque": 0.0,
        "pin_friction_coefficient": 0.01,
        "pin_friction_diameter": 4e-3,
    }
    assert (joint.shapes[1].pin_diameter, joint.shapes[1].bore_diameter) == (4e-3, 4e-3)
    assert (joint.pin_clearance, joint.pin_clearance_stated) == (0.0, False)
    assert (joint.play.angle, joint.play.take_up_torque) == (1e-3, 0.1)
    assert [vars(point) for point in joint.rolling.duty] == [
        {"output_torque": 1.0, "input_speed": 1.0, "share": 1.0}
    ]


def test_pins_press_in_bores_or_only_rub(planar_case):
    """Friction at a diameter of its own makes no bore; with both keys the pin makes the bore."""
    rubs = '[bearings]\npin_friction_coefficient = 0.01\npin_friction_diameter = "6 mm"\n{}\n[model]'
    alone = joint_from_case(planar_case("planetary", ("[model]", rubs.format(""))))
    assert (alone.bearings.pin_friction_diameter, alone.shapes[1].kind) == (6e-3, "solid")
    pressed = 'pin_diameter = "4 mm"\npin_radial_clearance = "3 um"\n'
    both = joint_from_case(planar_case("planetary", ("[model]", rubs.format(pressed))))
    assert both.bearings.pin_friction_diameter == 6e-3
    assert (both.shapes[1].pin_diameter, both.shapes[1].bore_diameter) == (4e-3, 4e-3)
    assert (both.pin_clearance, both.pin_clearance_stated) == (pytest.approx(3e-6), True)


def test_what_a_radius_does_to_the_contacts(planar_case):
    """A larger roller presses, a larger ring lets go; the number of one contact is that of the whole track."""
    values = si_values(planar_case("planar"))
    paths = (
        "contact.2.first_radius",
        "contact.1.second_radius",
        "contact.4.second_radius",
        "contact.1.first_radius",
    )
    found = toleranced_tracks(values, (*paths, "load.output_torque", "load.interference"))
    assert [each.path for each in found] == [paths[0], paths[2], paths[3], "load.interference"]
    assert [each.per_branch for each in found] == [True, False, False, False]
    np.testing.assert_array_equal(
        [each.per_size for each in found],
        [[1, 1, 1, 0, 0], [0, 0, 0, -1, -1], [1, 0, 0, 0, 0], [0, 0, 0, 1, 1]],
    )
    typed = toleranced_tracks(
        si_values(planar_case("stepped_planet")), ("drive.sun_radius", "drive.planet_second_radius")
    )
    np.testing.assert_array_equal([each.per_size for each in typed], [[1, 0, 0], [0, 0, 1]])
    assert [each.per_branch for each in typed] == [False, True]


def test_both_loading_rollers_of_a_planet_have_one_radius_and_sizes_of_their_own(planar_case):
    radii = tuple(f"drive.{name}_radius" for name in ("sun", "planet", "loading_roller", "ring"))
    found = toleranced_tracks(si_values(planar_case("zou2025")), radii)
    assert [each.path for each in found] == [*radii[:3], *radii[2:]]
    assert [each.per_branch for each in found] == [False, True, True, True, False]
    np.testing.assert_array_equal(
        [each.per_size for each in found],
        [[1, 0, 0, 0, 0], [1, 1, 1, 0, 0], [0, 1, 0, 1, 0], [0, 0, 1, 0, 1], [0, 0, 0, -1, -1]],
    )
