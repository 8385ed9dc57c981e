"""Paths of the numbers of joint files: those that studies vary, and those that are only entered."""

from asperity.joint_file.case_types import CASES, DefaultCase
from asperity.joint_file.section import keys_by_path
from asperity.unit_table import Dimension


def test_every_number_of_a_joint_file_has_a_path():
    keys = keys_by_path(DefaultCase)
    assert keys["drive.sun_radius"].dimension is Dimension.LENGTH
    assert keys["drive.contact_length"] == keys["drive.contact_length.*"]
    assert keys["materials.*.youngs_modulus"].dimension is Dimension.PRESSURE
    assert keys["surface.fractal_dimension"] == keys["surface.*.fractal_dimension"]
    assert keys["compliance.pin_stiffness"].dimension is Dimension.STIFFNESS
    assert keys["bearings.pin_diameter"].dimension is Dimension.LENGTH
    assert "model.closure" not in keys


def test_an_rz_and_a_share_are_entered_and_no_study_varies_them():
    entered = keys_by_path(DefaultCase, numbers="entered")
    assert {path for path in entered if path.count(".") == 1} == {
        "drive.ratio",
        "surface.mean_roughness_depth",
        "surface.partner_mean_roughness_depth",
    }
    assert (entered["duty.*.share"].lower, entered["duty.*.share"].upper) == (0.0, 1.0)
    assert entered["surface.*.mean_roughness_depth"].unit == "um"
    assert not set(entered) & set(keys_by_path(DefaultCase))
    for model in CASES.values():
        assert "surface.*.mean_roughness_depth" in keys_by_path(model, numbers="entered")


def test_fields_are_both_in_the_order_of_the_file():
    found = [path for path in keys_by_path(DefaultCase, numbers="all") if path.startswith("duty.")]
    assert found == ["duty.*.output_torque", "duty.*.sun_speed", "duty.*.share"]
    assert set(keys_by_path(DefaultCase, numbers="all")) == set(keys_by_path(DefaultCase)) | set(
        keys_by_path(DefaultCase, numbers="entered")
    )
