"""The content of the joint file of each type of drive: a class for each type, a field for each key."""

from __future__ import annotations

from asperity.drive.types import DEFAULT_TYPE, TYPES
from asperity.joint_file.general_model import GeneralCase
from asperity.joint_file.made_sections import case_of_type
from asperity.joint_file.model import Case

#: Model of the joint file of each type of drive.
CASES: dict[str, type[Case]] = {
    name: GeneralCase if kind.is_listed else case_of_type(kind) for name, kind in TYPES.items()
}
#: That of a file without a type.
DefaultCase = CASES[DEFAULT_TYPE]
