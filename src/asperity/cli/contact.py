"""``asperity contact``: contact stiffness of any number of roller pairs."""

from __future__ import annotations

import click

from asperity.cli.run_by_name import run_by_name


@click.command()
@click.option("--table", type=click.Path(), required=True, help="CSV table of roller pairs to read.")
@click.option("--out", type=click.Path(), required=True, help="CSV table to write.")
@click.option("--gamma", type=float, default=1.5, show_default=True, help="Frequency ratio of all surfaces.")
@click.option(
    "--asperity-base",
    type=click.Choice(["majumdar_bhushan_1991", "circular_spot"]),
    default="majumdar_bhushan_1991",
    show_default=True,
    help="Variant of the base length of an asperity.",
)
@run_by_name
def contact() -> None:
    """Spots, loads and stiffness of every roller pair in a CSV table.

    Columns of the table: D, G_mm, F_N, T_N, mu, R1_mm, R2_mm, sign (1 outer, -1 inner contact), B_mm, E1_MPa,
    E2_MPa, nu1, nu2, H_MPa (the hardness), lambda (printed, hertz_area or unity). The output adds the columns psi,
    lam, a_c_mm2, a_l_mm2, A_r_mm2, Fe_N, Fp_N, Kt_N_per_mm, Kn_N_per_mm. Kt and Kn are nan where every spot is
    plastic (a_l <= a_c): the contact law has no stiffness there. If a row is invalid, the message gives its line
    and column, and nothing is written.
    """
