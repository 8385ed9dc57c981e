"""What a section [heat] may not say beside the other sections of a joint file."""

from pathlib import Path

import pytest

from asperity.errors import InputError
from asperity.joint_file.reader import parse_case

EXAMPLE = (Path(__file__).parents[2] / "examples" / "heat.toml").read_text(encoding="utf-8")


def refusal(old, new):
    """The message about the example with another text."""
    assert old in EXAMPLE
    with pytest.raises(InputError) as refused:
        parse_case(EXAMPLE.replace(old, new), source="joint.toml")
    return str(refused.value)


def test_a_cold_start_above_the_ambient_is_none():
    said = refusal('cold_start = "-10 degC"', 'cold_start = "26 degC"')
    assert "heat.cold_start = '26 degC' is above heat.ambient = '25 degC'" in said
    assert "or leave it out" in said
    parse_case(EXAMPLE.replace('cold_start = "-10 degC"', 'cold_start = "25 degC"'), source="joint.toml")


def test_the_time_of_a_duty_needs_its_loads():
    duty = EXAMPLE[EXAMPLE.index("[[duty]]") : EXAMPLE.index("[lubrication]")]
    said = refusal(duty, "")
    assert "heat.duty_time = '20 min': the file states no loads that it is the time of" in said
    assert "[[duty]]" in said
