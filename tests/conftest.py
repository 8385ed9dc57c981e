"""Shared set-up: double precision, strict promotion, and where the optional shared measurement files live."""

import atexit
import dataclasses
import functools
import gc
import os
import shutil
import signal
import tempfile
from importlib.metadata import version
from pathlib import Path
from types import SimpleNamespace
from typing import NamedTuple

# most of the suite's time is compilation: without fused kernels, and each program in one part, it takes two thirds, and
# the numbers are the same; XLA ends a process that gives it a flag which it does not know (any more)
if [int(part) for part in version("jaxlib").split(".")[:2]] <= [0, 10]:
    faster = "--xla_cpu_use_fusion_emitters=false --xla_cpu_parallel_codegen_split_count=1"
    os.environ["XLA_FLAGS"] = f"{os.environ.get('XLA_FLAGS', '')} {faster}"

import jax
import numpy as np
import pytest
from hypothesis import settings

from asperity.precision import use_compilation_cache

if "ASPERITY_CACHE_DIR" not in os.environ:
    # compiled once for all workers and subprocesses of this run, and thrown away with it
    folder = tempfile.mkdtemp(prefix="asperity-tests-")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    os.environ["ASPERITY_CACHE_DIR"] = folder

jax.config.update("jax_enable_x64", True)
jax.config.update("jax_numpy_dtype_promotion", "strict")
# most of the suite's time is compilation; the unoptimised programs compute the same numbers in a third of it
jax.config.update("jax_disable_most_optimizations", True)
use_compilation_cache()
# formulas choose between regimes by where, as under JAX; the door to them (asperity.engine.control.at_once) is silent
np.seterr(all="ignore")
# tracing makes many objects and hardly any garbage
gc.set_threshold(100_000)
# neither a slow machine nor a seed decides a test
settings.register_profile("asperity", deadline=None, derandomize=True, database=None)
settings.load_profile("asperity")

# of one worker [bytes]: two of them leave a third of the machine to others
_LARGEST_MEMORY = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 3


@pytest.fixture(scope="module", autouse=True)
def bounded_memory():
    """Forget compiled programs where they fill the memory; the cache on disk still has them."""
    yield
    pages = Path("/proc/self/statm")
    if pages.exists() and int(pages.read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") > _LARGEST_MEMORY:
        jax.clear_caches()
        gc.collect()


#: Programs of JAX that a test may make: its own, not those of fixtures for many tests. An operation on arrays of JAX
#: outside a program is a program, unless an earlier test of this process has made it; a test that makes so many waits
#: for a compiler. Write it in NumPy, or put the whole into one jax.jit. Most make none; ASPERITY_COUNT_PROGRAMS names a
#: file in which the counts of all tests are written.
MOST_PROGRAMS = 100
_made = [0]


def _count(event: str, duration: float, **_: str) -> None:
    _made[0] += event == "/jax/core/compile/jaxpr_to_mlir_module_duration"


jax.monitoring.register_event_duration_secs_listener(_count)


@pytest.fixture(autouse=True)
def few_programs(request):
    """A test that makes many programs of JAX waits for a compiler; those that must say why (`programs(reason)`)."""
    before = _made[0]
    yield
    made = _made[0] - before
    if os.environ.get("ASPERITY_COUNT_PROGRAMS"):
        with open(os.environ["ASPERITY_COUNT_PROGRAMS"], "a") as log:
            log.write(f"{made} {request.node.nodeid}\n")
    marks = ("programs", "slow", "long")
    if made > MOST_PROGRAMS and not any(map(request.node.get_closest_marker, marks)):
        pytest.fail(
            f"{made} programs of JAX were made, more than {MOST_PROGRAMS}: see few_programs in conftest.py"
        )


FILE = Path(__file__).parents[1] / "examples" / "zou2025.toml"
SHARED = Path(os.environ.get("ASPERITY_SHARED_DATA", Path(__file__).parents[2] / "shared"))


@pytest.fixture(scope="session")
def shared_data() -> Path:
    """Folder of measured instrument files; tests on them skip where it is absent."""
    folder = SHARED / "data"
    if not folder.is_dir():
        pytest.skip(f"measured files are not here: {folder} does not exist (set ASPERITY_SHARED_DATA)")
    return folder


@pytest.fixture(scope="session")
def reproducers(shared_data) -> Path:
    """Folder of files made after public reports; tests on them skip where it is absent."""
    folder = shared_data.parent / "reproducers" / "turn4"
    if not folder.is_dir():
        pytest.skip(f"the files are not here: {folder} does not exist (set ASPERITY_SHARED_DATA)")
    return folder


#: Names of numbers of the formulas → their places in a joint file.
PLACES = {
    **{
        name: f"drive.{name}"
        for name in (
            *(f"{body}_radius" for body in ("sun", "planet", "loading_roller", "ring")),
            "left_push_angle",
            "right_push_angle",
            "ring_wall_thickness",
            "contact_length",
            "planet_length",
            "loading_roller_length",
        )
    },
    "planet_count": "drive.planets",
    **{
        name: f"materials.steel.{name}"
        for name in ("youngs_modulus", "poisson_ratio", "density", "yield_strength", "hardness")
    },
    **{name: f"surface.{name}" for name in ("fractal_dimension", "fractal_roughness", "frequency_ratio")},
    **{
        name: f"load.{name}"
        for name in ("preload", "interference", "output_torque", "sun_speed", "friction_coefficient")
    },
    **{
        name: f"bearings.{name}"
        for name in (
            "sun_torque",
            "loading_roller_torque",
            "carrier_torque",
            "pin_friction_coefficient",
            "pin_diameter",
        )
    },
}
CHOICES = {
    "closure": "closure",
    "closure_springs": "closure_springs",
    "traction_split": "traction_split",
    "contact_factor_model": "contact_factor",
    "asperity_base": "asperity_base",
    "body_model": "bodies",
    "plane_state": "plane_state",
}


@pytest.fixture(scope="session")
def paper_values(case):
    """Maker of the SI tables of the paper's joint with a ring of 10 mm and changes, which may be arrays.

    Changes are named as the numbers of the formulas are, or by their path in a joint file with ``__`` for the dots.
    """
    from asperity.joint_file.si_tables import replace_values, si_values

    standard = replace_values(si_values(case), {"drive.ring_wall_thickness": 10e-3})

    def make(**changes):
        choices = {CHOICES[name]: changes.pop(name) for name in CHOICES.keys() & changes.keys()}
        support = {"ring_support": changes.pop("ring_support")} if "ring_support" in changes else {}
        paths = {PLACES.get(name, name.replace("__", ".")): value for name, value in changes.items()}
        values = replace_values(standard, paths)
        return values | {"model": values["model"] | choices, "drive": values["drive"] | support}

    return make


@pytest.fixture(scope="session")
def paper_joint(paper_values):
    """Maker of the paper's joint (assumptions: steel, N_0 = 1000 N, 5 N·m, no bearing friction) with changes.

    Arrays of one shape (n,) make a batch: every number of the joint then has this axis first.
    """
    from asperity.joint_file.build import joint_from_values

    def make(*, play=None, **changes):
        def one(**numbers):
            joint = joint_from_values(paper_values(**numbers))
            return joint if play is None else dataclasses.replace(joint, play=play)

        arrays = {name: value for name, value in changes.items() if np.ndim(value)}
        if not arrays:
            return one(**changes)
        (count,) = np.broadcast_shapes(*(value.shape for value in arrays.values()))
        joints = [
            one(**changes | {name: float(value[i]) for name, value in arrays.items()}) for i in range(count)
        ]
        return jax.tree.map(lambda *leaves: np.stack([np.asarray(leaf, float) for leaf in leaves]), *joints)

    return make


@pytest.fixture(scope="session")
def evaluated_together():
    """What the chain says of up to 64 joints, always by the program for 64: one compilation for each variant.

    The axis of the joints, first in ``paper_joint``, is last in the results.
    """
    from asperity.joint.evaluation import evaluate

    most = 64
    program = jax.jit(jax.vmap(evaluate, out_axes=-1))

    def evaluated(joint):
        shape = np.shape(joint.output_torque)
        count = int(np.prod(shape))
        assert count <= most

        def padded(leaf):
            values = np.asarray(leaf, dtype=float).reshape(count, *np.shape(leaf)[len(shape) :])
            return np.concatenate([values, np.repeat(values[-1:], most - count, axis=0)])

        found = program(jax.tree.map(padded, joint))
        return jax.tree.map(
            lambda leaf: np.asarray(leaf)[..., :count].reshape((*np.shape(leaf)[:-1], *shape)), found
        )

    return evaluated


@pytest.fixture(scope="session")
def load_example():
    """Loader of a script of examples/ by its name, as a module."""
    import importlib.util

    def load(name: str):
        path = Path(__file__).parents[1] / "examples" / f"{name}.py"
        spec = importlib.util.spec_from_file_location(name, path)
        assert spec is not None
        assert spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        return module

    return load


class Outcome(NamedTuple):
    code: int
    out: str
    err: str


@pytest.fixture
def call(monkeypatch, capsys):
    """Call the command as a shell would: exit code, standard output, standard error."""
    from asperity.cli import main

    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")

    def run(*arguments) -> Outcome:
        monkeypatch.setattr("sys.argv", ["asperity", *map(str, arguments)])
        capsys.readouterr()
        before = signal.getsignal(signal.SIGINT)
        with pytest.raises(SystemExit) as ended:
            main()
        signal.signal(signal.SIGINT, before)
        told = capsys.readouterr()
        return Outcome(ended.value.code, told.out, told.err)

    return run


@pytest.fixture
def joint_file(tmp_path):
    """Maker of a joint file: the example with some of its text replaced."""

    def write(*replacements: tuple[str, str]) -> Path:
        text = FILE.read_text(encoding="utf-8")
        for old, new in replacements:
            assert old in text
            text = text.replace(old, new)
        (tmp_path / "joint.toml").write_text(text, encoding="utf-8")
        return tmp_path / "joint.toml"

    return write


@pytest.fixture(scope="session")
def zou_file() -> Path:
    return FILE


@pytest.fixture(scope="session")
def joint_text():
    return FILE.read_text()


@pytest.fixture(scope="session")
def case(joint_text):
    from asperity.joint_file.reader import parse_case

    return parse_case(joint_text, source="zou2025.toml")


@pytest.fixture(scope="session")
def planar_case():
    """Case of an example with another drive, with replaced pieces of its text."""
    from asperity.joint_file.reader import parse_case

    def case(name, **changes):
        text = (FILE.parent / f"{name}.toml").read_text(encoding="utf-8")
        for old, new in changes.get("replaced", {}).items():
            assert old in text, old
            text = text.replace(old, new)
        return parse_case(text, source=f"{name}.toml")

    return case


@pytest.fixture(scope="session")
def evaluated_directly(case):
    """What the chain says on a grid of axes, in one call without the machinery of studies."""

    def evaluated(axes):
        from asperity.joint.evaluation import evaluate
        from asperity.joint_file.build import joint_from_values
        from asperity.joint_file.si_tables import replace_values, si_values

        def at(*numbers):
            changes = {axis.path: number for axis, number in zip(axes, numbers, strict=True)}
            return evaluate(joint_from_values(replace_values(si_values(case), changes)))

        grid = np.meshgrid(*(axis.values for axis in axes), indexing="ij")
        return jax.jit(jax.vmap(at, out_axes=-1))(*(np.ravel(each) for each in grid))

    return evaluated


@pytest.fixture
def document_of_branches(monkeypatch):
    """Three branches by hand under 5 N·m: the third loose, the first pressed 1.1 times as hard as equal ones."""
    from asperity.branches.branches import SectorDeviations
    from asperity.branches.results import BranchState, UnequalBranches
    from asperity.joint.torque_limits import LIMIT_KINDS, TorqueCapacity
    from asperity.results import branch_document as module

    planets, per_size = np.array([1e-6, 0.0, -7e-6]), np.array([0.0, 2.0])
    torque = {"sun": 1.5}
    rest = BranchState(
        np.zeros(3), "sun", np.array([-3e-6, 4e-6]), np.array([-150.0, 200.0]), {}, torque, 0.0
    )
    standing = dataclasses.replace(rest, torque=np.array([3.0, 2.0, 0.0]), input_torque=1.5)

    def limit(value, kind, contact):
        return TorqueCapacity(value, LIMIT_KINDS.index(kind), contact)

    def of(support=5e7, **changes):
        known = {
            "sizes": SectorDeviations({"planet": planets}, np.outer(planets, per_size), per_size, support),
            "noun": "planet",
            "equal_preload": 1000.0,
            "interference": np.array([14e-6, 12e-6, -1e-6]),
            "preload": np.array([1100.0, 900.0, 0.0]),
            "rest": rest,
            "standing": standing,
            "rolling": None,
        }
        monkeypatch.setattr(module, "unequal_branches", lambda *_: UnequalBranches(**known | changes))
        names = tuple(f"{contact}_{sector}" for sector in (1, 2, 3) for contact in ("sp", "pr"))
        branches = SimpleNamespace(
            joint=SimpleNamespace(output_torque=5.0, contact_names=names),
            equal=SimpleNamespace(contact_names=("sp", "pr")),
        )
        solution = SimpleNamespace(
            states=None,
            result=SimpleNamespace(
                diagnostics=SimpleNamespace(slip_ratio=np.array([0.4, 0.3, 0.5, 0.2, np.nan, np.nan])),
                rolling=SimpleNamespace(slip_ratio=np.full(6, np.nan)),
            ),
            first_slip=limit(8.0, "gross_slip", 2),
            standing_capacity=limit(12.5, "gross_slip", 0),
            rolling_capacity=limit(8.0, "no_solution", 6),
        )
        return module.branch_document(branches, solution)

    return of


@pytest.fixture(scope="session")
def solved_example(case):
    """The joint of the paper's example file, solved."""
    from asperity.joint_file.solved_document import solved_case

    return solved_case(case)


@pytest.fixture(scope="session")
def solved_paper(paper_joint):
    """The paper's joint and its solution."""
    from asperity.joint.solve import solve_joint

    joint = paper_joint()
    return joint, solve_joint(joint)


@pytest.fixture(scope="session")
def wedged(planar_case):
    """A joint whose left ring contact unloads with the torque, its loading rollers as in the paper's closure."""
    from asperity.joint_file.build import joint_from_case

    split = {"[model]\n": '[model]\ntraction_split = "equal_coefficients"\n'}
    return joint_from_case(planar_case("tutorial_joint", replaced=split))


@pytest.fixture(scope="session")
def planar_joint(planar_case):
    """Joint of an example, with replaced pieces of its text."""
    from asperity.joint_file.build import joint_from_case

    return lambda name, replaced=None: joint_from_case(planar_case(name, replaced=replaced or {}))


@pytest.fixture(scope="session")
def planetary(planar_case):
    """The planetary example: joint, solution and document."""
    from asperity.joint_file.solved_document import solve_case

    solved, document = solve_case(planar_case("planetary"))
    return solved.joint, solved.solution, document


@pytest.fixture(scope="session")
def skewed_planetary(planar_case):
    """The planetary example with springs as bodies and skewed axes: joint, solution and document."""
    from asperity.joint_file.solved_document import solve_case

    replaced = {
        'bodies = "exact"': 'bodies = "springs"',
        'ring_support = "free"': 'ring_support = "rigid_housing"',
        "[lubrication]": '[rolling]\nskew = { sp = "0.5 mrad", pr = "-0.8 mrad" }\n\n[lubrication]',
    }
    solved, document = solve_case(planar_case("planetary", replaced=replaced))
    return solved.joint, solved.solution, document


@pytest.fixture(scope="session")
def view_of():
    """Maker of what all views read of an example, by pairs of replaced pieces of its text and lines at its end.

    Each is solved once.
    """
    from asperity.joint_file.reader import parse_case
    from asperity.joint_file.solved_document import solve_with_surface
    from asperity.joint_file.stated_parts import made_interference
    from asperity.views.solved_view import SolvedView

    @functools.cache
    def view(name, *replaced, more=""):
        text = (FILE.parent / f"{name}.toml").read_text(encoding="utf-8")
        for old, new in replaced:
            assert old in text, old
            text = text.replace(old, new)
        case = parse_case(text + more, source=f"{name}.toml")
        solved, document = solve_with_surface(case)
        return SolvedView(solved, document, made_interference(case, solved.result).size)

    return view


@pytest.fixture(scope="session")
def paper_view(view_of):
    """What all views read of the paper's example."""
    return view_of("zou2025")


@pytest.fixture(scope="session")
def planetary_view(view_of):
    """What all views read of the planetary example."""
    return view_of("planetary")


@pytest.fixture
def saved_figures(monkeypatch):
    """The figures that are saved during a test, in their order, so that the test can look at what is drawn."""
    from matplotlib.figure import Figure

    figures, savefig = [], Figure.savefig

    def save(figure, *arguments, **options):
        figures.append(figure)
        return savefig(figure, *arguments, **options)

    monkeypatch.setattr(Figure, "savefig", save)
    return figures
