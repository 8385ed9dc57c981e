"""Entries of other drives that are one for all contacts, or a table with one for each."""

import pytest
from pydantic import TypeAdapter, ValidationError

from asperity.joint_file.drive_sections import PartLengths, PartName


def test_a_length_for_all_contacts_or_for_each():
    read = TypeAdapter(PartLengths).validate_python
    assert read("10 mm").value == pytest.approx(10e-3)
    assert {name: each.value for name, each in read({"sp": "10 mm", "pr": "12 mm"}).items()} == {
        "sp": pytest.approx(10e-3),
        "pr": pytest.approx(12e-3),
    }


@pytest.mark.parametrize("name", ["1st", "", "a b", "x" * 61])
def test_names_begin_with_a_letter(name):
    with pytest.raises(ValidationError):
        TypeAdapter(PartName).validate_python(name)
