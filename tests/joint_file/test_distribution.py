"""Distributions are stated behind a tolerance, and never guessed."""

import math

import pytest

from asperity.errors import InputError
from asperity.joint_file.limits import ROLLER_RADIUS
from asperity.joint_file.quantity_key import Distribution, parse_distribution, split_distribution


def test_forms():
    assert parse_distribution("Uniform") == Distribution("uniform", 0.0)
    assert parse_distribution("triangular") == Distribution("triangular", 0.0)
    assert parse_distribution("normal 2.5 sigma") == Distribution("normal", 2.5)
    assert parse_distribution("normal 10 sigma").sigmas == 10.0
    assert str(parse_distribution("normal  3  sigma")) == "normal 3 sigma"


@pytest.mark.parametrize(
    "text", ["", "normal", "gauss", "normal 0 sigma", "normal 10.1 sigma", "normal -2 sigma", "uniform 2"]
)
def test_other_words_are_refused(text):
    with pytest.raises(InputError):
        parse_distribution(text)


def test_standard_deviations():
    # variances of the uniform and the symmetric triangular distribution of half-width t: t^2/3 and t^2/6
    assert parse_distribution("uniform").standard_deviation(3.0) == pytest.approx(math.sqrt(3.0))
    assert parse_distribution("triangular").standard_deviation(6.0) == pytest.approx(math.sqrt(6.0))
    assert parse_distribution("normal 2 sigma").standard_deviation(5.0) == 2.5


def test_behind_the_comma_of_a_tolerance():
    assert split_distribution("4 mm +- 5 um, uniform") == ("4 mm +- 5 um", Distribution("uniform", 0.0))
    assert split_distribution("4 mm +- 5 um") == ("4 mm +- 5 um", None)
    assert split_distribution("13,5 mm +- 5 um") == ("13,5 mm +- 5 um", None)


def test_a_key_reads_it():
    read = ROLLER_RADIUS.read("4 mm ± 5 µm, normal 2 sigma")
    assert (read.value, read.tolerance, read.distribution) == (0.004, 5e-6, Distribution("normal", 2.0))
    assert ROLLER_RADIUS.read("4 mm ± 5 µm").distribution is None
    with pytest.raises(InputError, match="distributed as"):
        ROLLER_RADIUS.read("4 mm ± 5 µm, gauss")
    with pytest.raises(InputError):
        ROLLER_RADIUS.read("4 mm, uniform")
