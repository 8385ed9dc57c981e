"""Every contact law: what it states against what it does, and against the joint file and the manual."""

import re
from pathlib import Path

import numpy as np
import pytest

from asperity.contact.laws import registry
from asperity.contact.laws.law import ContactLaw, PressedRollers
from asperity.contact.laws.registry import LAWS, law_for
from asperity.joint_file.material_entries import SurfaceEntry
from asperity.materials import Material, pair

FOLDER = Path(registry.__file__).parent
VALIDITY = Path(__file__).parents[3] / "docs" / "validity.md"
STEEL = Material(206e9, 0.3, 7850.0, 450e6, 1260e6)
#: Numbers of a ground surface, by every key that a law may need.
NUMBERS = {
    "fractal_dimension": 1.4,
    "fractal_roughness": 1e-11,
    "frequency_ratio": 1.5,
    "rms_height": 2e-7,
    "decay_length": 1e-7,
}
every_law = pytest.mark.parametrize("law", LAWS.values(), ids=LAWS.keys())
#: Laws whose interval holds their error, by the same surface with asperities that yield more.
SOFTENED = [law for law in LAWS.values() if {"rms_height", "decay_length"} & set(law.needs)]


def on_surface(law: type[ContactLaw]) -> ContactLaw:
    numbers = {key: NUMBERS[key] for key in law.needs}
    return law.of_surface(numbers, asperity_base="majumdar_bhushan_1991")


def pressed(surface, normal, tangential=0.0):
    return surface.rough_contact(
        PressedRollers(
            normal_force=np.asarray(normal, dtype=float),
            tangential_force=np.asarray(tangential, dtype=float),
            friction_coefficient=0.1,
            moduli=pair(STEEL, STEEL),
            contact_length=5e-3,
            effective_radius=7e-3,
            contact_factor=1.0,
        )
    )


@every_law
def test_a_law_is_found_by_the_name_of_its_file(law):
    assert (FOLDER / f"{law.name}.py").is_file()
    assert LAWS[law.name] is law


def test_laws_stand_from_the_one_that_knows_least():
    assert list(LAWS) == ["zou_2025", "exponential", "persson_2007", "measured"]
    assert [law.rank for law in LAWS.values()] == sorted(law.rank for law in LAWS.values())


@every_law
def test_what_a_law_needs_are_keys_of_the_file(law):
    assert {*law.needs, *law.default_for} <= SurfaceEntry.model_fields.keys()


def test_each_key_has_one_law_of_files_that_state_none():
    keys = [key for law in LAWS.values() for key in law.default_for]
    assert len(keys) == len(set(keys))
    assert law_for("measurement") is LAWS["exponential"]
    assert law_for("decay_length") is LAWS["measured"]


@every_law
def test_the_tangential_stiffness_has_the_stated_exponent(law):
    """K_t(T)/K_t(0) = (1 - T/(mu N))^n up to gross slip, of the law's own formula."""
    surface, share = on_surface(law), np.array([0.0, 0.3, 0.7, 0.95])
    found = pressed(surface, 1000.0, 0.1 * 1000.0 * share).tangential_stiffness
    np.testing.assert_allclose(found / found[0], (1.0 - share) ** law.slip_exponent, rtol=1e-9)
    assert float(pressed(surface, 1000.0, 100.0).tangential_stiffness) == 0.0


@every_law
def test_a_contact_stiffens_with_its_load_and_an_open_one_has_no_stiffness(law):
    surface = on_surface(law)
    stiffness = pressed(surface, [0.0, 10.0, 100.0, 1000.0]).normal_stiffness
    assert stiffness[0] == 0.0
    assert np.all(np.diff(stiffness) > 0.0)


@every_law
def test_spots_are_known_where_the_law_says_so(law):
    found = pressed(on_surface(law), 1000.0)
    for name in ("largest_area", "critical_area", "real_contact_area"):
        assert np.isfinite(getattr(found, name)) == law.has_spots


@pytest.mark.parametrize("law", SOFTENED, ids=lambda law: law.name)
def test_a_softer_surface_yields_as_many_times_as_much(law):
    """Of the layer, which has no part in the widening of the contact."""
    surface = on_surface(law)
    ratio = pressed(surface, 500.0).layer_stiffness / pressed(surface.softer(2.5), 500.0).layer_stiffness
    assert float(ratio) == pytest.approx(2.5, rel=1e-12)


@every_law
def test_its_range_is_that_of_the_manual(law):
    low, high = law.over_boundary_elements
    assert 0.0 < low < high
    ends = rf"(?<![\d.]){low:g}(?: to |–){high:g}(?![\d])"
    assert re.search(ends, VALIDITY.read_text(encoding="utf-8")), ends


def test_a_law_in_a_file_of_another_name_is_refused(monkeypatch):
    law = LAWS["exponential"]
    monkeypatch.setattr(law, "name", "exponential_2")
    with pytest.raises(
        TypeError, match=r"exponential\.py: the contact law exponential_2 stands in a file that"
    ):
        registry._by_name()


def test_two_laws_of_one_key_are_refused(monkeypatch):
    monkeypatch.setattr(LAWS["persson_2007"], "default_for", ("rms_height",))
    with pytest.raises(
        TypeError, match=r"persson_2007\.py: files with rms_height have the contact law exponential"
    ):
        registry._by_name()
