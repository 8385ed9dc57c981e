"""Numbers of a joint file with units and tolerances; choices with their keys."""

from asperity.joint_file.reader import parse_case
from asperity.report.input_tables import choices_table, inputs_table


def test_numbers_have_their_units_and_tolerances(joint_text):
    text = joint_text.replace('planet_radius = "13.5 mm"', 'planet_radius = "13.5 mm +- 5 um"')
    rows = {row[0]: tuple(row[1:]) for row in inputs_table(parse_case(text, source="x")).rows}
    assert rows["drive.planet_radius"] == ("13.5 mm", "± 0.005 mm")
    assert rows["load.output_torque"] == ("5 N·m", "")
    assert rows["surface.fractal_roughness"] == ("1e-8 mm", "")


def test_choices_are_listed_with_their_keys(case):
    assert ("model.closure", "elastic") in [tuple(row) for row in choices_table(case).rows]


def test_shares_of_a_duty_are_numbers_of_the_file(joint_text):
    duty = "".join(
        f'[[duty]]\noutput_torque = "{torque} N*m"\nsun_speed = "100 rpm"\nshare = {share}\n\n'
        for torque, share in ((5, 0.25), (2, 0.75))
    )
    table = inputs_table(parse_case(joint_text.replace("[model]", f"{duty}[model]"), source="x"))
    rows = {row[0]: row[1] for row in table.rows}
    assert (rows["duty.1.share"], rows["duty.2.share"]) == ("0.25", "0.75")
    assert rows["duty.2.output_torque"] == "2 N·m"
