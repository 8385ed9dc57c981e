"""The Stribeck picture: a line for each contact and temperature, each with its name, over the speeds asked for."""

from pathlib import Path

import numpy as np
import pytest

import asperity
from asperity.joint_file.film import joint_film
from asperity.show.film_figure import film_figure

OIL = Path(__file__).parents[2] / "examples" / "oil.toml"


@pytest.fixture(scope="module")
def film():
    return joint_film(asperity.load(OIL).case, temperatures=(20.0, 40.0, 80.0), points=15)


@pytest.fixture(scope="module")
def figure(film):
    return film_figure(film, title="oil.toml")


def test_lines_are_the_curves(film, figure):
    capacity, share = figure.axes
    for axes, name, factor in ((capacity, "traction_capacity", 1.0), (share, "asperity_share", 100.0)):
        drawn = [line.get_ydata() for line in axes.lines[:6]]
        known = [factor * values for curves in film.curves for values in getattr(curves, name)]
        for one, other in zip(drawn, known, strict=True):
            np.testing.assert_array_equal(one, other)
        assert axes.get_xscale() == "log"
        assert axes.get_xlim() == pytest.approx((1.5, 3000.0))


def test_one_line_style_for_each_temperature_and_one_colour_for_each_contact(figure):
    lines = figure.axes[0].lines[:6]
    assert [line.get_linestyle() for line in lines] == ["-", "-", "--", "--", ":", ":"]
    assert len({line.get_color() for line in lines}) == 2


def test_every_line_has_its_name(figure):
    for axes in figure.axes:
        said = {text.get_text() for text in axes.texts}
        legend = axes.get_legend()
        said |= set() if legend is None else {text.get_text() for text in legend.get_texts()}
        assert said == {f"{contact} at {at} °C" for contact in ("sp", "pr") for at in (20, 40, 80)}


def test_every_name_is_nearest_to_its_own_line(figure):
    """Of the lines of its colour, which is that of its contact."""
    names = [f"{contact} at {at} °C" for at in (20, 40, 80) for contact in ("sp", "pr")]
    for axes in figure.axes:
        lines = {}
        for name, line in zip(names, axes.lines[:6], strict=True):
            x, y = (np.asarray(values, dtype=float) for values in line.get_data())
            ends = axes.transData.transform(np.column_stack([x, y])[np.isfinite(y)])
            along = np.linspace(0.0, len(ends) - 1.0, 4000)
            lines[name] = np.column_stack(
                [np.interp(along, np.arange(len(ends)), ends[:, k]) for k in (0, 1)]
            )
        for text in axes.texts:
            box = text.get_window_extent(figure.canvas.get_renderer())
            low, high = np.array([box.x0, box.y0]), np.array([box.x1, box.y1])
            far = {
                name: np.min(np.linalg.norm(points - np.clip(points, low, high), axis=1))
                for name, points in lines.items()
            }
            own = text.get_text()
            assert far[own] == min(far[name] for name in names if name[:2] == own[:2]), own


def test_contacts_that_are_alike_have_one_colour_and_one_name(film):
    twins = film._replace(
        contact_names=("sp_1", "sp_2"),
        curves=tuple(
            curves._replace(
                traction_capacity=curves.traction_capacity[[0, 0]],
                asperity_share=curves.asperity_share[[0, 0]],
            )
            for curves in film.curves[:1]
        ),
    )
    for axes in film_figure(twins, title="twins").axes:
        assert [text.get_text() for text in axes.texts] == ["sp 1, sp 2 at 20 °C"]
        assert axes.lines[0].get_color() == axes.lines[1].get_color()
