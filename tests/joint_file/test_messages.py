from asperity.joint_file.messages import keys_by_path, nearest
from asperity.unit_table import Dimension


def test_the_nearest_name_is_offered_and_a_far_one_is_not():
    assert nearest("sun_radus", ["sun_radius", "planets"]) == "; did you mean 'sun_radius'?"
    assert nearest("xyz", ["sun_radius", "planets"]) == ""


def test_every_number_of_a_joint_file_has_a_path():
    keys = keys_by_path()
    assert keys["drive.sun_radius"].dimension is Dimension.LENGTH
    assert keys["drive.contact_length"] == keys["drive.contact_length.wlo"]
    assert keys["materials.*.youngs_modulus"].dimension is Dimension.PRESSURE
    assert keys["surface.fractal_dimension"] == keys["surface.pwr.fractal_dimension"]
    assert keys["compliance.pin_stiffness"].dimension is Dimension.STIFFNESS
    assert keys["bearings.pin_diameter"].dimension is Dimension.LENGTH
    assert "model.closure" not in keys
