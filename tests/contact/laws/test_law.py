"""What a contact law states, and what happens to one that does not."""

import math
from typing import ClassVar

import pytest

from asperity.contact.laws.by_decay_length import ByDecayLength
from asperity.contact.laws.exponential import Exponential
from asperity.contact.laws.law import ContactLaw
from asperity.contact.laws.zou_2025 import Zou2025

STATED = {
    "name": "rival",
    "rank": 1,
    "meaning": "a rival",
    "assumes": (),
    "needs": ("fractal_dimension",),
    "needs_words": "D",
    "default_for": (),
    "from_measurement": "nothing",
    "slip_exponent": 0.5,
    "has_spots": False,
    "over_boundary_elements": (0.5, 2.0),
    "error": "none",
    "of_surface": classmethod(lambda cls, numbers, *, asperity_base: cls()),
    "rough_contact": lambda self, rollers: None,
}


@pytest.mark.parametrize("name", list(STATED))
def test_a_law_states_everything(name):
    assert type("Rival", (ContactLaw,), dict(STATED)).name == "rival"
    with pytest.raises(TypeError, match=rf"test_law.*the contact law Rival does not state {name} \("):
        type("Rival", (ContactLaw,), {key: value for key, value in STATED.items() if key != name})


@pytest.mark.parametrize(
    ("changed", "lacks"),
    [
        ({"needs": ("rms_height",)}, r"softer \("),
        ({"needs": ("decay_length",)}, r"softer \("),
        ({"from_measurement": "heights", "needs": ("rms_height",)}, r"decay_ratios \("),
        ({"from_measurement": "decay_length", "needs": ("decay_length",)}, r"decay_ratios \("),
    ],
)
def test_what_follows_from_what_it_takes(changed, lacks):
    with pytest.raises(TypeError, match=lacks):
        type("Rival", (ContactLaw,), STATED | changed)


def test_a_measurement_gives_what_the_law_needs():
    changed = {"from_measurement": "fractal", "needs": ("fractal_dimension", "skewness")}
    said = "Rival needs fractal_dimension, skewness, while from_measurement = 'fractal' gives"
    with pytest.raises(TypeError, match=said):
        type("Rival", (ContactLaw,), STATED | changed)


def test_sentences_and_keys_are_tuples():
    with pytest.raises(TypeError, match="Rival states assumes, which is a tuple, in another way"):
        type("Rival", (ContactLaw,), STATED | {"assumes": "one sentence"})


def test_all_that_is_missing_is_one_message():
    with pytest.raises(TypeError, match=r"name .*rank .*slip_exponent .*rough_contact"):
        type("Rival", (ContactLaw,), {})


def test_what_laws_share_counts_for_each():
    """Only what is not shared is missing, and what is shared is no law itself."""
    assert ByDecayLength.abstract
    assert not Exponential.abstract

    class Shared(ContactLaw, abstract=True):
        slip_exponent: ClassVar[float] = 1.0

    with pytest.raises(TypeError) as caught:
        type("Rival", (Shared,), {})
    assert "slip_exponent" not in str(caught.value)


def test_numbers_by_their_names():
    fractal = Zou2025(1.4, 1e-11, 1.5, "majumdar_bhushan_1991")
    assert fractal.number("fractal_dimension") == 1.4
    assert math.isnan(fractal.number("decay_length"))
    assert math.isnan(Exponential(1e-7).number("fractal_dimension"))
    other = fractal.with_numbers(fractal_dimension=1.5)
    assert (other.fractal_dimension, other.fractal_roughness, other.asperity_base) == (
        1.5,
        1e-11,
        "majumdar_bhushan_1991",
    )
