"""What a joint file assumes, told from the file alone."""

from asperity.joint_file.assumptions import assumptions as told
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.model import Case


def assumptions(case: Case) -> tuple[str, ...]:
    """The sentences of a joint file and of the joint that it describes."""
    return told(case, joint_from_case(case))
