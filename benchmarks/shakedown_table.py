"""Write the coefficients of the shakedown and first-yield limits anew from the stress field.

Run it: ``python benchmarks/shakedown_table.py``; it writes ``src/asperity/contact/shakedown_table.py``.
"""

from pathlib import Path

from asperity.contact.stress_peaks import fitted_coefficients
from asperity.precision import use_double_precision

TABLE = Path(__file__).parents[1] / "src" / "asperity" / "contact" / "shakedown_table.py"


def table() -> str:
    use_double_precision()
    shear, mises = fitted_coefficients(shear_terms=11, mises_terms=(11, 9))

    def row(values, indent: str) -> str:
        return "".join(f"{indent}{float(value)!r},\n" for value in values)

    rows = "".join(f"    (\n{row(values, ' ' * 8)}    ),\n" for values in mises)
    return (
        '"""Chebyshev coefficients of :func:`asperity.contact.stress_peaks.fitted_coefficients`.\n\n'
        'Written by ``benchmarks/shakedown_table.py``; a test computes them again.\n"""\n\n'
        f"SHEAR: tuple[float, ...] = (\n{row(shear, '    ')})\n\n"
        f"MISES: tuple[tuple[float, ...], ...] = (\n{rows})\n"
    )


if __name__ == "__main__":
    TABLE.write_text(table(), encoding="utf-8")
    print(TABLE)
