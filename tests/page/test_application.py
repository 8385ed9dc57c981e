"""The JSON interface as a script uses it, compared with what the command prints."""

import json
import math
import re
import threading
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

pytest.importorskip("starlette")
pytest.importorskip("httpx2")

from starlette.testclient import TestClient

from asperity.joint_file.case_types import DefaultCase
from asperity.joint_file.schema import joint_schema
from asperity.page import application as application_module
from asperity.page import joint_request
from asperity.page.application import ASSETS, application
from asperity.page.computation import Computations
from asperity.page.joint_request import JointRequest
from asperity.surface.height_spectrum import spectrum_of_profiles
from asperity.surface.measured_roughness import MeasuredRoughness, roughness_document

HOST = "127.0.0.1:8642"


@pytest.fixture(scope="module")
def client(joint_text):
    app = application(
        JointRequest(name="zou2025.toml", text=joint_text),
        hosts=[HOST],
        computations=Computations(longest=600.0),
        charts=Computations(longest=600.0),
    )
    with TestClient(app, base_url=f"http://{HOST}", raise_server_exceptions=False) as found:
        yield found


@pytest.fixture
def solve(client, joint_text):
    def ask(**changes):
        body = {
            "toml": joint_text,
            "name": "my.toml",
            "changes": {k.replace("__", "."): v for k, v in changes.items()},
        }
        return client.post("/api/joint", json=body)

    return ask


@pytest.fixture(scope="module")
def printed(zou_file):
    """What ``asperity joint --json`` prints."""
    from click.testing import CliRunner

    from asperity.cli.commands import asperity

    done = CliRunner().invoke(asperity, ["joint", str(zou_file), "--json"])
    assert done.exit_code == 0
    return json.loads(done.stdout)


@pytest.mark.slow
def test_the_document_is_that_of_the_command(client, joint_text, printed):
    answer = client.post("/api/joint", json={"toml": joint_text}).json()
    assert answer["document"] == printed


@pytest.mark.long
def test_a_measured_surface_makes_the_joint_of_the_command(client, joint_text, zou_file, tmp_path):
    """White noise, which has no power law, as a profile of a stated lay."""
    from click.testing import CliRunner

    from asperity.cli.commands import asperity

    def command(*arguments):
        done = CliRunner().invoke(asperity, ["joint", *map(str, arguments), "--json"], catch_exceptions=False)
        return json.loads(done.stdout)

    heights = 1e-7 * np.random.default_rng(0).standard_normal((1, 4000))
    spectrum = spectrum_of_profiles(profiles=heights, spacing=1e-6, lay="axis", source="roller.csv")
    surface = roughness_document(MeasuredRoughness(None, "no power law", (spectrum,), "roller.csv"))
    (tmp_path / "m.json").write_text(json.dumps(surface))
    body = {"toml": joint_text, "surfaces": [surface]}
    answer = client.post("/api/joint", json=body).json()
    assert answer["document"] == command(zou_file, "--surface", tmp_path / "m.json")
    assert [entry["law"] for entry in answer["document"]["contact_laws"]] == ["exponential", "persson_2007"]
    # the file that is saved names the measurement that is saved, and both make the same joint
    text = client.get(f"/api/joint/{answer['id']}/joint.toml").text
    assert "roller.csv" in text
    (tmp_path / "saved.toml").write_text(text)
    (tmp_path / "measured_surface.json").write_text(json.dumps(answer["document"]["measured_surface"]))
    saved = command(tmp_path / "saved.toml")
    assert saved == answer["document"]
    # the report has the laws, and the measurement from which it can be made again
    report = client.get(f"/api/joint/{answer['id']}/joint.html").text
    assert "Contact laws side by side" in report
    assert "asperity report --surface" in report
    # compared with the saved file there is no difference, and it is said that a measured surface is compared
    other = {"toml": text, "surfaces": [answer["document"]["measured_surface"]]}
    compared = client.post("/api/compare", json={"one": body, "other": other}).json()
    assert compared["parts"][0].startswith(
        "Measured surfaces, joint.toml and joint.toml, second file: what the"
    )
    assert compared["document"]["results"] == []
    # the chart goes through the joint
    chart = {"over": "load.preload", "from": "900 N", "to": "1.1 kN", "points": 3}
    drawn = client.post("/api/chart", json=body | {"chart": chart | {"result": "assembly_stiffness_output"}})
    stiffness = saved["torsional_stiffness"]["assembly"]["output_Nm_per_rad"]
    assert drawn.json()["joint"]["y"] == pytest.approx(stiffness, rel=1e-6)


def test_two_joints_are_needed_to_compare_them(client, joint_text):
    one = {"toml": joint_text}
    for body, said in (
        ({"one": one}, "other: a JSON object with 'toml', .* is needed, it is missing"),
        ([], "the body: a JSON object with 'one', 'other' is needed"),
        ({"one": one, "other": one, "third": {}}, "unknown entry 'third'; known are one, other"),
        ({"one": one, "other": {}}, "other: give the joint either as 'toml'"),
    ):
        refused = client.post("/api/compare", json=body)
        assert refused.status_code == 422
        assert re.match(said, refused.json()["error"])


@pytest.mark.slow
def test_tables_say_the_same_as_text(client, joint_text, printed):
    import tomllib

    answer = client.post("/api/joint", json={"joint": tomllib.loads(joint_text)}).json()
    assert answer["document"] == printed


@pytest.mark.slow
def test_units_are_those_of_the_files(solve):
    one, other = solve(load__output_torque="4 N*m").json(), solve(load__output_torque="4000 N*mm").json()
    assert one["numbers"]["load.output_torque"]["si"] == 4.0
    assert other["document"]["torsional_stiffness"] == one["document"]["torsional_stiffness"]


@pytest.mark.slow
def test_curves_pass_through_the_joint(solve):
    answer = solve().json()
    curves, document = answer["curves"], answer["document"]
    capacity = document["standing_torque_capacity"]["output_torque_Nm"]
    assert curves["torque_Nm"][-1] == pytest.approx(capacity, rel=1e-12)
    # the stiffness at 5 N·m lies between those of the neighbouring torques
    above = next(i for i, torque in enumerate(curves["torque_Nm"]) if torque > 5.0)
    stiffness = document["torsional_stiffness"]["assembly"]["output_Nm_per_rad"]
    ends = sorted(curves["assembly_Nm_per_rad"][above - 1 : above + 1])
    assert ends[0] < stiffness < ends[1]
    drifts = curves["drift_rad_per_output_turn"][above - 1 : above + 1]
    assert drifts[0] < document["drift_rad_per_output_turn"] < drifts[1]
    # the loading curve of the wind-up is the integral of the compliance: its end is near T/K
    assert answer["windup"]["loading_angle_rad"][-1] == pytest.approx(5.0 / stiffness, rel=0.02)


@pytest.mark.slow
def test_forces_drawn_on_the_planet_balance(solve):
    """Equation (2): without rotation the three contacts hold the planet, in both directions and in moment."""
    answer = solve(load__sun_speed="0 rpm").json()
    planet = next(each for each in answer["drawing"]["bodies"] if each["body"] == "planet")
    sums = [0.0, 0.0, 0.0]
    for force in planet["forces"]:
        x, y = force["force_N"]
        sums[0] += x
        sums[1] += y
        sums[2] += force["radius_m"] * (force["place"][0] * y - force["place"][1] * x)
    assert len(planet["forces"]) == 6
    assert sums == pytest.approx([0.0, 0.0, 0.0], abs=1e-6)
    for force in answer["drawing"]["forces"]:
        size = math.hypot(*force["normal_N"])
        assert size == pytest.approx(answer["document"]["standing"]["forces"]["normal_N"][force["contact"]])


@pytest.mark.slow
def test_torques_of_the_ring_forces_are_the_reaction_of_the_ring(solve):
    """T_in + T_out = 3 R_o (T_wro + T_wlo) without losses; on the rollers the ring pushes against the clock."""
    answer = solve().json()
    moment = 0.0
    for force in answer["drawing"]["forces"]:
        if force["contact"] in ("wro", "wlo"):
            x, y = force["tangential_N"]
            moment += force["x_m"] * y - force["y_m"] * x
    forces = answer["document"]["standing"]["forces"]
    assert 3.0 * moment == pytest.approx(forces["input_torque_Nm"] + forces["output_torque_Nm"])


@pytest.mark.parametrize(
    ("key", "value", "said"),
    [
        ("load.output_torque", "5 mm", "expected a torque"),
        ("load.output_torque", "", "expected a torque"),
        ("surface.fractal_dimension", 2.5, "must be above 1 and below 2"),
        ("drive.planets", 2.5, "a whole number"),
        ("model.closure", "soft", "is not one of"),
        ("bodies.sun", "nowhere", "there is no material"),
    ],
)
def test_a_wrong_value_is_said_at_its_key(solve, key, value, said):
    response = solve(**{key: value})
    assert response.status_code == 422
    answer = response.json()
    assert said in answer["keys"][key]
    assert answer["error"].startswith("my.toml: ")


@pytest.mark.slow
def test_an_impossible_joint_is_said_in_one_sentence(solve):
    response = solve(load__output_torque="50 N*m")
    assert response.status_code == 422
    assert "beyond the standing torque capacity 13.16 N·m" in response.json()["error"]


@pytest.mark.parametrize(
    "body",
    [
        b"{",
        b"[]",
        b"[" * 100_000,
        b'{"toml": 3}',
        b'{"toml": "", "joint": {}}',
        b'{"toml": "x = 1", "other": 1}',
        b'{"toml": "x = 1", "changes": {"load.preload": NaN}}',
        b'{"toml": "x = 1", "changes": {"load.preload": true}}',
        b'{"toml": "x = 1", "changes": {"load": "5 N"}}',
        b'{"joint": {"load": 3}, "changes": {"load.preload": "5 N"}}',
        b'{"joint": {"bodies": 3}, "changes": {"bodies.sun": "steel"}}',
        b'{"joint": {"surface": [1]}, "changes": {"surface.sp.fractal_dimension": 1.5}}',
    ],
)
def test_bodies_that_make_no_sense_get_one_sentence(client, body):
    response = client.post("/api/joint", content=body, headers={"content-type": "application/json"})
    assert response.status_code == 422
    assert response.json()["error"]


def test_forms_of_other_sites_have_the_wrong_type(client, joint_text):
    for path in ("/api/joint", "/api/chart", "/api/file", "/api/open", "/api/jobs"):
        for kind in ("text/plain", "application/x-www-form-urlencoded", "multipart/form-data; boundary=x"):
            response = client.post(path, content=b"{}", headers={"content-type": kind})
            assert response.status_code == 415


@pytest.mark.parametrize("place", ["toml", "joint", "file"])
def test_a_request_opens_no_file(client, joint_text, tmp_path, place):
    library = tmp_path / "library.toml"
    library.write_text("secret = 1")
    text = joint_text + f'\n[materials.other]\nlibrary = "x"\nfile = "{library}"\n'
    if place == "file":
        response = client.post(
            "/api/file", content=text.encode(), headers={"content-type": "application/octet-stream"}
        )
    else:
        import tomllib

        body = {"toml": text} if place == "toml" else {"joint": tomllib.loads(text)}
        response = client.post("/api/joint", json=body)
    assert response.status_code == 422
    assert "the page opens no other files" in response.json()["error"]
    assert "secret" not in response.text


@pytest.mark.parametrize(
    "path",
    [
        "/../pyproject.toml",
        "/static/page.html",
        "/%2e%2e/%2e%2e/etc/passwd",
        "/page.html",
        "/answer.py",
        "//etc/passwd",
    ],
)
def test_only_the_table_of_assets_is_served(client, path):
    assert client.get(path).status_code == 404


def test_every_asset_is_there_and_nothing_is_inline(client):
    for path, (_, kind) in ASSETS.items():
        response = client.get(path)
        assert response.status_code == 200
        assert response.headers["content-type"] == kind
        assert "http://" not in response.text.replace("http://www.w3.org/2000/svg", "")
        assert "https://" not in response.text
    page = client.get("/").text
    assert " style=" not in page
    assert " onclick=" not in page
    assert page.count("<script") == page.count('<script type="module" src="/')


def test_a_file_is_checked(client, joint_text):
    kind = {"content-type": "application/octet-stream"}
    good = client.post("/api/file?name=a.toml", content=joint_text.encode(), headers=kind).json()
    assert good["toml"] == joint_text
    assert good["numbers"]["drive.sun_radius"]["value"] == 4.0
    image = client.post("/api/file?name=a.png", content=b"\x89PNG\r\n\x1a\n\xff", headers=kind)
    assert "a.png: this is not a text file" in image.json()["error"]
    table = client.post("/api/file?name=a.csv", content=b"x,y\n1,2\n", headers=kind)
    assert table.status_code == 422
    assert table.json()["error"].startswith("a.csv: ")
    short = joint_text.replace('sun_radius = "4 mm"', "")
    missing = client.post("/api/file?name=b.toml", content=short.encode(), headers=kind).json()
    assert "sun_radius" in missing["error"]


@pytest.mark.long
def test_downloads_say_the_same_again(client, solve, joint_text):
    answer = solve(load__preload="1200 N", bodies__sun="52100", model__closure="constant_pin_force").json()
    text = client.get(f"/api/joint/{answer['id']}/joint.toml")
    assert text.headers["content-disposition"] == 'attachment; filename="my.toml"'
    assert "# ours: normal force between sun and planet without torque" in text.text  # comments stay
    again = client.post("/api/joint", json={"toml": text.text, "name": "my.toml"}).json()
    assert again["document"] == answer["document"]
    document = client.get(f"/api/joint/{answer['id']}/joint.json")
    assert document.json() == answer["document"]
    assert client.get("/api/joint/0123/joint.toml").status_code == 404
    assert client.get(f"/api/joint/{answer['id']}/joint.py").status_code == 404


@pytest.mark.long
def test_the_report_is_that_of_the_joint(client, solve):
    answer = solve(load__preload="1100 N").json()
    report = client.get(f"/api/joint/{answer['id']}/joint.html")
    assert report.status_code == 200
    assert report.headers["content-disposition"] == 'attachment; filename="my.html"'
    stiffness = answer["document"]["torsional_stiffness"]["assembly"]["output_Nm_per_arcmin"]
    assert f"{stiffness:.3f}" in report.text
    assert "1100 N" in report.text


@pytest.mark.slow
def test_a_pdf_without_its_package_says_how_to_get_it(client, solve, monkeypatch):
    import sys

    answer = solve().json()
    monkeypatch.setitem(sys.modules, "typst", None)
    response = client.get(f"/api/joint/{answer['id']}/joint.pdf")
    assert response.status_code == 422
    assert "typst" in response.json()["error"]
    assert "[report]" in response.json()["error"]


def test_what_is_always_the_same_is_made_once(monkeypatch, joint_text):
    """A client that asks for it again and again, without waiting, kept others waiting for half a minute."""
    made = []
    for name in ("joint_schema", "openapi", "_asset", "JSONResponse"):
        whole = getattr(application_module, name)
        monkeypatch.setattr(
            application_module,
            name,
            lambda *given, whole=whole, name=name: made.append(name) or whole(*given),
        )
    idle = Computations(longest=600.0), Computations(longest=600.0)
    start = JointRequest(name="zou2025.toml", text=joint_text)
    app = application(start, hosts=[HOST], computations=idle[0], charts=idle[1])
    asking = TestClient(
        app, base_url=f"http://{HOST}"
    )  # without what runs from the start to the end of a server
    paths = ["/api/schema", "/openapi.json", "/api/description", "/", "/main.js"]
    answers = [[asking.get(path) for path in paths] for _ in range(3)]
    assert all(answer.status_code == 200 for each in answers for answer in each)
    assert [answer.content for answer in answers[0]] == [answer.content for answer in answers[2]]
    assert answers[0][0].json() == joint_schema()
    assert sorted(made) == ["JSONResponse"] * 3 + ["_asset"] * 2 + ["joint_schema", "openapi"]


def test_the_description_covers_every_number_of_the_file(client, joint_text):
    described = client.get("/api/description").json()
    keys = {each["key"]: each for group in described["groups"] for each in group["parameters"]}
    for path in described["start"]["numbers"]:
        parts = path.split(".")
        generic = ".".join(
            [parts[0], "*", *parts[2:]] if parts[0] in ("materials", "duty", "branch") else parts
        )
        assert keys[generic]["meaning"]
        assert keys[generic]["unit"]
    assert keys["compliance.output_shaft_stiffness"]["default"] == "rigid if absent"
    assert keys["rolling.reliability"]["default"] == "0.9 if absent"
    assert keys["materials.*.youngs_modulus"]["meaning"] == "Young's modulus E."
    assert keys["drive.sun_radius"]["required"]
    ring = next(each for each in described["choices"] if each["key"] == "drive.ring_support")
    assert ring["default"] == "a rigid housing if absent"
    assert not ring["required"]
    assert "slip_ratio_sp" in {
        each["name"] for each in client.post("/api/results", json={"toml": joint_text}).json()
    }
    assert not keys["load.preload"]["required"]  # an interference can take its place
    sections = {group["name"] for group in described["groups"]} | {
        each["group"] for each in described["choices"]
    }
    # the kind of drive is no section
    assert sections == set(DefaultCase.model_fields) - {"type"}


def test_a_chart_that_cannot_be_drawn_is_said_at_its_key(client, joint_text):
    chart = {"over": "load.preload", "from": "5 mm", "to": "1 kN", "result": "slip_ratio_sp"}
    response = client.post("/api/chart", json={"toml": joint_text, "chart": chart})
    assert response.status_code == 422
    assert "expected a force" in response.json()["keys"]["load.preload"]


@pytest.mark.parametrize("path", ["/api/joint", "/api/chart", "/api/results"])
def test_an_error_of_the_joint_has_its_key_at_every_address(client, joint_text, path):
    chart = {"over": "load.preload", "from": "1 N", "to": "1 kN", "result": "slip_ratio_sp"}
    body = {"toml": joint_text.replace('"1000 N"', '"1000 mm"'), "name": "mine.toml"}
    assert body["toml"] != joint_text
    answer = client.post(path, json=body | ({"chart": chart} if path == "/api/chart" else {}))
    assert answer.status_code == 422
    assert answer.json()["error"].startswith("mine.toml: load.preload: expected a force")
    assert list(answer.json()["keys"]) == ["load.preload"]


@pytest.mark.parametrize("path", ["/api/joint", "/api/chart", "/api/results"])
def test_nobody_waits_for_the_file_of_another(client, joint_text, monkeypatch, path):
    """A large file is still being read, three times over, when a small one gets its answer."""
    begun, going, read = threading.Semaphore(0), threading.Event(), joint_request.parse_toml

    def slow(text, *, source):
        if source == "large.toml":
            begun.release()
            going.wait(20.0)
        return read(text, source=source)

    monkeypatch.setattr(joint_request, "parse_toml", slow)
    chart = {"over": "load.preload", "from": "1 N", "to": "1 kN", "result": "slip_ratio_sp"}
    body = {"toml": f"x = 1\n{joint_text}"} | ({"chart": chart} if path == "/api/chart" else {})
    with ThreadPoolExecutor(3) as others:
        large = [others.submit(client.post, path, json=body | {"name": "large.toml"}) for _ in range(3)]
        try:
            assert all(begun.acquire(timeout=10.0) for _ in large)
            answer = client.post(path, json=body | {"name": "small.toml"})
            assert not any(each.done() for each in large)
        finally:
            going.set()
        assert answer.json()["error"].startswith("small.toml: x: unknown key")
        assert [each.result().status_code for each in large] == [422, 422, 422]


@pytest.mark.slow
def test_the_interface_describes_its_answers(client, solve, described_as, joint_text):
    answer, kind = solve().json(), {"content-type": "application/toml"}
    assert described_as("Answer", answer) == set()
    assert described_as("Curves", answer["curves"]) == set()
    assert described_as("Windup", answer["windup"]) == set()
    assert described_as("Error", solve(load__preload="x").json()) == set()
    one, other = ({"toml": joint_text.replace('"5 N*m"', torque)} for torque in ('"5 N*m"', '"4 N*m"'))
    compared = client.post("/api/compare", json={"one": one, "other": other}).json()
    assert described_as("Comparison", compared) == set()
    assert (
        described_as("File", client.post("/api/file", content=joint_text.encode(), headers=kind).json())
        == set()
    )
    assert (
        described_as("ResultOfChart", client.post("/api/results", json={"toml": joint_text}).json()[0])
        == set()
    )
