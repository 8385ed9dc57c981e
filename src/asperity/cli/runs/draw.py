"""What the command of :mod:`asperity.cli.draw` does."""

from __future__ import annotations

from asperity.api.documents import check_drawing
from asperity.api.documents import draw as drawn
from asperity.api.joint import DescribedJoint
from asperity.cli.joint_input import check_title, read_case_of_branches
from asperity.cli.terminal import about, say, say_written
from asperity.joint_file.reader import read_case


def draw(file: str, out: str, forces: bool, parts: bool, **stated: str) -> None:
    """What ``asperity draw`` does; its options stand in :mod:`asperity.cli.draw`."""
    check_drawing(out, file)
    check_title(stated)
    case = read_case_of_branches(file) if forces else read_case(file)

    def warn(sentence: str) -> None:
        say(f"asperity: warning: {sentence}")

    with about(file):
        files = drawn(DescribedJoint(case, file), out, forces=forces, parts=parts, title=stated, notice=warn)
    for path in files:
        say_written(str(path))
