"""Torsional stiffness of planar joints on its three levels, by hand."""

import dataclasses
import math
from types import SimpleNamespace

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.body.compliance import compliance_matrix, modes_needed
from asperity.body.coupling import coupled_compliance
from asperity.errors import AsperityError
from asperity.joint.bodies import exact_bodies
from asperity.joint.body_compliance import body_compliance
from asperity.joint.contacts import LoadedContacts, loaded_contacts
from asperity.joint.description import joint_contacts
from asperity.joint.evaluation import evaluate
from asperity.joint.machine import joint_machine
from asperity.joint.solve import solve_joint
from asperity.joint.stiffness import (
    loaded_stiffness,
    springs_of_compliance,
    stiffness_levels,
    widths_of_bodies,
)
from asperity.joint_file.build import joint_from_values
from asperity.joint_file.si_tables import replace_values
from asperity.standing.windup import windup

ORBIT, COUNT = 30e-3, 3  # of the planetary example


def in_series(*stiffness):
    return 1.0 / sum(1.0 / each for each in stiffness)


def test_stiffness_of_the_planetary_by_hand(planetary):
    """Slips T/k of sun and ring contact turn the carrier by their sum over twice the orbit."""
    _, _, document = planetary
    contacts, levels = document["standing"]["contacts"], document["torsional_stiffness"]

    def output(*names):
        springs = [
            in_series(*(contact[f"{name}_stiffness_N_per_m"] for name in names))
            for contact in contacts.values()
        ]
        return (2.0 * ORBIT) ** 2 * COUNT * in_series(*springs)

    bodies = output("asperity_tangential", "bulk_tangential")
    assert levels["series_with_bulk"]["output_Nm_per_rad"] == pytest.approx(bodies, rel=1e-9)
    assert levels["published"]["output_Nm_per_rad"] == pytest.approx(output("asperity_tangential"), rel=1e-9)
    # the free ring bends: the assembly is softer
    assert levels["assembly"]["output_Nm_per_rad"] < bodies
    assert levels["assembly"]["input_Nm_per_rad"] == pytest.approx(
        levels["assembly"]["output_Nm_per_rad"] / 36.0, rel=1e-12
    )
    shares = document["stiffness_budget"]
    # its free ring bends in the springs of the contacts
    names = ("tangential", "normal", "ring_bending", "pin", "planet_support", "input_shaft", "output_shaft")
    assert set(shares) == {f"{name}_share" for name in (*names, "loading_cam")}
    total = sum(sum(s.values()) if isinstance(s, dict) else s for s in shares.values())
    assert total == pytest.approx(1.0, rel=1e-9)


@pytest.mark.slow
def test_shafts_are_in_series_with_the_whole(planetary):
    """1/k = 1/k_drive + 1/(ratio^2 k_input) + 1/k_output, and so are their shares; the levels below have no shafts."""
    joint, solution, _ = planetary
    springs, forces = dataclasses.replace(joint, body_model="springs"), solution.result.forces
    contacts = joint_contacts(springs)
    loaded = LoadedContacts(
        half_width=contacts.pairs.half_width(forces.normal),
        traction=abs(forces.tangential) / (0.08 * forces.normal),
        rough=solution.result.contacts,
        interfaces=solution.result.interfaces,
    )
    published, held, alone = stiffness_levels(joint_machine(springs), loaded, jnp.zeros(2), jnp.zeros(1))
    rigid = float(alone.stiffness.output)
    # a planet on a rigid pin moves radially only: free centres change nothing
    assert rigid == pytest.approx(float(held.output), rel=1e-9)
    entry, out = rigid / 36.0, 4.0 * rigid
    shafts = dataclasses.replace(springs, input_shaft_stiffness=entry, output_shaft_stiffness=out)
    same, _, whole = stiffness_levels(joint_machine(shafts), loaded, jnp.zeros(2), jnp.zeros(1))
    assert float(whole.stiffness.output) == pytest.approx(rigid / 2.25, rel=1e-9)
    assert float(whole.input_shaft_share) == pytest.approx(1.0 / 2.25, rel=1e-9)
    assert float(whole.output_shaft_share) == pytest.approx(0.25 / 2.25, rel=1e-9)
    assert float(sum(whole.tangential_share)) == pytest.approx(1.0 / 2.25, rel=1e-9)
    assert float(published.output) == float(same.output)


@pytest.fixture
def under_forces(planetary, monkeypatch):
    """Stiffness under forces as if contacts, walls and the drive were these; and what they were asked for."""
    joint, solution, _ = planetary
    result, asked = solution.result, {}

    def of(normal, tangential, slides, solved=None, stiff=(1e8, 2e8)):
        def contacts_under(*, contacts, normal_force, tangential_force):
            asked["tangential"] = np.asarray(tangential_force)
            return LoadedContacts(
                half_width=jnp.ones(2),
                traction=jnp.array([0.5, 0.5]),
                rough=dataclasses.replace(result.contacts, normal_stiffness=jnp.array(stiff)),
                interfaces=result.interfaces,
                lines=None if solved is None else SimpleNamespace(solved=jnp.array(solved)),
            )

        def levels(machine, loaded, sliding_friction, pin_force):
            asked["friction"] = np.asarray(sliding_friction)
            return result.published, result.series_with_bulk, result.assembly

        monkeypatch.setattr("asperity.joint.stiffness.loaded_contacts", contacts_under)
        monkeypatch.setattr("asperity.joint.stiffness.stiffness_levels", levels)
        monkeypatch.setattr("asperity.joint.stiffness.walls_known", lambda **_: jnp.array(True))
        forces = (jnp.asarray(each, dtype=float) for each in (normal, tangential, slides))
        return loaded_stiffness(joint_machine(joint), *forces, jnp.zeros(1))

    return of, asked


def test_a_contact_that_slides_bears_its_friction_and_has_no_tangential_stiffness(under_forces):
    """mu = 0.08: of 300 N the contact that holds bears 240 N less the tolerance of slip, in either sense."""
    of, asked = under_forces
    found = of((3000.0, 3000.0), (-300.0, 240.0), (0.0, 1.0))
    assert asked["tangential"] == pytest.approx([-240.0, 0.0], rel=1e-10)
    assert asked["tangential"][0] > -240.0
    assert asked["friction"] == pytest.approx([0.0, 0.08], rel=1e-12)
    np.testing.assert_array_equal(found.contacts.traction, [0.5, 1.0])
    for stiffness in (
        found.contacts.rough.tangential_stiffness,
        found.contacts.interfaces.asperity_tangential,
        found.contacts.interfaces.bulk_tangential,
    ):
        assert (float(stiffness[0]) > 0.0, float(stiffness[1])) == (True, 0.0)


def test_only_a_loaded_contact_needs_an_elastic_spot_and_slices(under_forces):
    of, _ = under_forces
    for normal, stiff, solved, law, walls in (
        ((3000.0, 0.0), (1e8, 0.0), (True, False), True, True),
        ((3000.0, 10.0), (1e8, 0.0), (True, True), False, True),
        ((3000.0, 10.0), (1e8, 1e8), (True, False), True, False),
    ):
        found = of(normal, (0.0, 0.0), (0.0, 0.0), solved, stiff)
        assert (bool(found.contact_law_holds), bool(found.walls_hold)) == (law, walls)
        assert np.isfinite(float(found.published.output)) == law
        assert np.isfinite(float(found.assembly.stiffness.output)) == (law and walls)


REST = {"output_torque": 1e-6, "sun_speed": 0.0}


@pytest.fixture
def solved(evaluated_together):
    return evaluated_together


@pytest.fixture
def output(evaluated_together):
    return lambda joint: evaluated_together(joint).assembly.stiffness.output


@pytest.fixture
def joint(paper_joint):
    return paper_joint


@pytest.mark.long
@pytest.mark.parametrize("support", ["free", "rigid_housing"])
def test_the_papers_joint_over_the_wall_of_its_ring(joint, load_example, support, output):
    """With asperities too stiff to count, against the bodies alone of examples/ring_wall.py: one matrix a body."""
    walls = np.array([4e-3, 10e-3, 20e-3, 60e-3])
    stiff = {"fractal_dimension": 1.9, "fractal_roughness": 1e-20}
    found = output(joint(ring_wall_thickness=walls, ring_support=support, **stiff, **REST))
    expected = load_example("ring_wall").stiffness_over_wall(
        walls, {"free": 0.0, "rigid_housing": math.inf}[support]
    )
    assert found == pytest.approx(expected, rel=1e-6)


@pytest.mark.long
def test_the_matrix_of_the_machine_is_the_sum_of_those_of_its_bodies(joint):
    """Every body summed mode by mode with the Bessel functions of its contacts; hollow rollers and a free ring."""
    made = joint(
        ring_support="free", drive__planet_bore_diameter=15e-3, drive__loading_roller_bore_diameter=4e-3
    )
    members = exact_bodies(made)
    widths = np.array([8.3e-5, 7.4e-5, 6.2e-5, 9.1e-5, 7.6e-5])
    sticks = np.array([6e-5, 5e-5, 4e-5, 3e-5, 2e-5])
    total = jax.jit(coupled_compliance)(
        bodies=members, contact_lengths=np.full(5, 5e-3), half_widths=widths, stick_half_widths=sticks
    )
    expected = np.zeros((10, 10))
    one = jax.jit(compliance_matrix, static_argnames=("copies", "mode_count"))
    for member in members:
        pick = np.array(member.contacts)
        copies = 1 if member.sectors is None else int(member.sectors)
        inner, outer = (
            getattr(member.body, f"{side}_radius", size) for side, size in (("inner", 1.0), ("outer", 3.0))
        )
        own = one(
            body=member.body,
            contact_angles=np.asarray(member.contact_angles),
            half_widths=widths[pick],
            stick_half_widths=sticks[pick],
            copies=copies,
            mode_count=modes_needed(inner_radius=float(inner), outer_radius=float(outer), copies=copies) + 20,
        )
        both = np.concatenate([pick, pick + 5])
        expected[np.ix_(both, both)] += own
    assert np.asarray(total) == pytest.approx(expected, rel=1e-9, abs=1e-9 * expected.max())


@pytest.mark.long
def test_bodies_of_unequal_contacts(joint):
    """A contact half as long as its body compresses its surroundings on half the length; the body bends as a whole."""
    members = exact_bodies(joint())
    widths = np.array([8.3e-5, 7.4e-5, 6.2e-5, 9.1e-5, 7.6e-5])
    lengths = np.array([2.5e-3, 5e-3, 5e-3, 5e-3, 5e-3])
    even, uneven = (
        np.asarray(
            coupled_compliance(
                bodies=members, contact_lengths=each, half_widths=widths, stick_half_widths=0.7 * widths
            )
        )
        for each in (np.full(5, 5e-3), lengths)
    )
    change = uneven - even
    for spring, width in ((0, widths[0]), (5, 0.7 * widths[0])):
        kolosov, shear = 1.8, 206e9 / 2.6
        # the closed sums at the contact itself, of which ln(2/a) is the leading part
        local = sum((kolosov + 1.0) * math.log(2.0 * r / width) - kolosov for r in (4e-3, 13.5e-3))
        assert change[spring, spring] == pytest.approx(local / (4.0 * math.pi * shear * 5e-3), rel=2e-3)
        change[spring, spring] = 0.0
    assert np.max(np.abs(change)) < 1e-20


@pytest.mark.slow
def test_shear_follows_the_logarithm_of_the_traction(joint):
    r"""The zone that sticks gives :math:`C(T) - C(0) = \sum (1-\nu^2)/(\pi E B) \ln[1/(1-T/\mu N)]`, Cattaneo."""
    made = joint()
    machine = joint_machine(made)
    contacts = machine.contacts
    normal = jnp.array([1000.0, 657.0, 465.0, 647.0, 449.0])

    def compliance(share):
        loaded = loaded_contacts(
            contacts=contacts, normal_force=normal, tangential_force=share * 0.12 * normal
        )
        width, stick = widths_of_bodies(contacts=contacts, loaded=loaded)
        bodies = body_compliance(machine=machine, half_width=width, stick_half_width=stick)
        springs = springs_of_compliance(compliance=bodies, half_width=width, loaded=loaded)
        return 1.0 / springs.tangential_stiffness - 1.0 / loaded.interfaces.asperity_tangential

    added = 2.0 * (1.0 - 0.3**2) / (math.pi * 206e9 * 5e-3) * math.log(1.0 / (1.0 - 0.6))
    assert compliance(0.6) - compliance(0.0) == pytest.approx(np.full(5, added), rel=5e-3)


@pytest.mark.long
def test_a_housing_lies_between_a_free_ring_and_a_rigid_housing(joint, output):
    housing = np.array([0.0, 1e6, 1e10, 1e11, 1e12, 1e13])
    found = output(
        joint(
            ring_wall_thickness=np.full(6, 8e-3),
            ring_support="elastic_housing",
            compliance__ring_housing_stiffness=housing,
        )
    )
    free, held = (
        float(output(joint(ring_wall_thickness=8e-3, ring_support=s))) for s in ("free", "rigid_housing")
    )
    assert found[0] == pytest.approx(free, rel=1e-12)
    assert found[1] == pytest.approx(free, rel=1e-3)
    assert np.all(np.diff(found) > 0.0)
    assert 0.9 * held < found[-1] < held


@pytest.mark.long
def test_a_ring_with_its_own_spring_keeps_the_spring(joint, solved):
    """ring_bending_stiffness stays a spring under each loading roller of a ring in a rigid housing."""
    found, plain = solved(joint(compliance__ring_bending_stiffness=6.3e7)), solved(joint())
    share = float(found.assembly.ring_bending_share)
    assert share == pytest.approx(
        1.0 - float(found.assembly.stiffness.output / plain.assembly.stiffness.output), abs=0.03
    )


@pytest.mark.long
def test_springs_and_exact_bodies_agree_for_a_ring_in_a_rigid_housing(joint, output):
    walls = np.array([6e-3, 10e-3, 20e-3, 60e-3])
    springs, exact = (
        output(joint(ring_wall_thickness=walls, body_model=model)) for model in ("springs", "exact")
    )
    assert exact == pytest.approx(springs, rel=0.02)


@pytest.mark.long
def test_published_series_assembled_in_this_order(joint, solved):
    """Floating planets make the assembly the softest level by far, with exact bodies as well."""
    rng = np.random.default_rng(5)
    count = 64
    found = solved(
        joint(
            planet_radius=rng.uniform(13.2e-3, 13.8e-3, count),
            contact_length=rng.uniform(4e-3, 20e-3, count),
            fractal_dimension=rng.uniform(1.2, 1.9, count),
            preload=rng.uniform(300.0, 3000.0, count),
            ring_wall_thickness=rng.uniform(5e-3, 60e-3, count),
            output_torque=rng.uniform(0.1, 3.0, count),
            ring_support="free",
        )
    )
    levels = [
        np.asarray(level.output)
        for level in (found.published, found.series_with_bulk, found.assembly.stiffness)
    ]
    works = np.asarray(found.solved) & (np.max(np.asarray(found.diagnostics.slip_ratio), axis=0) < 1.0)
    works &= np.isfinite(levels[0])  # nan where all spots of a contact are plastic
    assert works.sum() > 32
    assert np.all((levels[0] >= levels[1])[works])
    assert np.all((levels[1] > 2.0 * levels[2])[works])


@pytest.mark.long
def test_held_planets_may_exceed_the_series(joint, solved):
    """Where planets do not float, contacts that move along with their neighbours are stiffer than springs in series."""
    held = {"compliance__planet_support_stiffness": 1e15, "compliance__pin_transverse_stiffness": 1e15}
    springs, exact = (solved(joint(**held, body_model=model)) for model in ("springs", "exact"))
    assert float(springs.assembly.stiffness.output / springs.series_with_bulk.output) == pytest.approx(
        1.0, rel=1e-5
    )
    assert 1.0 < float(exact.assembly.stiffness.output / exact.series_with_bulk.output) < 1.1


@pytest.mark.slow
def test_shares_of_the_compliance_add_up(joint, solved):
    assembly = solved(joint(ring_support="free")).assembly
    shares = [np.sum(share) for name, share in vars(assembly).items() if name.endswith("_share")]
    assert sum(shares) == pytest.approx(1.0, abs=1e-12)


@pytest.mark.long
def test_derivatives_forward_and_reverse(paper_values):
    values = paper_values(ring_support="free")
    drive, load = values["drive"], values["load"]

    def of(x):
        changes = {
            "drive.ring_wall_thickness": drive["ring_wall_thickness"] * x[0],
            "load.preload": load["preload"] * x[1],
            "drive.planet_radius": drive["planet_radius"] * x[2],
            "load.output_torque": load["output_torque"] * x[3],
        }
        made = joint_from_values(replace_values(values, changes))
        return evaluate(made).assembly.stiffness.output

    here, step = jnp.ones(4), 1e-4
    value = jax.jit(of)
    expected = [(value(here.at[k].add(step)) - value(here.at[k].add(-step))) / (2 * step) for k in range(4)]
    reverse = jax.jit(jax.grad(of))(here)
    assert reverse == pytest.approx(np.array(expected), rel=2e-5)
    assert jax.jit(jax.jacfwd(of))(here) == pytest.approx(np.asarray(reverse), rel=1e-9)


@pytest.mark.slow
def test_the_number_of_planets_may_differ_within_a_batch(joint, output):
    counts = np.array([2.0, 3.0, 2.0])
    batch = output(joint(planet_count=counts, ring_support="free"))
    alone = [float(output(joint(planet_count=float(n), ring_support="free"))) for n in counts]
    assert batch == pytest.approx(np.array(alone), rel=1e-12)


@pytest.mark.long
def test_a_wall_too_thin_for_exact_bodies_is_refused(joint):
    """Five half-widths of 90 um are 0.45 mm."""
    thin = {"ring_wall_thickness": 0.4e-3}
    with pytest.raises(AsperityError, match="walls"):
        solve_joint(joint(**thin))
    found = solve_joint(joint(**thin, body_model="springs")).result
    assert float(found.assembly.stiffness.output) > 0.0


@pytest.mark.slow
def test_every_wall_that_is_admitted_has_a_stiffness(joint, solved):
    walls = np.geomspace(0.1e-3, 50e-3, 60)
    result = solved(joint(ring_wall_thickness=walls, ring_support="free", preload=1.0, **REST))
    holds, found = np.asarray(result.walls_hold), np.asarray(result.assembly.stiffness.output)
    assert np.array_equal(holds, np.isfinite(found))
    assert 0 < np.sum(~holds) < 20
    assert np.all(np.diff(found[holds]) > 0.0)


@pytest.mark.long
def test_hollow_planets_make_the_joint_softer(joint, solved, output):
    bores = np.array([0.01e-3, 8e-3, 16e-3, 22e-3])
    found = solved(joint(ring_wall_thickness=np.full(4, 20e-3), drive__planet_bore_diameter=bores))
    at = np.asarray(found.assembly.stiffness.output)
    assert at[0] == pytest.approx(float(output(joint(ring_wall_thickness=20e-3))), rel=1e-4)
    assert np.all(np.diff(at) < 0.0)
    assert at[-1] < 0.7 * at[0]
    mass = 7850.0 * math.pi * (13.5e-3**2 - (bores / 2) ** 2) * 5e-3
    assert np.asarray(found.masses[1]) == pytest.approx(mass, rel=1e-12)


@pytest.mark.long
def test_the_wind_up_integrates_the_exact_bodies(joint, output):
    made = joint(ring_support="free")
    found = windup(made, largest_torque=4.0, level="assembly", stage_shares=(0.3, 0.6))
    at = float(output(dataclasses.replace(made, output_torque=np.asarray(4.0))))
    assert float(found.stiffness[-1]) == pytest.approx(at, rel=1e-9)


def test_springs_of_contacts_are_bodies_and_asperities_in_series_by_hand():
    """Two contacts, 2 and 4 m/N normal, 6 and 8 tangential; the second only touches, with a crown of 1 m/N."""
    compliance = jnp.array(np.diag([2.0, 4.0, 6.0, 8.0]) + 0.5 * (1.0 - np.eye(4)))
    interfaces = SimpleNamespace(
        normal=jnp.array([1.0, 1.0]),
        tangential=jnp.array([1.0, 0.0]),
        asperity_normal=jnp.array([0.5, 0.25]),
        asperity_tangential=jnp.array([0.2, 0.1]),
    )
    crown = (jnp.array([0.0, 1.0]), jnp.array([0.0, 1.0]))
    loaded = SimpleNamespace(interfaces=interfaces, crown=crown)
    springs = springs_of_compliance(compliance=compliance, half_width=None, loaded=loaded)
    np.testing.assert_allclose(
        springs.normal_stiffness, [1.0 / (2.0 + 2.0), 1.0 / (4.0 + 1.0 + 4.0)], rtol=1e-15
    )
    np.testing.assert_allclose(springs.tangential_stiffness, [1.0 / (6.0 + 5.0), 0.0], rtol=1e-15)
    acts = np.array([True, True, True, False])
    np.testing.assert_allclose(springs.coupling, 0.5 * (1.0 - np.eye(4)) * np.outer(acts, acts), rtol=1e-15)
