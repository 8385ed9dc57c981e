"""Do the solvers of planar drives always find the state, or say that they did not? Random drives of every type.

    python benchmarks/random_planar_drives.py [--drives 1e5] [--seed 2026]
        [--types zou2025,planetary,multiroller,stepped_planet,planar]

Sizes, walls, interference, friction, surfaces, speed and torque of the shipped files are drawn over wide ranges, drives
that cannot exist included. Counted are the statuses; of the drives that exist, the worst residual of the equations, of
the balance of each roller recomputed from the forces of its contacts, and of rolling; how far a contact bears more than
its friction, or less where it slides as a whole, and how many drives have one that slides; and how many are said to
exist without a finite stiffness. Drives whose rollers have no place or overlap are counted and not solved.
"""

import argparse
import collections
import math
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from asperity.drive.layout.drive import Drive, driving_sense
from asperity.drive.layout.existence import has_room
from asperity.joint.description import joint_contacts
from asperity.joint.evaluation import evaluated_with_laws
from asperity.joint.laws import drive_load
from asperity.joint.machine import joint_machine
from asperity.joint.status import NO_ROOM, STATUS_NAMES, joint_status
from asperity.joint_file.build import joint_from_values
from asperity.joint_file.case_types import CASES
from asperity.joint_file.part_names import with_tracks
from asperity.joint_file.reader import read_case
from asperity.joint_file.si_tables import replace_values, si_values
from asperity.precision import use_double_precision

CHUNK = 1024
DRAWN = 8 * CHUNK  # at once, before those without room are left out
#: Dotted paths end with these; factors by which the file's number is multiplied, evenly in their logarithm.
FACTORS = {
    "_radius": (0.7, 1.4),
    "wall_thickness": (0.3, 3.0),
    "contact_length": (0.3, 3.0),
    "interference": (0.1, 3.0),
    "preload": (0.1, 5.0),
    "friction_coefficient": (0.4, 4.0),
    "fractal_roughness": (1e-3, 1e3),
    "sun_speed": (1e-2, 5.0),
    "output_torque": (-2.5, 2.5),
}


def numbers_of(tables: Any, path: str = "") -> dict[str, float]:
    """Dotted path -> number, of the numbers that are varied."""
    if isinstance(tables, dict):
        return {
            key: value
            for name, each in tables.items()
            for key, value in numbers_of(each, f"{path}.{name}" if path else name).items()
        }
    varied = isinstance(tables, float) and any(path.endswith(end) for end in FACTORS)
    return {path: tables} if varied else {}


def drawn(rng: np.random.Generator, base: dict[str, float]) -> dict[str, np.ndarray]:
    columns = {}
    for path, value in base.items():
        low, high = next(ends for end, ends in FACTORS.items() if path.endswith(end))
        even = rng.uniform(size=DRAWN)
        factor = low + (high - low) * even if low < 0.0 else low * (high / low) ** even
        columns[path] = value * factor
    return columns


def with_room(
    rng: np.random.Generator, base: dict[str, float], rooms: Callable[..., Any], draws: int
) -> Iterator[tuple[np.ndarray, int]]:
    """At most CHUNK drives with room for their rollers, shape (numbers, drives), and how many without were drawn."""
    left, unfit = np.empty((len(base), 0)), 0
    for draw in range(draws):
        columns = np.stack(list(drawn(rng, base).values()))
        fits = np.asarray(rooms(*columns))
        left = np.concatenate([left, columns[:, fits]], axis=1)
        unfit += int(np.sum(~fits))
        while left.shape[1] >= CHUNK or (draw == draws - 1 and left.size):
            yield left[:, :CHUNK], unfit
            left, unfit = left[:, CHUNK:], 0
    if unfit:
        yield left, unfit


def recomputed(
    drive: Drive, normal: jax.Array, tangential: jax.Array, pins: jax.Array, outward: jax.Array
) -> jax.Array:
    """Forces and moments on each roller that is not on the axis, from those of its contacts, over the largest force."""
    names = [body.name for body in drive.bodies]
    force = list(jnp.zeros((len(names), 2)).at[jnp.array(drive.floating)].set(outward))
    moment = [jnp.zeros(()) for _ in names]
    sense = driving_sense(drive)
    for k, contact in enumerate(drive.contacts):
        one, two = names.index(contact.first), names.index(contact.second)
        turned = (
            2.0 * jnp.pi * contact.sector / drive.sectors
        )  # the second body may be that of the next sector
        there = jnp.array([[jnp.cos(turned), -jnp.sin(turned)], [jnp.sin(turned), jnp.cos(turned)]])
        between = there @ drive.centres[two] - drive.centres[one]
        apart = jnp.where(jnp.hypot(*between) > 0.0, jnp.hypot(*between), 1.0)
        # from the first body's centre to the contact: towards the second, or away from it inside a ring
        radial = jnp.where(contact.internal, -1.0, 1.0) * between / apart
        along = jnp.array([-radial[1], radial[0]])
        pressing = normal[k] * radial
        # the first body drives the second where it turns counter-clockwise relative to the carrier
        driving = sense[k] * tangential[k] * along
        force[one] = force[one] - pressing - driving
        force[two] = force[two] + there.T @ (pressing + driving)
        moment[one] = moment[one] - drive.first_radius[k] * sense[k] * tangential[k]
        inside = 1.0 if contact.internal else -1.0
        moment[two] = moment[two] + inside * drive.second_radius[k] * sense[k] * tangential[k]
    left = []
    for number in drive.floating:
        rest = force[number]
        if number in drive.pinned:  # a pin may push along the tangent of its circle only
            radius = drive.centres[number] / jnp.hypot(*drive.centres[number])
            push = jnp.array([-radius[1], radius[0]])
            rest = jnp.array(
                [rest @ radius, jnp.abs(rest @ push) - jnp.abs(pins[drive.pinned.index(number)])]
            )
        left += [rest, moment[number][None] / jnp.max(drive.first_radius)]
    return jnp.max(jnp.abs(jnp.concatenate(left))) / jnp.max(jnp.abs(normal))


def rooms_of(values: dict[str, Any], paths: tuple[str, ...]) -> Callable[..., Any]:
    """Whether there is room for the rollers: a small program, for all that is drawn."""

    def one(*numbers: jax.Array) -> jax.Array:
        return has_room(
            joint_from_values(replace_values(values, dict(zip(paths, numbers, strict=True)))).drive
        )

    return jax.jit(jax.vmap(one))


def program_of(values: dict[str, Any], paths: tuple[str, ...]) -> Callable[..., Any]:
    def one(*numbers: jax.Array) -> dict[str, Any]:
        joint = joint_from_values(replace_values(values, dict(zip(paths, numbers, strict=True))))
        result, _ = evaluated_with_laws(joint)
        load = drive_load(joint_machine(joint))
        forces = result.forces
        used = jnp.abs(forces.tangential) / joint_contacts(joint).pairs.friction_coefficient / forces.normal
        slides = result.diagnostics.slip_ratio == 1.0
        return {
            "status": joint_status(joint, result),
            "equations": jnp.maximum(forces.balance_residual, forces.closure_residual),
            "recomputed": recomputed(
                joint.drive, forces.normal, forces.tangential, forces.pins, load.body_force
            ),
            "friction": jnp.max(jnp.where(slides, jnp.abs(used - 1.0), used - 1.0)),
            "slides": jnp.any(slides),
            "stiffness": result.assembly.stiffness.output,
            "drift": result.rolling.drift_per_output_turn,
            "rolling": result.rolling.residual,
        }

    return jax.jit(jax.vmap(one))


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--drives", type=float, default=1e5, help="of each type")
    parser.add_argument("--types", default=",".join(CASES))
    parser.add_argument("--seed", type=int, default=2026, help="of the drives: other ones in another run")
    given = parser.parse_args()
    use_double_precision()
    folder = Path(__file__).parents[1] / "examples"
    for name in given.types.split(","):
        values = with_tracks(si_values(read_case(folder / f"{name}.toml")))
        base = numbers_of(values)
        rng, program = np.random.default_rng(given.seed), program_of(values, tuple(base))
        rooms, numbers = rooms_of(values, tuple(base)), tuple(base.values())
        started = time.perf_counter()
        jax.block_until_ready(program(*(np.full(CHUNK, number) for number in numbers)))
        jax.block_until_ready(rooms(*(np.full(DRAWN, number) for number in numbers)))
        compiled, started = time.perf_counter() - started, time.perf_counter()
        statuses: collections.Counter[str] = collections.Counter()
        worst = dict.fromkeys(("equations", "recomputed", "friction", "rolling"), 0.0)
        without, slide, slips_rolling, draws = 0, 0, 0, math.ceil(given.drives / DRAWN)
        for columns, unfit in with_room(rng, base, rooms, draws):
            statuses[STATUS_NAMES[NO_ROOM]] += unfit
            count = columns.shape[1]
            if count == 0:
                continue
            filled = np.pad(columns, ((0, 0), (0, -count % CHUNK)), mode="edge")
            found = {key: np.asarray(each)[:count] for key, each in program(*filled).items()}
            statuses.update(STATUS_NAMES[code] for code in found["status"])
            good = found["status"] == 0
            without += int(np.sum(good & ~(np.isfinite(found["stiffness"]) & (found["stiffness"] > 0.0))))
            rolls = good & np.isfinite(found["drift"])
            slips_rolling += int(np.sum(good & ~rolls))
            slide += int(np.sum(good & found["slides"]))
            for key in ("equations", "recomputed", "friction"):
                worst[key] = max(worst[key], float(found[key][good].max(initial=0.0)))
            worst["rolling"] = max(worst["rolling"], float(found["rolling"][rolls].max(initial=0.0)))
        seconds = time.perf_counter() - started
        print(
            f"{name}: {draws * DRAWN} drives, {draws * DRAWN / seconds:.0f} a second "
            f"(first call {compiled:.0f} s), {len(base)} numbers varied"
        )
        print("  " + ", ".join(f"{status} {number}" for status, number in statuses.most_common()))
        print("  worst residual of drives that exist: " + ", ".join(f"{k} {v:.1e}" for k, v in worst.items()))
        print(
            f"  said to exist without a finite stiffness: {without}; with a contact that slides: {slide}; "
            f"stand, but do not roll: {slips_rolling}"
        )


if __name__ == "__main__":
    main()
