"""The joint as rigid rollers on springs, assembled as dense matrices: a second opinion on (25) and (A8).

All rollers of all branches are rigid bodies in the plane, three degrees of freedom each; the ring is fixed.
Every contact has a normal and a tangential spring between the two bodies' points of contact; a pin holds each
loading roller along the carrier's push. The Hessian of the elastic energy is assembled from the springs'
direction vectors and condensed onto one rotation. Rigid springs are constraints, not large numbers.

    python benchmarks/baseline_assembly.py
"""

import math

import numpy as np
from baseline_scipy import (
    CONTACTS,
    PAPER,
    compression,
    evaluate,
    force_balance,
    geometry,
    normal_stiffness,
    pairs,
    torsional_stiffness,
)
from scipy.linalg import null_space

RIGID = math.inf


def torsional_stiffness_of_assembly(p, normal, tangential, *, pin=RIGID, pin_across=0.0, turned="sun"):
    """Torque per angle at the sun with the carrier held, or at the carrier with the sun held, in N*m/rad.

    Spring constants by contact name in N/m; ``pin`` along the carrier's push, ``pin_across`` across it.
    """
    Rs, Rp, Rw, Ro = (p[k] for k in ("sun_radius", "planet_radius", "loading_roller_radius", "ring_radius"))
    alpha, _, _ = geometry(p)
    bodies = {"s": (np.zeros(2), Rs)}
    for i in range(p["planets"]):
        polar = 2 * math.pi * i / p["planets"]
        for name, angle, radius, size in (
            ("p", polar, Rs + Rp, Rp),
            ("wr", polar + alpha, Ro - Rw, Rw),
            ("wl", polar - alpha, Ro - Rw, Rw),
        ):
            bodies[f"{name}{i}"] = (radius * np.array([math.sin(angle), math.cos(angle)]), size)
    index = {name: 3 * j for j, name in enumerate(bodies)}
    size = 3 * len(bodies)
    carrier = size  # rotation of the carrier times R_o: the last degree of freedom
    rows, constants = [], []

    def spring(first, second, point, direction, constant):
        """Spring between two bodies' material points at `point`; body None is the ring, "c" the carrier."""
        row = np.zeros(size + 1)
        for body, sign in ((first, 1.0), (second, -1.0)):
            if body is None:
                continue
            if body == "c":
                row[carrier] += sign * np.array([-point[1], point[0]]) @ direction / Ro
                continue
            centre, radius = bodies[body]
            arm = point - centre
            j = index[body]
            row[j : j + 2] += sign * direction
            # displacement of the point by a rotation phi (counter-clockwise) is phi x arm; unknown is R phi
            row[j + 2] += sign * np.array([-arm[1], arm[0]]) @ direction / radius
        rows.append(row)
        constants.append(constant)

    def contact(first, second, point, axis, name):
        n = axis / np.linalg.norm(axis)
        spring(first, second, point, n, normal[name])
        spring(first, second, point, np.array([-n[1], n[0]]), tangential[name])

    for i in range(p["planets"]):
        planet, _ = bodies[f"p{i}"]
        contact("s", f"p{i}", planet * Rs / np.linalg.norm(planet), planet, "sp")
        for side, turn in (("r", 1.0), ("l", -1.0)):
            roller, _ = bodies[f"w{side}{i}"]
            axis = roller - planet
            contact(f"p{i}", f"w{side}{i}", planet + axis * Rp / np.linalg.norm(axis), axis, f"pw{side}")
            out = roller / np.linalg.norm(roller)
            contact(f"w{side}{i}", None, out * Ro, out, f"w{side}o")
            gamma = p["push_angle_right" if side == "r" else "push_angle_left"]
            tangent = turn * np.array([out[1], -out[0]])  # away from the planet
            push = -math.cos(gamma) * tangent + math.sin(gamma) * out
            across = np.array([-push[1], push[0]])
            spring(f"w{side}{i}", "c", roller, push, pin)
            if pin_across:
                spring(f"w{side}{i}", "c", roller, across, pin_across)

    B, k = np.array(rows), np.array(constants)
    held, lever, arm = (carrier, 2, Rs) if turned == "sun" else (2, carrier, Ro)
    B = np.delete(B, held, axis=1)
    unit_torque = np.delete(np.eye(size + 1)[lever] / arm, held)
    rigid = ~np.isfinite(k)
    Z = null_space(B[rigid], rcond=1e-9) if rigid.any() else np.eye(size)
    hessian = Z.T @ (B[~rigid].T @ (k[~rigid, None] * B[~rigid])) @ Z
    return 1 / float((Z.T @ unit_torque) @ np.linalg.solve(hessian, Z.T @ unit_torque))


def bulk_springs(p, forces, secant=False):
    """Normal and tangential springs of smooth elastic rollers at the given loads (Johnson 1985).

    In shear the strip that sticks, sqrt(1 - T/(mu N)) of the whole, takes the place of the whole in the logarithm.
    """
    nu, mu = p["poisson_ratio"], p["friction_coefficient"]
    if secant:
        normal = {
            c: forces["normal"][c] / compression(forces["normal"][c], *pair) for c, pair in pairs(p).items()
        }
    else:
        normal = {c: normal_stiffness(forces["normal"][c], *pair) for c, pair in pairs(p).items()}
    scale = 2 * (1 - nu**2) / (math.pi * p["young_modulus"] * p["contact_length"])
    left = {c: 1 - forces["tangential"][c] / (mu * forces["normal"][c]) for c in CONTACTS}
    return normal, {c: 1 / (1 / k - scale * math.log(left[c])) for c, k in normal.items()}


def in_series(first, second):
    return {c: 1 / (1 / first[c] + 1 / second[c]) for c in CONTACTS}


def side_by_side(p, K):
    """(A7) with each loading roller's two contacts in series first: the topology that the rollers have."""
    sides = sum(1 / (1 / K[f"pw{side}"] + 1 / K[f"w{side}o"]) for side in "rl")
    return p["planets"] * p["sun_radius"] ** 2 / (1 / K["sp"] + 1 / sides)


def report(torque, rpm, ring_wall):
    p = {**PAPER, "output_torque": torque, "sun_speed": rpm * math.pi / 30, "ring_wall": ring_wall}
    forces = force_balance(p)
    result = evaluate(p)
    rough_t = {c: result["contacts"][c]["K_t"] for c in CONTACTS}
    rough_n = {c: result["contacts"][c]["K_n"] for c in CONTACTS}
    bulk_n, bulk_t = bulk_springs(p, forces)
    both_n, both_t = in_series(rough_n, bulk_n), in_series(rough_t, bulk_t)
    rigid = dict.fromkeys(CONTACTS, RIGID)
    ratio = ((p["ring_radius"] - p["sun_radius"]) / p["sun_radius"]) ** 2
    wall = "solid ring" if ring_wall is None else f"ring wall {ring_wall * 1e3:g} mm"
    print(f"\n{torque:g} N*m, {rpm} rpm, {wall}; at the output, N*m/rad (N*m/arcmin)")

    def line(name, at_sun):
        print(f"  {name:66} {at_sun * ratio:11.4e} ({at_sun * ratio * math.pi / 10800:8.2f})")

    assembled = torsional_stiffness_of_assembly
    line("asperities only, (25)", torsional_stiffness(p, rough_t))
    line("bulk only, (25)", torsional_stiffness(p, bulk_t))
    line("both in series, (25)", torsional_stiffness(p, both_t))
    line("asperities only, assembly", assembled(p, rough_n, rough_t))
    line("bulk only, assembly", assembled(p, bulk_n, bulk_t))
    line("both in series, assembly", assembled(p, both_n, both_t))
    secant_n, secant_t = bulk_springs(p, forces, secant=True)
    line("bulk only, (25), secant springs", torsional_stiffness(p, secant_t))
    line("bulk only, assembly, secant springs", assembled(p, secant_n, secant_t))
    held = {"pin_across": RIGID}
    line("bulk only, assembly, rollers held in both directions", assembled(p, bulk_n, bulk_t, **held))
    line("the same, secant springs", assembled(p, secant_n, secant_t, **held))
    line("bulk only, assembly, pins of 1e8 N/m", assembled(p, bulk_n, bulk_t, pin=1e8))
    line("bulk only, assembly, rigid tangentially", assembled(p, bulk_n, dict.fromkeys(CONTACTS, 1e15)))
    line("bulk tangential springs, rigid normal springs and pins, assembly", assembled(p, rigid, bulk_t))
    line("the same by rollers' contacts in series, sides in parallel", side_by_side(p, bulk_t))
    for name, springs in (("bulk", bulk_t), ("asperities", rough_t)):
        stiff = assembled(p, rigid, springs)
        error = stiff / torsional_stiffness(p, springs) - 1
        print(f"  rigid normal springs, {name}: against (A7) {error:+.1e},", end="")
        print(f" against series-then-parallel {stiff / side_by_side(p, springs) - 1:+.1e}")
    at_sun, at_carrier = (assembled(p, both_n, both_t, turned=where) for where in ("sun", "carrier"))
    error = at_carrier / ratio / at_sun - 1
    print(f"  carrier turned with the sun held, over {ratio:g} x sun turned: {error:+.1e}")


def plausibility():
    """Hertz against the contact law, section 7 of the model."""
    p = {**PAPER, "output_torque": 0.0, "sun_speed": 0.0}
    contacts = evaluate(p)["contacts"]
    forces = force_balance(p)["normal"]
    columns = ("N/N", "b/um", "p0/MPa", "2bB/mm2", "A_r/mm2", "a_l/mm2", "delta/um", "k_bulk", "K_n rough")
    print("\ncontact", *(f"{name:>9}" for name in columns), "(stiffness in N/m)")
    for c, (R1, R2, sign, B, E, nu, wall) in pairs(p).items():
        R = R1 * R2 / (R1 + R2 if sign > 0 else R2 - R1)
        N, pair = forces[c], (R1, R2, sign, B, E, nu, wall)
        b = math.sqrt(4 * N * R / (math.pi * B * E / (2 * (1 - nu**2))))
        areas = 2 * b * B, contacts[c]["A_r"], contacts[c]["a_l"]
        row = [N, b * 1e6, 2 * N / (math.pi * b * B) * 1e-6, *(area * 1e6 for area in areas)]
        row += [compression(N, *pair) * 1e6]
        print(f"{c:7}", *(f"{x:9.3f}" for x in row), end=" ")
        print(f"{normal_stiffness(N, *pair):9.3e} {contacts[c]['K_n']:9.3e}")


def main() -> None:
    for torque in (0.0, 5.0):
        for rpm in (0, 6000):
            report(torque, rpm, None)
    for wall in (2e-3, 5e-3, 10e-3):
        report(0.0, 0, wall)
    plausibility()


if __name__ == "__main__":
    main()
