"""A measured surface in a script: D and G with their intervals and units, height parameters, a picture."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from asperity.api.named_quantity import NamedQuantity, si_number
from asperity.api.shown import Shown, displayed, frame
from asperity.errors import InputError, NoSolutionError
from asperity.precision import use_compilation_cache, use_double_precision
from asperity.results import known_result
from asperity.surface.fractal_fit import FractalFit
from asperity.surface.height_spectrum import Lay
from asperity.surface.measure_files import MeasuredFiles, files_document, measured_files
from asperity.surface.measured_roughness import MeasuredRoughness
from asperity.surface.measurement import CONFIDENCE
from asperity.surface.roughness import Roughness
from asperity.types import Document
from asperity.unit_table import Dimension
from asperity.units import format_quantity
from asperity.views.blocks import Block, Paragraph, Table

if TYPE_CHECKING:
    import pandas
    from matplotlib.figure import Figure

_LENGTHS = (
    "spacing",
    "start",
    "stop",
    "short_cutoff",
    "long_cutoff",
    "shortest_wavelength",
    "longest_wavelength",
)


def measure_surface(
    *files: str | Path,
    position_unit: str | None = None,
    height_unit: str | None = None,
    spacing: str | None = None,
    decimal: str = "auto",
    column: str | None = None,
    no_data: str | None = None,
    any_size: bool = False,
    start: str | None = None,
    stop: str | None = None,
    form: str | None = None,
    degree: int | None = None,
    missing: str = "refuse",
    outlier_threshold: float | None = None,
    short_cutoff: str | None = None,
    long_cutoff: str | None = None,
    direction: str = "x",
    lay: Lay | None = None,
    estimator: str = "automatic",
    frequency_ratio: float = 1.5,
    shortest_wavelength: str | None = None,
    longest_wavelength: str | None = None,
) -> FractalSurface:
    """Spectrum of profile or map files, and fractal dimension D and roughness G with 95 % intervals.

    Parameters
    ----------
    *files : str or Path
        Profile files of one surface, whose spectra are averaged, or one map.
    position_unit, height_unit : str, optional
        Units of positions and heights where a file does not name them, such as ``"um"``.
    spacing : str, optional
        Distance of the points with its unit, for files that hold heights only.
    decimal : {"auto", "point", "comma"}, optional
        Decimal sign of text files.
    column : str, optional
        Column of the heights in a text file with several, by its heading or its number from 1.
    no_data : str, optional
        Number that marks missing points, such as ``"-9999"``, several with commas between them, or ``"none"`` if every
        number is a height.
    any_size : bool, optional
        Accept sizes that are unlikely for a rough surface.
    start, stop : str, optional
        Section of a profile, such as ``"468 um"``.
    form, degree, missing, outlier_threshold, short_cutoff, long_cutoff : optional
        Treatment before the evaluation, as :class:`asperity.surface.measure.Conditioning` describes it; cutoffs carry
        their units. By default a line is removed from a profile and a plane from a map.
    direction : {"x", "y"}, optional
        Direction in a map of D and G, and in which the contact rolls.
    lay : {"rolling", "axis", "isotropic"}, optional
        Of a profile: the direction of the grooves, which it crosses. A joint needs it.
    estimator : str, optional
        automatic, likelihood, lines, structure_function or power_spectrum.
    frequency_ratio : float, optional
        gamma of the model, above 1.
    shortest_wavelength, longest_wavelength : str, optional
        Limits of the band with their units; by default they are found.

    Returns
    -------
    FractalSurface
        The measurement; its ``measurement`` goes into :meth:`asperity.api.joint.DescribedJoint.with_surface`.

    Raises
    ------
    InputError
        If a file cannot be read, or an option has no unit or makes no sense.
    NoSolutionError
        If the surface has neither a power law over at least one decade of wavelength nor the points for a spectrum.
    """
    options: Document = {name: value for name, value in locals().items() if name != "files"}
    if not files:
        raise InputError(
            "no file to measure; name at least one, e.g. asperity.measure_surface('profile.csv')"
        )
    use_double_precision()
    use_compilation_cache()
    for name in _LENGTHS:
        if options[name] is not None:
            options[name] = si_number(options[name], Dimension.LENGTH, name=name)
    measured = measured_files(files, **options)
    if isinstance(measured.fit, str) and measured.spectrum is None:
        raise NoSolutionError(f"{measured.source}: {measured.fit}")
    return FractalSurface(measured, measured.fit)


class FractalSurface(Shown):
    """A measured surface: ``surface["fractal_roughness"]`` is a number with its unit.

    Parameters
    ----------
    measured : MeasuredFiles
        Conditioned surfaces and fits.
    fit : FractalFit or str
        The fit that counts, or why there is no power law.
    """

    def __init__(self, measured: MeasuredFiles, fit: FractalFit | str) -> None:
        self.measured, self.fit = measured, fit
        heights, number, length = measured.surfaces[0].heights, Dimension.DIMENSIONLESS, Dimension.LENGTH
        rough, letter = measured.surfaces[0].roughness, "S" if measured.topographies[0].is_map else "P"
        fractal = (
            ("fractal_dimension", "fractal dimension D", number, "1"),
            ("fractal_roughness", "fractal roughness G", length, "m"),
            ("frequency_ratio", "frequency ratio gamma", number, "1"),
            ("shortest_wavelength", "shortest wavelength of the band", length, "um"),
            ("longest_wavelength", "longest wavelength of the band", length, "um"),
        )
        known = () if isinstance(fit, str) else fractal
        rows = [(name, label, getattr(fit, name), dimension, unit) for name, label, dimension, unit in known]
        if len(measured.surfaces) == 1:
            rows += [
                (f"{letter}a", f"arithmetic mean height {letter}a", heights.arithmetic_mean, length, "um"),
                (f"{letter}q", f"root mean square height {letter}q", heights.root_mean_square, length, "um"),
            ]
            if isinstance(rough, Roughness):
                behind = f"behind the cut-off {format_quantity(rough.cut_off, 'mm')}"
                rows += [(name, f"{name} {behind}", si, length, "um") for name, si in rough.lengths.items()]
        self._numbers = {
            name: NamedQuantity(name, label, float(si), dimension, unit)
            for name, label, si, dimension, unit in rows
        }

    @property
    def measurement(self) -> MeasuredRoughness:
        """Spectrum, and D and G with their covariance, as a joint takes them."""
        return self.measured.roughness

    @property
    def document(self) -> Document:
        """The document that ``asperity surface measure --json`` prints, in SI units."""
        return files_document(self.measured)

    def __getitem__(self, name: str) -> NamedQuantity:
        """One number of the measurement."""
        return self._numbers[known_result(name, among=tuple(self._numbers), what="number of a surface")]

    def keys(self) -> list[str]:
        """Names of the numbers."""
        return list(self._numbers)

    @property
    def intervals(self) -> dict[str, tuple[float, float]]:
        """95 % intervals of fractal_dimension [-] and fractal_roughness [m]; none without a power law."""
        fractal = self.measurement.fractal
        return {} if fractal is None else fractal.interval(confidence=CONFIDENCE)

    def to_frame(self) -> pandas.DataFrame:
        """The numbers as a pandas data frame: value, unit, ends of the 95 % interval in SI units, SI value and unit."""
        numbers, ends = list(self._numbers.values()), self.intervals
        nothing = (float("nan"), float("nan"))
        return frame(
            {
                "value": [quantity.value for quantity in numbers],
                "unit": [quantity.unit for quantity in numbers],
                "si": [quantity.si for quantity in numbers],
                "si_lower": [ends.get(quantity.name, nothing)[0] for quantity in numbers],
                "si_upper": [ends.get(quantity.name, nothing)[1] for quantity in numbers],
                "si_unit": [quantity.si_unit for quantity in numbers],
            },
            index=list(self._numbers),
            index_name="number",
        )

    def plot(self) -> Figure:
        """Draw heights, spectrum and structure function with the fitted power law.

        A notebook shows the figure; elsewhere call its ``savefig``.
        """
        from asperity.surface.plots import measurement_figure

        measured = self.measured
        return displayed(
            measurement_figure(surfaces=measured.topographies, fit=self.fit, direction=measured.direction)
        )

    def blocks(self) -> list[Block]:
        """The numbers of the measurement with their intervals."""
        ends = self.intervals
        rows = []
        for quantity in self._numbers.values():
            interval = [format_quantity(end, quantity.unit) for end in ends.get(quantity.name, ())]
            rows.append((quantity.label, str(quantity), *(interval or ("", ""))))
        title = f"{self.measured.source}: " + (
            f"{self.fit}; the joint uses the measured spectrum"
            if isinstance(self.fit, str)
            else f"estimator {self.fit.estimator}, {self.fit.profiles} profile(s)"
        )
        return [Paragraph(title), Table("Measured surface", ("number", "value", "95 % from", "to"), rows)]
