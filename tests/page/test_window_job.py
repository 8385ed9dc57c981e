"""The window as a job of the page: the document of the command, and its picture behind the verdict."""

from pathlib import Path

from asperity.joint_file import window as axis
from asperity.page.window_job import window

WHEELS = Path(__file__).parents[2] / "examples" / "wheel_pair.toml"


def test_the_view_has_the_verdict_and_the_picture_first(monkeypatch):
    asked = {}

    def few(case, **options):
        asked.update(options)
        return axis.joint_window(case, start=500.0, stop=1000.0, points=2, **options)

    monkeypatch.setattr("asperity.page.window_job.joint_window", few)
    told = []
    found = window(str(WHEELS), {"over": "preload"}, lambda done, total: told.append(done))
    assert asked["over"] == "preload"
    assert told
    verdict, picture, *others = found["views"]
    assert verdict["text"] == "The output torque of the file lies inside the window at 1000 N of preload."
    assert (picture["kind"], picture["svg"].count("</svg>")) == ("picture", 1)
    assert [block["kind"] for block in others].count("table") == 3
    assert found["working_N"] == 1000.0
