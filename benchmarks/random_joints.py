"""Do the solvers always find the joint, or say that they did not? A million random joints of the paper's drive.

    python benchmarks/random_joints.py [--joints 1e6]

Sizes, loads, speeds, push angles, bearing friction and surfaces are drawn over wide ranges, joints that cannot exist
included. Counted are the statuses; of the joints that exist, the worst residual of equations (1)-(5) recomputed from
the forces, of the closure and of the rolling state; and how many are still open after so many steps of Newton's method.
"""

import argparse
import collections
import time

import jax
import jax.numpy as jnp
import numpy as np

from asperity.contact.fractal import Surface
from asperity.drive import force_balance, rolling_state
from asperity.drive.assembly import IDEAL_STRUCTURE
from asperity.drive.equilibrium import balance_equations
from asperity.drive.geometry import DriveGeometry
from asperity.drive.mechanism import Bearings
from asperity.joint.evaluation import Bodies, Joint, evaluate
from asperity.joint.play import NO_PLAY
from asperity.joint.status import STATUS_NAMES, joint_status
from asperity.materials import Material
from asperity.precision import use_double_precision

CHUNK = 8192
LOW_HIGH = {
    "sun_radius": (2e-3, 12e-3),
    "planet_radius": (5e-3, 20e-3),
    "loading_roller_radius": (3e-3, 10e-3),
    "ring_radius": (25e-3, 60e-3),
    "left_push_angle": (-0.6, 0.6),
    "right_push_angle": (-0.6, 0.6),
    "contact_length": (2e-3, 25e-3),
    "friction_coefficient": (0.03, 0.4),
    "fractal_dimension": (1.05, 1.95),
    "log_roughness": (np.log(1e-14), np.log(1e-8)),
    "preload": (50.0, 5000.0),
    "torque_share": (-1.5, 1.5),
    "sun_speed": (0.0, 1200.0),
    "sun_friction": (0.0, 5e-3),
    "pin_friction": (0.0, 0.3),
}
STEPS = (3, 4, 5, 6, 8, 10, 12, 16, 24)


def joint_of(x: dict[str, np.ndarray], closure: str) -> Joint:
    steel, gamma = Material(206e9, 0.3, 7850.0, 450e6, 1260e6), np.full(CHUNK, 1.5)
    count = np.where(x["sun_radius"] < 7e-3, 3.0, 2.0)
    # as a share of what friction at the sun could pass
    torque = x["torque_share"] * x["friction_coefficient"] * x["preload"] * count * x["ring_radius"]
    return Joint(
        geometry=DriveGeometry(
            *(x[name] for name in ("sun_radius", "planet_radius", "loading_roller_radius", "ring_radius")),
            count,
            x["left_push_angle"],
            x["right_push_angle"],
        ),
        bodies=Bodies(steel, steel, steel, steel),
        surfaces=(
            Surface(x["fractal_dimension"], np.exp(x["log_roughness"]), gamma, "majumdar_bhushan_1991"),
        ),
        contact_lengths=(x["contact_length"],),
        friction_coefficients=(x["friction_coefficient"],),
        planet_length=x["contact_length"],
        loading_roller_length=x["contact_length"],
        ring_wall_thickness=np.full_like(count, 20e-3),
        bearings=Bearings(
            x["sun_friction"],
            0.1 * x["sun_friction"],
            x["sun_friction"],
            x["pin_friction"],
            np.full_like(count, 4e-3),
        ),
        preload=x["preload"],
        output_torque=torque,
        sun_speed=x["sun_speed"],
        structure=IDEAL_STRUCTURE,
        play=NO_PLAY,
        closure=closure,
        closure_springs="bulk",
        contact_factor_model="printed",
        body_model="springs",
    )


def found(joint: Joint) -> dict[str, object]:
    result = evaluate(joint)
    return {
        "status": joint_status(joint, result),
        "solved": result.solved,
        "forces": result.forces,
        "stiffness": result.published.output,
        "drift": result.rolling.drift_per_output_turn,
        "rolling_residual": result.rolling.residual,
        "planet_centrifugal": result.planet_mass,
    }


def recomputed_residual(joint: Joint, forces: force_balance.DriveForces) -> np.ndarray:
    """Equations (1)-(5) without centrifugal forces, relative to the largest force; for joints that stand."""
    from asperity.drive.geometry import triangle

    # the friction of the bearings of a joint at rest acts against the motion that its torque drives
    sense = np.sign(np.asarray(forces.output_torque))
    equations = balance_equations(
        geometry=joint.geometry,
        sides=triangle(joint.geometry),
        bearings=jax.tree.map(lambda friction: sense * friction, joint.bearings),
        normal=forces.normal,
        tangential=forces.tangential,
        pin_left=forces.pin_left,
        pin_right=forces.pin_right,
        left_bearing_torque=forces.left_bearing_torque,
        right_bearing_torque=forces.right_bearing_torque,
        input_torque=forces.input_torque,
        output_torque=forces.output_torque,
        planet_centrifugal=0.0,
        roller_centrifugal=0.0,
    )
    size = np.max(np.abs(np.asarray(forces.normal)), axis=0)
    return np.max(np.abs(np.array([np.broadcast_to(each, size.shape) for each in equations])), axis=0) / size


def drawn(rng: np.random.Generator, chunk: int) -> dict[str, np.ndarray]:
    x = {name: rng.uniform(*ends, CHUNK) for name, ends in LOW_HIGH.items()}
    if chunk % 2:  # every other chunk stands still, so that its balance can be recomputed without masses
        x["sun_speed"] = np.zeros(CHUNK)
    return x


def budgets(closure: str) -> None:
    """How many joints are open after so many steps, of those that exist."""
    rng = np.random.default_rng(7)
    joint = joint_of(drawn(rng, 0), closure)
    kept = force_balance._NEWTON_BUDGET, rolling_state._NEWTON_STEPS
    still: dict[int, tuple[int, int]] = {}
    reference = jax.jit(found)(joint)
    exists = np.asarray(reference["status"]) == 0
    rolls = exists & np.isfinite(np.asarray(reference["drift"]))
    try:
        for steps in STEPS:
            force_balance._NEWTON_BUDGET = rolling_state._NEWTON_STEPS = steps

            def again(joint: Joint, steps: int = steps) -> tuple[jax.Array, jax.Array]:
                result = evaluate(joint)
                return result.solved, jnp.isfinite(result.rolling.drift_per_output_turn)

            solved, rolled = (np.asarray(each) for each in jax.jit(again)(joint))
            still[steps] = (int(np.sum(exists & ~solved)), int(np.sum(rolls & ~rolled)))
    finally:
        force_balance._NEWTON_BUDGET, rolling_state._NEWTON_STEPS = kept
    print(
        f"  {exists.sum()} joints that exist, {rolls.sum()} that roll; still open after Newton steps (rest, rolling):"
    )
    print("  " + ", ".join(f"{steps}: {rest}, {rolling}" for steps, (rest, rolling) in still.items()))


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--joints", type=float, default=1e6)
    count = int(parser.parse_args().joints)
    use_double_precision()
    for closure in ("elastic", "constant_pin_force"):
        rng, started = np.random.default_rng(2026), time.perf_counter()
        program = jax.jit(found)
        statuses: collections.Counter[str] = collections.Counter()
        worst = dict.fromkeys(("balance", "closure", "recomputed", "rolling"), 0.0)
        numbers_without_solution, chunks = 0, -(-count // CHUNK)
        for chunk in range(chunks):
            joint = joint_of(drawn(rng, chunk), closure)
            values = jax.tree.map(np.asarray, program(joint))
            status, forces = values["status"], values["forces"]
            statuses.update(STATUS_NAMES[code] for code in status)
            good = status == 0
            worst["balance"] = max(worst["balance"], float(forces.balance_residual[good].max(initial=0.0)))
            worst["closure"] = max(worst["closure"], float(forces.closure_residual[good].max(initial=0.0)))
            rolls = good & np.isfinite(values["drift"])
            worst["rolling"] = max(
                worst["rolling"], float(values["rolling_residual"][rolls].max(initial=0.0))
            )
            numbers_without_solution += int(np.sum(good & ~np.isfinite(values["stiffness"])))
            numbers_without_solution += int(np.sum(good & ~values["solved"]))
            if chunk % 2:
                again = recomputed_residual(joint, forces)
                worst["recomputed"] = max(worst["recomputed"], float(again[good].max(initial=0.0)))
        print(
            f"{closure}: {chunks * CHUNK} joints in {time.perf_counter() - started:.0f} s, compilation included"
        )
        print("  " + ", ".join(f"{name} {number}" for name, number in statuses.most_common()))
        print("  worst residual of joints that exist: " + ", ".join(f"{k} {v:.1e}" for k, v in worst.items()))
        print(f"  joints said to exist without a converged, finite stiffness: {numbers_without_solution}")
        budgets(closure)


if __name__ == "__main__":
    main()
