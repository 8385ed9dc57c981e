"""The oil over speed as a job of the page: the document of the command, behind its picture."""

from pathlib import Path

from asperity.joint_file import film as over_speed
from asperity.page.film_job import film

OIL = Path(__file__).parents[2] / "examples" / "oil.toml"


def test_the_view_has_the_picture_first(monkeypatch):
    def few(case, **options):
        return over_speed.joint_film(case, points=2, **options)

    monkeypatch.setattr("asperity.page.film_job.joint_film", few)
    told = []
    found = film(str(OIL), {}, lambda done, total: told.append((done, total)))
    assert told == [(1, 1)]
    picture, *others = found["views"]
    assert (picture["kind"], picture["svg"].count("</svg>")) == ("picture", 1)
    assert any(block["kind"] == "table" for block in others)
    assert (
        found["oil_temperature_C"] == found["roller_temperature_C"] == found["housing_temperature_C"] == 40.0
    )
    assert set(found["film"]["contacts"]) == {"sp", "pr"}
