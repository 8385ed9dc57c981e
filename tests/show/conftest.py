from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture
def joint_of():
    """A joint of the examples with some of its numbers replaced, from paths of the joint file."""
    from asperity.joint_file.build import joint_from_values
    from asperity.joint_file.reader import read_case
    from asperity.joint_file.si_tables import replace_values, si_values

    def make(name="zou2025", **changes):
        values = si_values(read_case(EXAMPLES / f"{name}.toml"))
        return joint_from_values(
            replace_values(values, {key.replace("__", "."): value for key, value in changes.items()})
        )

    return make
