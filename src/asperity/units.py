"""Quantities as text: ``"13.5 mm"`` to SI and back, in a fraction of a millisecond and without dependencies.

A quantity is a decimal number and a product of units: ``5 N*m``, ``5 N·m``, ``5 N m``, ``5 Nm``, ``7850 kg/m^3``,
``3e4 N*m/rad``. Products and quotients are evaluated from left to right (``N/mm/rad`` is N/(mm·rad)); the only
parentheses are those of a product below a stroke, ``mm^3/(N*m)``. A hyphen or a point between two names makes one unit
of them, ``5 N-m``, ``5 in-lb``, also behind a stroke: ``475 J/kg-K`` is J/(kg·K). Powers are whole numbers after ``^``
or ``**``, or superscripts. The arithmetic is exact except for one rounding, so that ``"13.5 mm"`` gives the same float
as writing ``0.0135``.

Pounds and ounces are masses. Beside a length they are forces where a mass makes no quantity that is known:
``lb*in`` is a torque, ``lb*in^2`` a moment of inertia.
"""

import contextlib
import functools
import math
import re

from asperity.errors import InputError, quoted
from asperity.hardness_scales import other_scale_words, vickers_of_rockwell
from asperity.unit_table import TORQUE_UNITS, Dimension, Exponents, Unit, unit_table

__all__ = ["Dimension", "format_quantity", "from_si", "parse_quantity", "parse_tolerance"]

LONGEST_TEXT = 200
LARGEST_POWER = 12

_SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", "0123456789-+")
_TO_SUPERSCRIPTS = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
_SAME = str.maketrans("−μ·⋅×∙\u00a0\u202f", "-µ****  ")
_HYPHENS = str.maketrans("\u2010\u2011\u2013", "---")  # as data sheets write them between units
_NUMBER = r"(?a:([+-]?)(\d+\.?\d*|\.\d+)(?:[eE]([+-]?\d+))?(?![\d.]))"
_TERM = r"\s*(\.?-|[*/.]?)\s*(1(?=\s*/|\s*$)|[^\W\d]+|°C|[%°℃])(?:\s*(?:\^|\*\*)\s*([+-]?(?a:\d)+))?"
_ARC = r"\barc\s*[-.]?\s*(?=min|sec)"
#: A product in parentheses below a stroke.
_BELOW_A_STROKE = r"/\s*\(([^()/]*)\)"
_PLUS_MINUS = r"±|\+\s?/?\s?-"
_HARDNESS = r"\s*(H[VK]|HR[A-K]|HBW?|HBS|HL[A-Z]*|HSD?)\s*[\d./]*\s*"  # scale, and the load of the test
_PER_MINUTE = r"\s*(1?\s*/\s*min|min\s*((\^|\*\*)\s*-1|⁻¹))\s*"
#: Dimension asked, exponents of what is often written instead → what to do.
_REMEDIES: dict[tuple[Dimension, Exponents], str] = {
    (Dimension.VISCOSITY, (2, 0, -1, 0, 0)): "this is a kinematic viscosity; multiply it by the density: "
    "30 cSt of an oil of 870 kg/m^3 are 26.1 mPa*s",
    (Dimension.TORQUE, (1, 1, 0, 0, 0)): "a kilogram is a mass; write kgf*cm for 9.80665 N times 1 cm",
}
#: Customary units of mass → those of the force that bears the same name beside a length.
_FORCES = {
    **dict.fromkeys(("pound", "pounds", "lb", "lbs"), "lbf"),
    **dict.fromkeys(("ounce", "ounces", "oz"), "ozf"),
}
# The patterns are kept as text: re compiles each on first use and caches it, so that importing costs nothing.


def _nearest(name: str) -> str:
    """Suggest the known unit that an unknown one resembles most."""
    import difflib

    torque_units = {known.lower(): known for known in TORQUE_UNITS if known[0] == "N"}
    if name.lower() in torque_units:
        return f"; did you mean the torque '{torque_units[name.lower()]}'?"
    by_lower_case: dict[str, str] = {}
    for known in [
        "mm",
        "MPa",
        "rpm",
        "deg",
        *unit_table(),
    ]:  # the common one first where the case alone differs
        by_lower_case.setdefault(known.lower(), known)
    close = difflib.get_close_matches(name.lower(), list(by_lower_case), n=1, cutoff=0.6)
    return (
        f"; did you mean '{by_lower_case[close[0]]}'?"
        if close
        else "; examples of known units: mm, N, MPa, deg, rpm, N*m"
    )


@functools.lru_cache(maxsize=512)
def _parse_unit(text: str) -> Unit:
    """Exact SI factor and exponents of a product of units."""
    terms = _terms(text)
    unit = _product(terms)
    if _is_known(unit[3]):
        return unit
    with_forces = _product(
        [
            (_FORCES[name], power) if _beside_length(terms, index) else (name, power)
            for index, (name, power) in enumerate(terms)
        ]
    )
    return with_forces if _is_known(with_forces[3]) else unit


def _terms(text: str) -> list[tuple[str, int]]:
    """Names of the table and their powers, below a stroke negative."""
    written = text.strip()
    plain = re.sub(
        "[⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺]+",
        lambda raised: "^" + raised[0].translate(_SUPERSCRIPTS),
        written.translate(_SAME).translate(_HYPHENS),
    )
    plain = re.sub(_BELOW_A_STROKE, lambda group: "/" + re.sub(r"[*\s]+", "/", group[1].strip()), plain)
    plain = re.sub(_ARC, "arc", plain)
    units = unit_table()
    terms: list[tuple[str, int]] = []
    position, sign = 0, 1
    while position < len(plain):
        match = re.match(_TERM, plain[position:])
        tight = match is not None and match[1] in ("-", ".", ".-")
        if match is None or (not terms and (tight or match[1] == "*")) or (tight and match[2] == "1"):
            rest = plain[position:].strip()
            raise InputError(f"cannot read the unit '{written}' from '{rest}' on{_hint(plain, rest)}")
        operator, name, power_text = match.groups()
        name = "µ" + name[1:] if name[0] == "u" and "µ" + name[1:] in units else name
        if name not in units:
            raise InputError(f"unknown unit '{name}'{_nearest(name)}")
        power = int(power_text[:5]) if power_text else 1
        if name in TORQUE_UNITS and power_text:
            raise InputError(
                f"the power of '{name}' in '{written}' could be that of the torque or of the length; write the product "
                "with '*', e.g. 'N*m^2'"
            )
        if abs(power) > LARGEST_POWER:
            raise InputError(f"the power {power_text} in '{written}' is beyond ±{LARGEST_POWER}")
        sign = sign if tight else -1 if operator == "/" else 1
        terms.append((name, sign * power))
        position += match.end()
    return terms


def _hint(plain: str, rest: str) -> str:
    """What to write instead of a unit that cannot be read from ``rest`` on."""
    if "(" in plain:
        return "; parentheses are only those of a product below a stroke, 'mm^3/(N*m)'"
    name = re.search(r"[^\W\d]+$", plain.removesuffix(rest))
    if name and re.fullmatch(r"[+-]?\d+", rest):
        return f"; write a power with '^', for example '{name[0]}^{rest}'"
    return ""


def _product(terms: list[tuple[str, int]]) -> Unit:
    numerator, denominator, pi_power = 1, 1, 0
    total = [0, 0, 0, 0, 0]
    for name, power in terms:
        top, bottom, unit_pi, exponents = unit_table()[name]
        numerator *= top**power if power >= 0 else bottom**-power
        denominator *= bottom**power if power >= 0 else top**-power
        pi_power += power * unit_pi
        total = [old + power * new for old, new in zip(total, exponents, strict=True)]
    return numerator, denominator, pi_power, (total[0], total[1], total[2], total[3], total[4])


def _beside_length(terms: list[tuple[str, int]], index: int) -> bool:
    """Whether a term is a pound or an ounce that is multiplied with the length before or behind it."""
    name, power = terms[index]
    beside = [terms[k] for k in (index - 1, index + 1) if 0 <= k < len(terms)]
    return (
        name in _FORCES
        and abs(power) == 1
        and any(unit_table()[other][3] == Dimension.LENGTH.exponents and p == power for other, p in beside)
    )


@functools.cache
def _is_known(exponents: Exponents) -> bool:
    return any(dimension.exponents == exponents for dimension in Dimension)


def _dimension_of(exponents: Exponents) -> str:
    for dimension in Dimension:
        if dimension.exponents == exponents:
            return dimension.label
    parts = [
        f"{s}^{e}" if e != 1 else s for s, e in zip(("m", "kg", "s", "rad", "K"), exponents, strict=True) if e
    ]
    return f"a quantity of unit {'*'.join(parts)}"


def _split(text: str, dimension: Dimension, example: str) -> tuple[str, str]:
    """Number and unit of a quantity, both as text."""
    plain = text.translate(_SAME).strip()
    if not plain:
        raise InputError(f"expected {dimension.label} ({example}), got an empty text")
    if len(plain) > LONGEST_TEXT:
        raise InputError(f"expected {dimension.label} ({example}), got {len(plain)} characters of text")
    if re.match(r"[+-]?(nan|inf(inity)?)\b", plain, re.IGNORECASE):
        raise InputError(
            f"expected {dimension.label} ({example}), got '{text}', which is not a finite number"
        )
    match = re.match(_NUMBER, plain)
    if match is None:
        raise InputError(
            f"expected {dimension.label} ({example}), got '{text}', which does not start with a number"
        )
    rest = plain[match.end() :]
    if re.match(r",\s*\d", rest):
        raise InputError(
            f"expected {dimension.label} ({example}), got '{text}': write a decimal point, no comma"
        )
    return match.group(), rest


def _exact(number: str) -> tuple[int, int]:
    """Numerator and denominator of a decimal number."""
    match = re.fullmatch(_NUMBER, number)
    if match is None or not math.isfinite(float(number)):
        raise InputError(f"the number '{number}' is not finite in double precision")
    sign, digits, exponent = match.groups()
    integer_part, _, decimals = digits.partition(".")
    mantissa = int(integer_part + decimals) * (-1 if sign == "-" else 1)
    if mantissa == 0:
        return 0, 1
    if float(number) == 0.0:
        raise InputError(f"the number '{number}' is too small for double precision")
    power = int(exponent or 0) - len(decimals)
    return mantissa * 10 ** max(power, 0), 10 ** max(-power, 0)


def _vickers(number: str, scale: str) -> tuple[int, int]:
    """The Vickers number of a hardness by a scale, as numerator and denominator."""
    if scale == "HV":
        return _exact(number)
    if scale != "HRC":
        raise InputError(other_scale_words(scale, float(number)))
    return vickers_of_rockwell(rockwell_c=float(number)).as_integer_ratio()


def parse_quantity(text: object, dimension: Dimension, *, example: str | None = None) -> float:
    """Value of a quantity in SI units (radians for angles) from a text such as ``"13.5 mm"``.

    A number by itself, as text or as int or float, is accepted for :attr:`Dimension.DIMENSIONLESS` only. The value is
    the double nearest to the exact one where pi is not involved, within a few units in the last place otherwise;
    temperatures are in degrees Celsius. Messages quote ``example``, by default that of the dimension.

    An ``InputError`` if the text is not a quantity, its unit is unknown, missing or of another dimension, or the value
    is not a finite double.

    Examples
    --------
    >>> parse_quantity("13.5 mm", Dimension.LENGTH)
    0.0135
    >>> parse_quantity("8.6 N·m/arcmin", Dimension.TORSIONAL_STIFFNESS).__round__(3)
    29564.622
    """
    example = f"e.g. '{example or dimension.example}'"
    if isinstance(text, bool) or not isinstance(text, str | int | float):
        raise InputError(f"expected {dimension.label} as text ({example}), got {quoted(text)}")
    if not isinstance(text, str):
        if dimension is not Dimension.DIMENSIONLESS:
            raise InputError(
                f"expected {dimension.label} with its unit as text ({example}), got the bare number {quoted(text)}"
            )
        try:
            value = float(text)
        except OverflowError:
            value = math.inf
        if not math.isfinite(value):
            raise InputError(
                f"expected {dimension.label} ({example}), got a number that is not finite: {value}"
            )
        return value
    number, unit_text = _split(text, dimension, example)
    if not unit_text and dimension is not Dimension.DIMENSIONLESS:
        raise InputError(
            f"expected {dimension.label} with its unit ({example}), got the bare number '{text}'"
        )
    top, bottom = _exact(number)
    scale = re.fullmatch(_HARDNESS, unit_text)
    if scale is not None and dimension is Dimension.HARDNESS:
        top, bottom = _vickers(number, scale[1])
        unit_text = "HV"
    elif scale is not None:
        raise InputError(f"expected {dimension.label} ({example}), got a hardness in '{text}'")
    elif re.search(r"\bHV\b", unit_text):
        raise InputError(f"cannot read '{text}': HV stands alone, as in '700 HV'")
    numerator, denominator, pi_power, exponents = _parse_unit(unit_text)
    if dimension is Dimension.TEMPERATURE and re.search(r"\b(K|kelvins?)\b", unit_text):
        top, bottom = 100 * top - 27315 * bottom, 100 * bottom  # 0 degC is 273.15 K
    if dimension is Dimension.ANGULAR_VELOCITY and re.fullmatch(_PER_MINUTE, unit_text):
        numerator, pi_power, exponents = 2 * numerator, pi_power + 1, dimension.exponents  # turns per minute
    if exponents != dimension.exponents:
        measured = f"{_dimension_of(exponents)} '{unit_text.strip(' */')}'"
        remedy = _REMEDIES.get((dimension, exponents))
        raise InputError(
            f"expected {dimension.label} ({example}), got {measured} in '{text}'{f'; {remedy}' if remedy else ''}"
        )
    try:
        value = (top * numerator) / (bottom * denominator) * math.pi**pi_power
    except OverflowError:
        value = math.inf
    if not math.isfinite(value) or (value == 0.0 and top != 0):
        raise InputError(f"'{text}' in {dimension.si_unit} is beyond the range of double precision")
    return value


def parse_tolerance(text: object, dimension: Dimension, *, example: str | None = None) -> tuple[float, float]:
    """Value and tolerance of a text such as ``"13.5 mm +- 5 µm"``, in SI units; the tolerance is not negative.

    Both parts carry their own unit. ``±``, ``+-`` and ``+/-`` are equivalent.

    Examples
    --------
    >>> parse_tolerance("13.5 mm ± 5 µm", Dimension.LENGTH)
    (0.0135, 5e-06)
    """
    value_example = example or dimension.example
    wanted = f"{dimension.label} with its tolerance (e.g. '{value_example} +- {value_example}')"
    if not isinstance(text, str):
        raise InputError(f"expected {wanted}, got {quoted(text)}")
    parts = re.split(_PLUS_MINUS, text.translate(_SAME)) if len(text) <= 2 * LONGEST_TEXT else []
    if len(parts) != 2:
        raise InputError(f"expected {wanted}, got '{text[:LONGEST_TEXT]}', which has not exactly one '+-'")
    spread = Dimension.TEMPERATURE_RISE if dimension is Dimension.TEMPERATURE else dimension
    value = parse_quantity(parts[0], dimension, example=example)
    if dimension is Dimension.HARDNESS:
        _refuse_rockwell(*parts)
    tolerance = parse_quantity(parts[1], spread, example=example)
    if tolerance < 0.0:
        raise InputError(f"expected {wanted}, got the negative tolerance '{parts[1].strip()}'")
    return value, tolerance


def _refuse_rockwell(value: str, tolerance: str) -> None:
    """Raise if a tolerance is in HRC, whose steps are unlike pressures."""
    number, unit = re.match(_NUMBER, tolerance.strip()), tolerance.strip()[-3:]
    if unit != "HRC" or number is None:
        return
    ends = ""
    if value.strip().endswith("HRC"):
        middle, half = float(value.strip()[:-3]), abs(float(number.group()))
        with contextlib.suppress(InputError):
            low, high = (vickers_of_rockwell(rockwell_c=middle + side * half) for side in (-1.0, 1.0))
            ends = f"{middle - half:g} HRC are {low:.0f} HV and {middle + half:g} HRC {high:.0f} HV: "
    raise InputError(
        f"'{value.strip()} +- {tolerance.strip()}': {ends}a tolerance in HRC is uneven in pressure; state the "
        "tolerance in HV or as a pressure"
    )


def from_si(value_si: float, unit: str) -> float:
    """Value in a unit such as ``"N*m/arcmin"`` of a quantity known in SI units (radians for angles).

    An ``InputError`` if the unit is unknown or malformed.

    Examples
    --------
    >>> from_si(0.0135, "mm")
    13.5
    """
    numerator, denominator, pi_power, _ = _parse_unit(unit)
    try:
        if numerator % denominator == 0:
            return value_si / (numerator // denominator) / math.pi**pi_power
        return value_si * (denominator / numerator) / math.pi**pi_power
    except OverflowError:
        raise InputError(f"the unit '{unit}' is beyond the range of double precision") from None


def format_quantity(value_si: float, unit: str, digits: int = 4) -> str:
    """Text of a quantity in SI units (radians for angles) for display, in the given unit, ``"1"`` for a bare number.

    Numbers from 0.001 to a million are written as decimals, others with a power of ten; digits before the decimal point
    are never rounded. Nan and infinities are shown as such. An ``InputError`` if the unit is unknown or malformed.

    Examples
    --------
    >>> format_quantity(0.0135, "mm"), format_quantity(4.3e6, "N*m/rad")
    ('13.5 mm', '4.3e6 N·m/rad')
    """
    value = from_si(value_si, unit)
    if value == 0.0 or not math.isfinite(value):
        number = f"{value:g}".lstrip("-") if value == 0.0 else f"{value:g}"
    elif 1e-3 <= abs(value) < 999999.5:
        decimals = max(digits - 1 - math.floor(math.log10(abs(value))), 0)
        number = f"{value:.{decimals}f}"
        number = number.rstrip("0").rstrip(".") if decimals else number
    else:
        mantissa, power = f"{value:.{digits - 1}e}".split("e")
        mantissa = mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa
        number = f"{mantissa}e{int(power)}"
    shown = re.sub(r"(?:\^|\*\*)([+-]?\d+)", lambda match: match[1].translate(_TO_SUPERSCRIPTS), unit.strip())
    shown = shown.replace("*", "·")
    return number if shown in ("", "1") else f"{number} {shown}"


def format_apart(value_si: float, other_si: float, unit: str, digits: int = 4) -> tuple[str, str]:
    """Texts of two quantities, :func:`format_quantity`, with as many more digits as tell them apart if they differ.

    Examples
    --------
    >>> format_apart(13.1801, 13.1798, "N*m")
    ('13.1801 N·m', '13.1798 N·m')
    """
    for more in range(digits, 18):
        shown = format_quantity(value_si, unit, more), format_quantity(other_si, unit, more)
        if shown[0] != shown[1] or value_si == other_si:
            return shown
    return shown


def unit_exponents(unit: str) -> Exponents | None:
    """Exponents of metre, kilogram, second, radian and kelvin of a product of units; None where it is none.

    Examples
    --------
    >>> unit_exponents("N*m"), unit_exponents("furlong")
    ((2, 1, -2, 0, 0), None)
    """
    try:
        return _parse_unit(unit)[3]
    except InputError:
        return None
