"""A contributor adds a rival contact law: one file, and everything knows it; a law that lacks something is refused."""

import json
import tomllib
from pathlib import Path

import jsonschema
import pytest
from package_copy import changed_files, package_copy, run, run_python

EXAMPLE = Path(__file__).parents[2] / "examples" / "planetary.toml"
LAW = '''\
"""Greenwood and Williamson 1966 with summits whose heights fall off exponentially: K_n = N/h."""

from asperity.contact.exponential import RandomRoughness, random_contact
from asperity.contact.laws.law import ContactLaw
from asperity.types import Real


class Greenwood1966(ContactLaw):
    """Exponentially distributed summits."""

    rms_height: Real

    name = "greenwood_1966"
    rank = 15
    meaning = "spherical summits with exponentially distributed heights"
    assumes = ("contact law greenwood_1966: summits with exponentially distributed heights, K_n = N/h",)
    needs = ("rms_height",)
    needs_words = "the rms of the heights"
    default_for = ()
    from_measurement = "nothing"
    slip_exponent = 0.5
    has_spots = False
    over_boundary_elements = (0.2, 1.5)
    error = "The law is 0.2 to 1.5 times as stiff as boundary elements in a test."

    @classmethod
    def of_surface(cls, numbers, *, asperity_base):
        return cls(numbers["rms_height"])

    def rough_contact(self, rollers):
        return random_contact(
            roughness=RandomRoughness(self.rms_height),
            normal_force=rollers.normal_force,
            tangential_force=rollers.tangential_force,
            friction_coefficient=rollers.friction_coefficient,
            contact_modulus=rollers.moduli.contact_modulus,
            tangential_contact_modulus=rollers.moduli.tangential_contact_modulus,
            contact_length=rollers.contact_length,
        )

    def softer(self, factor):
        return self.with_numbers(rms_height=factor * self.rms_height)
'''
SURFACES = {
    "heights": 'rms_height = "0.2 um"',
    "average": 'roughness_average = "0.2 um"\nfractal_dimension = 1.4\nfrequency_ratio = 1.5',
    "fractal": 'fractal_roughness = "1e-8 mm"\nfractal_dimension = 1.4\nfrequency_ratio = 1.5',
}
#: What the law of the joint in a file is to its contacts.
CODE = """
import sys
from asperity.joint.contacts import rough_joint_contacts
from asperity.joint.description import joint_contacts
from asperity.joint_file.reader import read_case
from asperity.joint_file.solved_document import solved_case
for name in sys.argv[1:]:
    solved = solved_case(read_case(name))
    print(type(solved.joint.surfaces[0]).__name__, solved.laws.slip_exponent)
import jax
from asperity.precision import use_double_precision
use_double_precision()
forces = solved.result.forces
state = {"normal_force": forces.normal, "tangential_force": forces.tangential}
contacts = joint_contacts(solved.joint)
by_numpy = rough_joint_contacts(contacts=contacts, **state).normal_stiffness
by_jax = jax.jit(lambda contacts, state: rough_joint_contacts(contacts=contacts, **state))(contacts, state)
print(max(abs(by_jax.normal_stiffness / by_numpy - 1.0)) < 1e-12)
"""


@pytest.fixture(scope="module")
def copy(tmp_path_factory):
    """The copy with the law, and joint files with and without it."""
    folder = package_copy(tmp_path_factory.mktemp("new_law"))
    (folder / "asperity/contact/laws/greenwood_1966.py").write_text(LAW, encoding="utf-8")
    text = EXAMPLE.read_text(encoding="utf-8")
    before, _, rest = text.partition("[surface]\n")
    after = "".join(rest.partition("\n[")[1:])
    assert "contact_law" not in text
    for name, surface in SURFACES.items():
        plain = f"{before}[surface]\n{surface}\n{after}"
        (folder / f"{name}.toml").write_text(plain, encoding="utf-8")
        asked = plain.replace("[model]\n", '[model]\ncontact_law = "greenwood_1966"\n')
        (folder / f"{name}_by_it.toml").write_text(asked, encoding="utf-8")
    return folder


def document(copy, name):
    done = run(copy, "joint", f"{name}.toml", "--json")
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def test_it_is_one_file(copy):
    assert changed_files(copy) == {"contact/laws/greenwood_1966.py"}


@pytest.mark.slow
def test_a_joint_has_it(copy):
    """Its sentence, its place and its range side by side; as stiff as the exponential law on heights of 1/0.48."""
    found, plain = document(copy, "heights_by_it"), document(copy, "heights")
    assert [told for told in found["assumptions"] if told.startswith("contact law")] == [
        "contact law greenwood_1966: summits with exponentially distributed heights, K_n = N/h"
    ]
    for one, used in ((found, "greenwood_1966"), (plain, "exponential")):
        laws = {entry["law"]: entry for entry in one["contact_laws"]}
        assert list(laws) == ["greenwood_1966", "exponential"]
        assert [law for law, entry in laws.items() if entry["used"]] == [used]
        assert laws["greenwood_1966"]["over_boundary_elements"] == [0.2, 1.5]
    by_file, beside = (
        next(entry for entry in one["contact_laws"] if entry["law"] == "greenwood_1966")
        for one in (found, plain)
    )
    assert by_file["assembly_Nm_per_rad"] == pytest.approx(beside["assembly_Nm_per_rad"], rel=1e-9)
    scaled = (copy / "heights.toml").read_text(encoding="utf-8").replace('"0.2 um"', f'"{0.2 / 0.48!r} um"')
    (copy / "scaled.toml").write_text(scaled, encoding="utf-8")
    here, there = (
        one["standing"]["contacts"]["sp"]["asperity_normal_stiffness_N_per_m"]
        for one in (found, document(copy, "scaled"))
    )
    assert here == pytest.approx(there, rel=1e-3)  # the slip exponents differ


@pytest.mark.slow
def test_its_interval_holds_its_error(copy):
    """K_n goes with 1/h in the nearly rigid contact: the ends by the law alone are 0.2 and 1.5 times as compliant."""
    interval = document(copy, "heights_by_it")["stiffness_interval"]
    assert "0.2 to 1.5 times as stiff as boundary elements in a test" in interval["words"]
    low, high = interval["contacts"]["sp"]["asperity_normal_stiffness_N_per_m"]["contact_law"]
    assert 1.5 / 0.2 * 0.9 < high / low < 2.0 * 1.5 / 0.2


@pytest.mark.slow
def test_its_slip_exponent_by_both_engines_and_the_words_of_the_command(copy):
    names = [f"{name}.toml" for name in ("heights", "heights_by_it", "average_by_it")]
    done = run_python(copy, CODE, *names)
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines() == [
        "Exponential 1.0",
        "Greenwood1966 0.5",
        "Greenwood1966 0.5",
        "True",
    ]
    shown = run(copy, "joint", "average_by_it.toml", "--all")
    assert shown.returncode == 0, shown.stderr
    assert "Contact laws side by side" in shown.stdout
    rows = [line.split() for line in shown.stdout.splitlines() if "0.2 to 1.5" in line]
    assert rows[0][0] == "greenwood_1966"
    assert "used here" in next(line for line in shown.stdout.splitlines() if "0.2 to 1.5" in line)


def test_a_file_that_does_not_state_what_it_needs_is_refused_with_the_remedy(copy):
    done = run(copy, "joint", "fractal_by_it.toml")
    assert done.returncode == 2
    assert 'model.contact_law = "greenwood_1966" needs the rms of the heights' in done.stderr
    assert 'state "zou_2025"' in done.stderr
    assert done.stderr.count("\n") == 1


def test_it_is_in_the_schema(copy):
    done = run(copy, "schema", "--type", "planetary")
    assert done.returncode == 0, done.stderr
    assert '"greenwood_1966"' in done.stdout
    assert "greenwood_1966, spherical summits with exponentially distributed heights" in done.stdout


def test_a_law_that_does_not_state_all_fails_when_it_is_imported(tmp_path):
    """What a law may lack is tested with the law itself: here the words that the contributor reads."""
    line = "    slip_exponent = 0.5\n"
    lacks = "slip_exponent (the exponent of its tangential stiffness)"
    folder = package_copy(tmp_path)
    assert line in LAW
    file = folder / "asperity/contact/laws/greenwood_1966.py"
    file.write_text(LAW.replace(line, ""), encoding="utf-8")
    done = run_python(folder, "import asperity.joint_file.reader")
    assert done.returncode != 0
    *_, last = done.stderr.strip().splitlines()
    assert last.startswith(f"TypeError: {file}: the contact law Greenwood1966 does not state {lacks}")


KEY = """
    keys = (
        SurfaceKey(
            "summit_share", "Summits' heights over all heights.", "dimensionless", "1", 0.1, 1.0, "0.7"
        ),
    )
"""
#: The same law of a number that no other takes, which it states itself.
WITH_KEY = (
    LAW.replace("import ContactLaw\n", "import ContactLaw, SurfaceKey\n")
    .replace('needs = ("rms_height",)\n', 'needs = ("rms_height", "summit_share")\n' + KEY)
    .replace('cls(numbers["rms_height"])', 'cls(numbers["rms_height"] * numbers["summit_share"])')
)


@pytest.fixture(scope="module")
def with_key(copy, tmp_path_factory):
    """A copy with the law that states a key, and joint files with and without it."""
    folder = package_copy(tmp_path_factory.mktemp("law_with_key"))
    (folder / "asperity/contact/laws/greenwood_1966.py").write_text(WITH_KEY, encoding="utf-8")
    text = (copy / "heights_by_it.toml").read_text(encoding="utf-8")
    for name, surface in {
        "key": 'rms_height = "0.2 um"\nsummit_share = 0.7',
        "lacking": 'rms_height = "0.2 um"',
        "alone": "summit_share = 0.7",
        "beyond": 'rms_height = "0.2 um"\nsummit_share = 7',
    }.items():
        changed = text.replace('rms_height = "0.2 um"', surface)
        (folder / f"{name}.toml").write_text(changed, encoding="utf-8")
    return folder


@pytest.mark.slow
def test_a_key_of_the_law_itself(copy, with_key):
    """0.7 of the heights by the law that has no such key; the exponential law on the same file has all of them."""
    assert changed_files(with_key) == {"contact/laws/greenwood_1966.py"}
    found = document(with_key, "key")
    smoother = (copy / "heights_by_it.toml").read_text(encoding="utf-8").replace('"0.2 um"', '"0.14 um"')
    (copy / "smoother.toml").write_text(smoother, encoding="utf-8")
    same = document(copy, "smoother")
    for one in ("low_Nm_per_rad", "high_Nm_per_rad"):
        ends = [document["stiffness_interval"]["assembly"][one] for document in (found, same)]
        assert ends[0] == pytest.approx(ends[1], rel=1e-9)
    stiffness = [
        document["torsional_stiffness"]["assembly"]["output_Nm_per_rad"] for document in (found, same)
    ]
    assert stiffness[0] == pytest.approx(stiffness[1], rel=1e-9)
    assert [entry["law"] for entry in found["contact_laws"]] == ["greenwood_1966", "exponential"]
    assert found["input"]["surface"]["summit_share"] == 0.7
    schema = json.loads(run(with_key, "schema", "--type", "planetary").stdout)
    entry = schema["$defs"]["SurfaceEntry"]["properties"]["summit_share"]
    assert entry["description"] == "Summits' heights over all heights."


@pytest.mark.parametrize(
    ("name", "said"),
    [
        (
            "lacking",
            'while surfaces state rms_height: leave contact_law out, state "exponential", or give rms_height, '
            "summit_share of all contacts; roughness_average stands for rms_height",
        ),
        (
            "alone",
            "surface.summit_share: the contact law greenwood_1966 takes it with rms_height, summit_share: give",
        ),
        ("beyond", "surface.summit_share: 7 is not allowed; it must be at least 0.1 and at most 1"),
    ],
)
def test_a_key_that_is_missing_or_out_of_its_range(with_key, name, said):
    done = run(with_key, "joint", f"{name}.toml")
    assert done.returncode == 2
    assert said in done.stderr


@pytest.mark.slow
def test_a_surface_of_nothing_but_the_laws_own_number(tmp_path, copy):
    """Such a file states the law; drawing and schema take it, and another law is refused."""
    folder = package_copy(tmp_path)
    alone = WITH_KEY.replace('("rms_height", "summit_share")', '("summit_share",)')
    alone = alone.replace('numbers["rms_height"] * ', "2e-7 * ")
    (folder / "asperity/contact/laws/greenwood_1966.py").write_text(alone, encoding="utf-8")
    text = (copy / "heights_by_it.toml").read_text(encoding="utf-8")
    text = text.replace('rms_height = "0.2 um"', "summit_share = 0.7")
    for name, law in {"by_it": "greenwood_1966", "by_another": "exponential", "by_none": None}.items():
        line = "" if law is None else f'contact_law = "{law}"\n'
        changed = text.replace('contact_law = "greenwood_1966"\n', line)
        (folder / f"{name}.toml").write_text(changed, encoding="utf-8")
    found = document(folder, "by_it")
    assert found["torsional_stiffness"]["assembly"]["output_Nm_per_rad"] > 0.0
    drawn = run(folder, "draw", "by_it.toml", "--parts", "--out", "drive.pdf")
    assert drawn.returncode == 0, drawn.stderr
    schema = json.loads(run(folder, "schema", "--type", "planetary").stdout)
    jsonschema.validate(tomllib.loads((folder / "by_it.toml").read_text(encoding="utf-8")), schema)
    none, another = (run(folder, "joint", f"{name}.toml").stderr for name in ("by_none", "by_another"))
    assert 'surfaces by summit_share: state model.contact_law = "greenwood_1966"' in none
    assert 'surfaces state summit_share: state "greenwood_1966", or give rms_height' in another


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('"dimensionless"', '"furlong"', "states surface.summit_share of the dimension 'furlong'; known are"),
        (
            '"dimensionless", "1"',
            '"length", "kg"',
            "states surface.summit_share, a length, in 'kg', which is no unit",
        ),
        (KEY, "", "takes summit_share, which is no key of [surface]: state it in its keys"),
    ],
)
def test_a_key_that_is_none_fails_when_it_is_imported(tmp_path, old, new, said):
    folder = package_copy(tmp_path)
    file = folder / "asperity/contact/laws/greenwood_1966.py"
    assert old in WITH_KEY
    file.write_text(WITH_KEY.replace(old, new), encoding="utf-8")
    *_, last = run_python(folder, "import asperity.joint_file.reader").stderr.strip().splitlines()
    assert last.startswith(f"TypeError: {file}: the contact law greenwood_1966 {said}")
