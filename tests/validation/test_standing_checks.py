"""The checks of vibration, wind-up and exported models pass, and find what is off."""

import dataclasses

import pytest

from asperity.validation import standing_checks as checks


def test_what_is_right_passes():
    assert [
        check for group in (checks.windup, checks.vibrations) for check in group() if not check.passed
    ] == []


@pytest.mark.parametrize("name", ["hysteresis", "dissipated_energy", "stage_stiffness"])
def test_a_figure_of_the_windup_that_is_off_is_found(monkeypatch, name):
    honest = checks.windup_of

    def off(*given, **named):
        curve = honest(*given, **named)
        return dataclasses.replace(curve, **{name: 1.001 * getattr(curve, name)})

    monkeypatch.setattr(checks, "windup_of", off)
    assert sum(not check.passed for check in checks.windup()) == 1


@pytest.mark.parametrize(
    ("name", "part", "failing"),
    [
        ("parallel_elements", "stiffness", "Exported elements, MuJoCo and Modelica"),
        ("slip_elements", "compliance", "Exported elements, FMU"),
    ],
)
def test_exported_elements_that_are_off_are_found(monkeypatch, name, part, failing):
    honest = getattr(checks, name)

    def off(*given, **named):
        made = honest(*given, **named)
        return dataclasses.replace(made, **{part: 1.5 * getattr(made, part)})

    monkeypatch.setattr(checks, name, off)
    assert [check.model for check in checks.windup() if not check.passed] == [failing]


@pytest.mark.parametrize("name", ["locked", "free"])
def test_a_frequency_that_is_off_is_found(monkeypatch, name):
    honest = checks.natural_frequencies

    def off(joint):
        found = honest(joint)
        return found._replace(**{name: 1.001 * getattr(found, name)})

    monkeypatch.setattr(checks, "natural_frequencies", off)
    assert [check.passed for check in checks.vibrations()] == [False, True]
