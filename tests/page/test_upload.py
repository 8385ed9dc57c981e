"""Files are recognised by content; a wrong one gets the message of the command."""

import asyncio
import io
import json
import threading

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.page import upload
from asperity.page.child import StoppedError
from asperity.page.job_process import run_job
from asperity.page.upload import measured_upload, opened_design, opened_joint, recognised, refuse_downloads
from asperity.surface.measure_files import read_surface
from asperity.surface.measurement import SCHEMA
from asperity.views.blocks import Report
from asperity.views.html import report_html

DESIGN = b'joint = "a.toml"\n[variables]\n"load.preload" = {lower = "1 N", upper = "2 N"}\n'


def profile(*, seed=1, points=4096):
    """A Brownian profile: D = 1.5, whose spectrum falls with the square of the frequency."""
    heights = np.cumsum(np.random.default_rng(seed).normal(size=points)) * 1e-9
    text = io.BytesIO()
    np.savetxt(
        text,
        np.stack([np.arange(points) * 2e-7, heights], 1),
        delimiter=",",
        header="x [m],z [m]",
        comments="",
    )
    return text.getvalue()


@pytest.mark.parametrize(
    ("content", "name", "kind"),
    [
        (b"# a joint\n[drive]\nplanets = 3\n", "what.txt", "joint"),
        (b'\xef\xbb\xbfschema = "x"\n', "joint", "joint"),
        (DESIGN, "mine", "design"),
        (b"\x89PNG\r\n\x1a\n", "picture.toml", "joint"),
        (b'  {"schema": "' + SCHEMA.encode() + b'"}', "m.json", "measurement"),
        (b"x [m],z [m]\n0,1\n", "p.csv", "surface"),
        (b"1.0 2.0\n", "p", "surface"),
        (b"POINTS = 3\nDX=1.5 um\n" + b"-12,5\n" * 9, "p.txt", "surface"),
        (b"aISO-1.0\r\nManufID = NanoFocus\r\n", "p.sdf", "surface"),
        (b"[DataSet]\nVersion=1\n", "p.ezd", "surface"),
        (b"PK\x03\x04 a = 1\n", "p.x3p", "surface"),
        (b"\x89HDF\r\n", "p.opdx", "surface"),
        (b"", "empty", "surface"),
    ],
)
def test_files_are_recognised(content, name, kind):
    assert recognised(content, name) == kind


def test_a_joint_is_opened_with_its_values(joint_text):
    found = opened_joint(joint_text.encode(), "a.toml")
    assert found["numbers"]["drive.sun_radius"]["value"] == 4.0
    with pytest.raises(InputError, match="opens no other files"):
        opened_joint(
            joint_text.encode() + b'\n[materials.x]\nlibrary = "x"\nfile = "/etc/passwd"\n', "a.toml"
        )


@pytest.mark.parametrize(
    ("content", "name", "said"),
    [
        (
            b'{\n  "asperity_version": "0.1.0",\n  "torsional_stiffness": {}\n}',
            "a.json",
            "a.json: this is the result document of a joint: no joint can be read from it; open the joint file (.toml)",
        ),
        (b'{"asperity_version": "0.1.0", "inputs": {}}', "s.json", "s.json: this is a result document: "),
        (
            report_html(Report("Traction-drive joint: a.toml", ())).encode(),
            "a.html",
            "a.html: this is the report of a joint: no joint can be read from it; open the joint file (.toml), whose "
            "text is in the last section of the report",
        ),
        (b"%PDF-1.7\n", "a.pdf", "a.pdf: this is a PDF, such as the report of a joint: "),
    ],
)
def test_a_result_or_a_report_is_refused_with_what_to_open(content, name, said):
    for read in (lambda: measured_upload(content, name, {}), lambda: opened_joint(content, name)):
        with pytest.raises(InputError) as refused:
            read()
        assert str(refused.value).startswith(said)
        assert "unit" not in str(refused.value)  # which would ask for those of a surface


@pytest.mark.parametrize(
    "content",
    [b'{"schema": "' + SCHEMA.encode() + b'", "asperity_version": "1"}', b'{"asperity_version"', b"1\n"],
)
def test_other_files_are_not_taken_for_results(content):
    assert refuse_downloads(content, "m.json") is None


def test_a_design_is_text():
    assert opened_design(DESIGN, "d.toml") == {"name": "d.toml", "design": DESIGN.decode()}
    with pytest.raises(InputError, match=r"d\.toml: not valid TOML"):
        opened_design(b"[variables", "d.toml")


def test_a_profile_of_a_known_dimension_is_measured(tmp_path, monkeypatch):
    """In this process, to save the start of another; D of Brownian heights is 1.5."""
    started = []

    class Here:
        def __init__(self, kind, files, options):
            started.append(kind)
            ((self.name, content),) = files.items()
            (tmp_path / self.name).write_bytes(content)
            self.options = options

        def run(self, longest):
            assert longest == upload.LONGEST_MEASUREMENT
            monkeypatch.chdir(tmp_path)
            return run_job({"kind": "measure", "file": self.name, "options": self.options}, lambda *_: None)

    monkeypatch.setattr(upload, "Child", Here)
    monkeypatch.setattr("resource.setrlimit", lambda *_: None)
    found = measured_upload(
        profile(), "../pro file.csv", {"position_unit": "", "height_unit": "", "spacing": ""}
    )
    low, high = found["document"]["fractal_dimension_interval_95"]
    assert low < 1.5 < high
    assert found["surface"]["fractal_dimension"] == found["document"]["fractal_dimension"]
    # the document of the measurement is opened as well, and says the same; of its profile the lay can be stated
    again = measured_upload(json.dumps(found["document"]).encode(), "m.json", {})
    assert again["surface"] == found["surface"]
    axis = measured_upload(json.dumps(found["document"]).encode(), "m.json", {"lay": "axis"})["surface"]
    (spectrum,), (turned,) = found["surface"]["spectra"], axis["spectra"]
    assert (spectrum["lay"], turned["lay"]) == (None, "axis")
    assert turned["rolling_frequency_edges_per_m"] == spectrum["axial_frequency_edges_per_m"]
    # and that it is of both bodies together
    pair = measured_upload(json.dumps(found["document"]).encode(), "m.json", {"measurement_of": "pair"})
    assert (found["surface"]["measurement_of"], pair["surface"]["measurement_of"]) == ("body", "pair")
    # a smooth surface has no power law; a joint takes its spectrum
    x = np.arange(2000) * 1e-6
    smooth = np.stack([x, 1e-7 * np.sin(2 * np.pi * x / 1e-3)], 1)
    text = io.BytesIO()
    np.savetxt(text, smooth, delimiter=",", header="x [m],z [m]", comments="")
    refused = measured_upload(text.getvalue(), "smooth.csv", {"lay": "rolling"})
    assert refused["document"]["no_power_law"]
    assert refused["surface"]["spectra"][0]["lay"] == "rolling"
    # too few points for a spectrum leave nothing
    short = measured_upload(profile(points=10), "short.csv", {})
    assert short["surface"] is None
    assert started == ["measure"] * 6


@pytest.mark.slow
def test_a_wrong_file_gets_the_message_of_the_command(tmp_path, monkeypatch):
    """By the process that also the page starts."""
    content = b"hello, no numbers\n"
    (tmp_path / "words.csv").write_bytes(content)
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError) as command:
        read_surface(path="words.csv")
    with pytest.raises(InputError) as page:
        measured_upload(content, "../../words.csv", {})
    assert str(page.value) == str(command.value)


def test_the_end_of_the_server_ends_a_measurement(monkeypatch):
    class Waiting:
        def __init__(self, kind, files, options):
            self.begun, self.end = threading.Event(), threading.Event()
            children.append(self)

        def run(self, longest):
            self.begun.set()
            self.end.wait(30)
            raise StoppedError("stopped")

        def stop(self):
            self.end.set()

    children = []
    monkeypatch.setattr(upload, "Child", Waiting)
    measurements = upload.Measurements()

    async def measure():
        task = asyncio.ensure_future(measurements.run(b"1", "p.csv", {}))
        while not children or not children[0].begun.is_set():
            await asyncio.sleep(0.005)
        measurements.close()
        await task

    with pytest.raises(StoppedError):
        asyncio.run(measure())


@pytest.mark.parametrize(
    ("key", "word"), [("lay", "across"), ("direction", "z"), ("missing", "keep"), ("measurement_of", "both")]
)
def test_a_lay_and_a_direction_are_words(key, word):
    with pytest.raises(InputError, match=f"{key}: '{word}' is not one of"):
        measured_upload(b"1\n2\n", "p.csv", {key: word})


def test_a_spacing_needs_its_unit():
    with pytest.raises(InputError, match="length"):
        measured_upload(b"1\n2\n", "p.csv", {"spacing": "3"})
