"""Known forms vanish, roughness stays; outliers are marked."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface.levelling import default_form, levelled, without_outliers
from asperity.surface.topography import Topography

Y, X = np.mgrid[0:20, 0:30].astype(float)


@pytest.mark.parametrize(
    ("form", "degree", "z"),
    [
        ("plane", None, 3 + 2 * X - Y),
        ("cylinder_x", None, 1 + X - 0.1 * X**2),
        ("cylinder_y", None, Y + 0.3 * Y**2),
        ("polynomial", 3, X**2 * Y - 4 * Y**3 + X),
    ],
)
def test_form_of_a_map_vanishes_even_with_gaps(form, degree, z):
    z = z.copy()
    z[3:6, 4:9] = np.nan
    flat = levelled(topography=Topography(z, 1.0, 1.0), form=form, degree=degree).heights
    assert np.nanmax(np.abs(flat)) < 1e-9 * np.nanmax(np.abs(z))
    assert np.isnan(flat).sum() == 15


def test_line_is_the_least_squares_line():
    z = np.random.default_rng(0).standard_normal(100)
    x = np.arange(100)
    expected = z - np.polyval(np.polyfit(x, z, 1), x)
    np.testing.assert_allclose(
        levelled(topography=Topography(z, 1.0), form="line").heights, expected, atol=1e-12
    )


def test_wrong_forms():
    t = Topography(np.zeros(5), 1.0)
    for form, degree in (("plane", None), ("sphere", None), ("polynomial", None), ("polynomial", 40)):
        with pytest.raises(InputError):
            levelled(topography=t, form=form, degree=degree)


def test_default_form_removes_the_tilt_and_what_leaves_it_is_refused():
    """Of z = tilt + noise with the variances 1 : 1/24 the tilt has 96 %; at 1 : 1/6 it has 86 %."""
    x = np.linspace(-1.0, 1.0, 2001)
    tilt = x / x.std()
    noise = np.random.default_rng(5).standard_normal(2001)
    noise -= np.polyval(np.polyfit(x, noise, 1), x)
    noise /= noise.std()
    steep, gentle = (Topography(tilt + noise / np.sqrt(n), 1.0, source="t") for n in (24, 6))
    for form in ("none", "mean"):
        with pytest.raises(InputError, match=r"tilt makes up 96.0 % .* use the form 'line'"):
            levelled(topography=steep, form=form)
        assert levelled(topography=gentle, form=form).heights.std() == pytest.approx(np.sqrt(7 / 6))
    flat = levelled(topography=steep, form=default_form(steep))
    np.testing.assert_allclose(flat.heights, noise / np.sqrt(24), atol=1e-12)
    assert flat.notes == ("form removed: line",)
    assert default_form(Topography(np.zeros((3, 3)), 1.0, 1.0)) == "plane"
    with pytest.raises(InputError, match="use the form 'plane'"):
        levelled(topography=Topography(X - Y + 1e-3 * np.sin(X * Y), 1.0, 1.0), form="mean")


def test_outliers():
    z = 0.01 * np.random.default_rng(1).standard_normal(500)
    z[[50, 300]] = 5.0
    got = without_outliers(topography=Topography(z, 1.0), threshold=8.0, window=9)
    np.testing.assert_array_equal(np.flatnonzero(np.isnan(got.heights)), [50, 300])
    with pytest.raises(InputError):
        without_outliers(topography=got, threshold=8.0, window=4)
