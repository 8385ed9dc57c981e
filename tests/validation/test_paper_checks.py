"""The checks of roughness and units pass, and find a number that is off."""

import dataclasses

from asperity.validation import paper_checks


def test_units_are_those_of_the_si(monkeypatch):
    (check,) = paper_checks.units()
    assert check.passed
    assert check.values == 7
    honest = paper_checks.parse_quantity
    monkeypatch.setattr(paper_checks, "parse_quantity", lambda *args: honest(*args) * (1.0 + 1e-14))
    (check,) = paper_checks.units()
    assert not check.passed


def test_height_parameters_of_a_sine(monkeypatch):
    assert [check.passed for check in paper_checks.roughness()] == [True, True, True]
    honest = paper_checks.height_parameters

    def off(**given):
        found = honest(**given)
        return dataclasses.replace(
            found, total_height=1.001 * found.total_height, kurtosis=found.kurtosis + 1e-3
        )

    monkeypatch.setattr(paper_checks, "height_parameters", off)
    assert [check.passed for check in paper_checks.roughness()] == [False, False, True]


def test_roughness_behind_a_filter(monkeypatch):
    honest = paper_checks.roughness_parameters
    monkeypatch.setattr(
        paper_checks, "roughness_parameters", lambda **given: honest(**(given | {"cut_off": 0.802e-3}))
    )
    assert [check.passed for check in paper_checks.roughness()] == [True, True, False]
