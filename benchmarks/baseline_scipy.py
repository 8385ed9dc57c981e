"""The script a researcher would write: the paper's joint with SciPy's general routines and nothing else.

An independent second opinion on asperity, which it does not import. Everything is taken from the definitions:
``brentq`` for psi and for the largest spot, ``quad`` for every integral over the population of spots,
``fsolve`` for the force balance with the bodies' displacements as unknowns; nothing is reduced by hand.
Equation numbers are those of Zou et al., Materials 18 (2025) 2866; (A1)-(A3) are the geometry, the kinematics
and the closure that the paper leaves out.

    python benchmarks/baseline_scipy.py [--table contact.csv]
"""

import argparse
import csv
import math
import time

import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq, fsolve

GAMMA = 1.5
CONTACTS = ("sp", "pwr", "pwl", "wro", "wlo")

PAPER = {  # SI; material, friction, preload and torque are assumptions, the paper does not give them
    "sun_radius": 4e-3,
    "planet_radius": 13.5e-3,
    "loading_roller_radius": 5e-3,
    "ring_radius": 40e-3,
    "contact_length": 5e-3,
    "planets": 3,
    "young_modulus": 206e9,
    "poisson_ratio": 0.3,
    "hardness": 2.8 * 450e6,
    "density": 7850.0,
    "friction_coefficient": 0.12,
    "fractal_dimension": 1.4,
    "fractal_roughness": 1e-11,
    "contact_factor": "printed",
    "preload": 1000.0,
    "output_torque": 5.0,
    "sun_speed": 6000 * math.pi / 30,
    "push_angle_left": 0.0,
    "push_angle_right": 0.0,
    "bearing_torque_sun": 0.0,  # T_Bs, T_Bw, T_Bc of (1), (3)-(5)
    "bearing_torque_loading_roller": 0.0,
    "bearing_torque_carrier": 0.0,
    "bearing_friction": 0.0,  # mu_b and d: each of two bearings adds mu_b (F_c / 2) (d / 2) to T_Bw
    "bearing_diameter": 0.0,
    "closure": "elastic",  # or constant_pin_force
    "normal_law": "tangent",  # dN/d(compression) at the preload; or secant: N/compression; or nonlinear
    "ring_wall": None,  # None: the ring is compressed like a solid body of radius R_o
}


# One contact: (7)-(24)


def domain_extension_factor(D: float) -> float:
    def equation_below_12(psi: float) -> float:
        return psi ** ((2 - D) / 2) - (1 + psi ** (-D / 2)) ** (-(2 - D) / D) - (2 - D) / D

    return brentq(equation_below_12, 1.0, 10.0, xtol=1e-15, rtol=1e-15)


def contact_factor(name, R1, R2, sign, B, E, F):
    """(11), with numbers in mm, N and MPa."""
    R1, R2, B, E = R1 * 1e3, R2 * 1e3, B * 1e3, E * 1e-6
    centre_distance = R1 + R2 if sign > 0 else abs(R1 - R2)
    exponent = 1 / R1 + 1 / R2 if sign > 0 else abs(1 / R1 - 1 / R2)
    R = R1 * R2 / centre_distance
    if name == "printed":
        return (math.sqrt(4 * B / (math.pi * E) * R) / (math.pi * centre_distance)) ** exponent
    if name == "hertz_area":
        return (math.sqrt(4 * F * R / (math.pi * B * E)) / (math.pi * centre_distance)) ** exponent
    if name == "unity":
        return 1.0
    raise ValueError(name)


def pair_moduli(E1, E2, nu1, nu2):
    E = 1 / ((1 - nu1**2) / E1 + (1 - nu2**2) / E2)
    G1, G2 = E1 / (2 * (1 + nu1)), E2 / (2 * (1 + nu2))
    return E, 1 / ((2 - nu1) / G1 + (2 - nu2) / G2)


def contact(*, D, G, F, T, mu, R1, R2, sign, B, E1, E2, nu1, nu2, H, factor, **_):
    """Spots, loads and stiffness of one rough pair; integrals over s = ln(a/a_l), da = a ds."""
    E, G_star = pair_moduli(E1, E2, nu1, nu2)
    psi = domain_extension_factor(D)
    lam = contact_factor(factor, R1, R2, sign, B, E, F)
    log_ac = 2 * math.log(G) + 2 / (D - 1) * math.log(2 * E / H)  # (19)
    log_kappa = math.log(4 * math.sqrt(math.pi) / 3 * E * math.sqrt(math.log(GAMMA))) + (D - 1) * math.log(G)

    def population(log_al, power, log_scale, lower, upper):
        """Integral of exp(log_scale) a^power n(a) da over the spots from lower to upper, as logarithms."""
        # n(a) da = lambda (D/2) psi^((2-D)/2) (a/a_l)^(-D/2) ds
        weight = lam * D / 2 * psi ** ((2 - D) / 2) * math.exp(log_scale + power * log_al)
        rate = power - D / 2
        lower, upper = lower - log_al, upper - log_al
        if upper <= lower:
            return 0.0
        return weight * quad(lambda s: math.exp(rate * s), lower, upper, epsabs=0, epsrel=1e-12, limit=400)[0]

    def forces(log_al):
        split = min(log_ac, log_al)
        elastic = population(log_al, (3 - D) / 2, log_kappa, log_ac, log_al)  # (17)
        plastic = population(log_al, 1.0, math.log(H), -math.inf, split)  # (18)
        return elastic, plastic

    def load_error(log_al):  # (20)
        return math.log(sum(forces(log_al)) / F)

    low = high = log_ac
    while load_error(low) > 0:
        low -= 8
    while load_error(high) < 0:
        high += 8
    log_al = brentq(load_error, low, high, xtol=1e-15, rtol=1e-15)

    elastic, plastic = forces(log_al)
    slip = max(1 - T / (mu * F), 0.0) ** (1 / 3)
    spot = population(log_al, 0.5, 0.0, log_ac, log_al) / math.sqrt(math.pi)  # integral of (a/pi)^(1/2) n da
    return {
        "psi": psi,
        "lam": lam,
        "a_c": math.exp(log_ac),
        "a_l": math.exp(log_al),
        "A_r": population(log_al, 1.0, 0.0, -math.inf, log_al),
        "F_e": elastic,
        "F_p": plastic,
        "K_t": 8 * G_star * slip * spot,  # (21), (24)
        "K_n": 2 * E * spot,  # (A4), (A6)
    }


# Smooth elastic bodies: half-width and compression between contact and centre (Johnson 1985, sec. 5.6)


def compression(N, R1, R2, sign, B, E_young, nu, ring_wall=None):
    """Approach of the centres of two cylinders pressed by N; the second is the ring for a negative sign."""
    E = E_young / (2 * (1 - nu**2))
    R = R1 * R2 / (R1 + R2 if sign > 0 else R2 - R1)
    b = np.sqrt(4 * N * R / (np.pi * B * E))
    unit = N / B * (1 - nu**2) / (np.pi * E_young)

    def solid(radius):
        return unit * (2 * np.log(4 * radius / b) - 1)

    if sign > 0 or ring_wall is None:
        return solid(R1) + solid(R2)
    return solid(R1) + 2 * unit * (np.log(2 * ring_wall / b) - nu / (2 * (1 - nu)))  # Weber & Banaschek 1953


def normal_stiffness(N, *pair):
    """dN/d(compression) by a central difference: good to about 1e-10."""
    h = 1e-3
    d1 = (compression(N * (1 + h), *pair) - compression(N * (1 - h), *pair)) / (2 * h * N)
    d2 = (compression(N * (1 + 2 * h), *pair) - compression(N * (1 - 2 * h), *pair)) / (4 * h * N)
    return 3 / (4 * d1 - d2)


# The mechanism: (1)-(5), (A1)-(A3)


def geometry(p):
    """(A1) by the law of cosines in the triangle of the centres of ring, planet and loading roller."""
    OP, PW = p["sun_radius"] + p["planet_radius"], p["planet_radius"] + p["loading_roller_radius"]
    OW = p["ring_radius"] - p["loading_roller_radius"]
    alpha = math.acos((OP**2 + OW**2 - PW**2) / (2 * OP * OW))
    theta = math.pi - math.acos((OP**2 + PW**2 - OW**2) / (2 * OP * PW))
    beta = math.acos((PW**2 + OW**2 - OP**2) / (2 * PW * OW))
    return alpha, theta, beta


def pairs(p):
    """R1, R2, sign, B, E, nu, ring wall of every contact."""
    s, q, w, o = (p[k] for k in ("sun_radius", "planet_radius", "loading_roller_radius", "ring_radius"))
    tail = (p["contact_length"], p["young_modulus"], p["poisson_ratio"], p["ring_wall"])
    sun, inner, outer = (s, q, 1, *tail), (q, w, 1, *tail), (w, o, -1, *tail)
    return dict(zip(CONTACTS, (sun, inner, inner, outer, outer), strict=True))


def preload_forces(p):
    """Normal forces (sp, pwr, pwl, wro, wlo) and right pin force at rest and without torque."""
    _, theta, beta = geometry(p)
    N_pw = p["preload"] / (2 * math.cos(theta))
    pins = [N_pw * math.sin(beta) / math.cos(p[k]) for k in ("push_angle_right", "push_angle_left")]
    N_wo = [
        N_pw * math.cos(beta) + F * math.sin(p[k])
        for F, k in zip(pins, ("push_angle_right", "push_angle_left"), strict=True)
    ]
    return np.array([p["preload"], N_pw, N_pw, *N_wo]), pins[0]


def force_balance(p):
    """Solve (1)-(5) with the closure (A3): 13 forces, and for ``elastic`` also 4 displacements."""
    Rs, Rp, Rw, Ro = (p[k] for k in ("sun_radius", "planet_radius", "loading_roller_radius", "ring_radius"))
    n, g_l, g_r = p["planets"], p["push_angle_left"], p["push_angle_right"]
    alpha, th, b = geometry(p)
    omega_c = p["sun_speed"] * Rs / (Ro - Rs)  # (A2), magnitude
    m_p = p["density"] * math.pi * Rp**2 * p["contact_length"]
    m_w = p["density"] * math.pi * Rw**2 * p["contact_length"]
    C_p, C_w = m_p * omega_c**2 * (Rs + Rp), m_w * omega_c**2 * (Ro - Rw)
    N0, pin0 = preload_forces(p)
    pair = pairs(p)
    delta0 = np.array([compression(N, *pair[c]) for N, c in zip(N0, CONTACTS, strict=True)])
    if p["normal_law"] == "secant":
        k = N0 / delta0
    else:
        k = np.array([normal_stiffness(N, *pair[c]) for N, c in zip(N0, CONTACTS, strict=True)])
    force, length = p["preload"], p["preload"] / k.min()
    elastic = p["closure"] == "elastic"

    # y points from the joint's axis to the planet's centre, x the way the sun drives the planet
    def direction(angle):
        return np.array([math.sin(angle), math.cos(angle)])

    to_right, to_left, out_right, out_left = (direction(angle) for angle in (th, -th, alpha, -alpha))
    # a roller moves across the push of its pin: outward, and with a push angle also away from the planet
    away_right, away_left = direction(alpha + math.pi / 2), direction(-alpha - math.pi / 2)
    free_right, free_left = out_right + math.tan(g_r) * away_right, out_left + math.tan(g_l) * away_left

    def residual(x):
        N_sp, N_pwr, N_pwl, N_wro, N_wlo, T_sp, T_pwr, T_pwl, T_wro, T_wlo, F_cl, F_cr, S_in = x[:13] * force
        T_in = S_in * Rs
        T_Bl = p["bearing_torque_loading_roller"] + p["bearing_friction"] * F_cl * p["bearing_diameter"] / 4
        T_Br = p["bearing_torque_loading_roller"] + p["bearing_friction"] * F_cr * p["bearing_diameter"] / 4
        equations = [
            (T_in - 2 * p["bearing_torque_sun"] - n * T_sp * Rs) / Rs,
            T_sp + (T_pwr + T_pwl) * math.cos(th) + (N_pwl - N_pwr) * math.sin(th),
            N_sp - (T_pwr - T_pwl) * math.sin(th) - (N_pwr + N_pwl) * math.cos(th) + C_p,
            T_pwr + T_pwl - T_sp,
            F_cl * math.cos(g_l) - N_pwl * math.sin(b) - T_pwl * math.cos(b) - T_wlo,
            F_cl * math.sin(g_l) + N_pwl * math.cos(b) - T_pwl * math.sin(b) - N_wlo + C_w,
            T_wlo - T_pwl + 2 * T_Bl / Rw,
            F_cr * math.cos(g_r) - N_pwr * math.sin(b) + T_pwr * math.cos(b) + T_wro,
            F_cr * math.sin(g_r) + N_pwr * math.cos(b) + T_pwr * math.sin(b) - N_wro + C_w,
            T_wro - T_pwr + 2 * T_Br / Rw,
            n * (F_cl * math.cos(g_l) - F_cr * math.cos(g_r))
            - (2 * p["bearing_torque_carrier"] + p["output_torque"]) / (Ro - Rw),
            (T_pwr * N_pwl - T_pwl * N_pwr) / force,
        ]
        if not elastic:
            return np.array([*equations, F_cr - pin0]) / force
        planet = x[13:15] * length
        right, left = x[15] * length * free_right, x[16] * length * free_left
        approach = np.array(
            [
                -planet[1],
                (planet - right) @ to_right,
                (planet - left) @ to_left,
                right @ out_right,
                left @ out_left,
            ]
        )
        N = np.array([N_sp, N_pwr, N_pwl, N_wro, N_wlo])
        if p["normal_law"] in ("tangent", "secant"):
            closure = N - N0 - k * approach
        else:
            now = [compression(max(f, 1e-9 * force), *pair[c]) for f, c in zip(N, CONTACTS, strict=True)]
            closure = k * (np.array(now) - delta0 - approach)
        return np.array([*equations, *closure]) / force

    start = np.concatenate([N0, np.full(5, 0.01 * force), [pin0, pin0], [0.03 * force]]) / force
    if elastic:
        start = np.concatenate([start, np.zeros(4)])
    x, _, ok, message = fsolve(residual, start, xtol=1e-13, full_output=True)
    worst = float(np.abs(residual(x)).max())
    if ok != 1 and worst > 1e-10:
        raise RuntimeError(f"no force balance: {message}")
    values = x[:13] * force
    return {
        "normal": dict(zip(CONTACTS, values[:5], strict=True)),
        "tangential": dict(zip(CONTACTS, values[5:10], strict=True)),
        "pin": {"left": values[10], "right": values[11]},
        "input_torque": values[12] * Rs,
        "residual": worst,
        "planet_mass": m_p,
        "loading_roller_mass": m_w,
        "carrier_speed": omega_c,
    }


def torsional_stiffness(p, K):
    """(25)-(30) from the five tangential stiffnesses: at the sun with the carrier locked."""
    Rs, Rp, Rw = p["sun_radius"], p["planet_radius"], p["loading_roller_radius"]
    K_sp = K["sp"] * Rs**2
    K_pw = (K["pwr"] + K["pwl"]) * Rp**2 * (Rs / Rp) ** 2
    K_wo = (K["wro"] + K["wlo"]) * Rw**2 * (Rs / Rw) ** 2
    return p["planets"] / (1 / K_sp + 1 / K_pw + 1 / K_wo)


def evaluate(parameters: dict) -> dict:
    """The whole chain for one joint; keys as in ``PAPER``, SI units, radians."""
    p = {**PAPER, **parameters}
    forces = force_balance(p)
    contacts = {}
    for name, (R1, R2, sign, B, E, nu, _) in pairs(p).items():
        contacts[name] = contact(
            D=p["fractal_dimension"],
            G=p["fractal_roughness"],
            F=forces["normal"][name],
            T=forces["tangential"][name],
            mu=p["friction_coefficient"],
            **{"R1": R1, "R2": R2, "sign": sign, "B": B, "E1": E, "E2": E, "nu1": nu, "nu2": nu},
            H=p["hardness"],
            factor=p["contact_factor"],
        )
    at_sun = torsional_stiffness(p, {name: c["K_t"] for name, c in contacts.items()})
    ratio = (p["ring_radius"] - p["sun_radius"]) / p["sun_radius"]
    return {"forces": forces, "contacts": contacts, "sun": at_sun, "output": at_sun * ratio**2}


def compare_with_table(path: str) -> float:
    """Largest relative difference from a table of contacts computed elsewhere."""
    columns = {"psi": ("psi", 1), "lam": ("lam", 1), "a_c_mm2": ("a_c", 1e6), "a_l_mm2": ("a_l", 1e6)}
    columns |= {"A_r_mm2": ("A_r", 1e6), "Fe_N": ("F_e", 1), "Fp_N": ("F_p", 1)}
    columns |= {"Kt_N_per_mm": ("K_t", 1e-3), "Kn_N_per_mm": ("K_n", 1e-3)}
    worst = 0.0
    with open(path, encoding="utf-8") as stream:
        for line, row in enumerate(csv.DictReader(stream), start=2):
            x = {key: float(value) for key, value in row.items() if key != "lambda"}
            result = contact(
                **{"D": x["D"], "G": x["G_mm"] * 1e-3, "F": x["F_N"], "T": x["T_N"], "mu": x["mu"]},
                **{"R1": x["R1_mm"] * 1e-3, "R2": x["R2_mm"] * 1e-3, "sign": x["sign"]},
                **{"E1": x["E1_MPa"] * 1e6, "E2": x["E2_MPa"] * 1e6, "nu1": x["nu1"], "nu2": x["nu2"]},
                **{"B": x["B_mm"] * 1e-3, "H": x["H_MPa"] * 1e6, "factor": row["lambda"]},
            )
            for column, (key, unit) in columns.items():
                mine, other = result[key] * unit, x[column]
                error = abs(mine - other) / abs(other) if other else abs(mine)
                if error > 1e-8:
                    print(f"line {line} {column}: {mine!r} here, {other!r} in the table")
                worst = max(worst, error)
    return worst


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument(
        "--table", help="compare with a CSV of contacts, columns as `asperity contact` writes"
    )
    table = parser.parse_args().table
    alpha, theta, beta = (math.degrees(x) for x in geometry(PAPER))
    print(f"alpha {alpha:.4f}, theta {theta:.4f}, beta {beta:.4f} deg")
    print(f"psi(1.4) = {domain_extension_factor(1.4):.16f}")
    print("\nForces at 5 N*m in N")
    head = [f"{'N_' + c:>7}" for c in CONTACTS] + [f"{'T_' + c:>6}" for c in CONTACTS[:3]]
    print(f"{'closure':18} {'law':9} {'ring wall':9} {'rpm':>5}", *head, f"{'F_cl':>7} {'F_cr':>7} residual")
    laws, walls = ("tangent", "secant", "nonlinear"), (None, 2e-3, 5e-3, 10e-3)
    variants = [("elastic", law, wall) for law in laws for wall in walls] + [
        ("constant_pin_force", "-", None)
    ]
    for closure, law, wall in variants:
        for rpm in (0, 6000):
            p = {**PAPER, "closure": closure, "normal_law": law, "ring_wall": wall}
            f = force_balance({**p, "sun_speed": rpm * math.pi / 30})
            wall_text = "solid" if wall is None else f"{wall * 1e3:g} mm"
            print(f"{closure:18} {law:9} {wall_text:9} {rpm:5d}", end=" ")
            print(*(f"{x:7.2f}" for x in f["normal"].values()), end=" ")
            print(*(f"{f['tangential'][c]:6.3f}" for c in CONTACTS[:3]), end=" ")
            print(*(f"{x:7.2f}" for x in f["pin"].values()), f"{f['residual']:8.0e}")
    print("\nTorsional stiffness (25), asperities only, elastic closure, 6000 rpm")
    for torque in (0.0, 1.0, 2.5, 5.0):
        started = time.perf_counter()
        result = evaluate({**PAPER, "output_torque": torque})
        seconds = time.perf_counter() - started
        print(f"{torque:4.1f} N*m: sun {result['sun']:.6e}, output {result['output']:.6e} N*m/rad", end=" = ")
        print(f"{result['output'] * math.pi / 10800:.1f} N*m/arcmin  ({seconds * 1e3:.0f} ms)")
    for name, c in result["contacts"].items():
        print(f"  {name:4}", *(f"{key} = {value:.6g}" for key, value in c.items()))
    if table:
        print(f"\nlargest relative difference from {table}: {compare_with_table(table):.1e}")


if __name__ == "__main__":
    main()
