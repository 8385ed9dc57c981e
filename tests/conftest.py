"""Shared set-up: double precision, strict promotion, and where the optional shared measurement files live."""

import atexit
import gc
import os
import shutil
import tempfile
from importlib.metadata import version
from pathlib import Path

# most of the suite's time is compilation: without fused kernels it takes two thirds, and the numbers are the same;
# XLA ends a process that gives it a flag which it does not know (any more)
if [int(part) for part in version("jaxlib").split(".")[:2]] <= [0, 10]:
    os.environ["XLA_FLAGS"] = f"{os.environ.get('XLA_FLAGS', '')} --xla_cpu_use_fusion_emitters=false"

import jax
import numpy as np
import pytest

from asperity import compilation
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
# tracing makes many objects and hardly any garbage
gc.set_threshold(100_000)

# of one worker [bytes]: two of them leave a third of the machine to others
_LARGEST_MEMORY = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 3


@pytest.fixture(scope="module", autouse=True)
def bounded_memory():
    """Forget compiled programs where they fill the memory; the cache on disk still has them."""
    yield
    pages = Path("/proc/self/statm")
    if pages.exists() and int(pages.read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") > _LARGEST_MEMORY:
        compilation._compiled.cache_clear()
        jax.clear_caches()
        gc.collect()


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
def paper_joint():
    """Maker of the paper's joint (assumptions: steel, N_0 = 1000 N, 5 N·m, no bearing friction) with changes.

    Names of changes are those of the formulas' arguments; numbers may be arrays of one shape.
    """
    from asperity.contact.fractal import Surface
    from asperity.drive.assembly import IDEAL_STRUCTURE
    from asperity.drive.geometry import DriveGeometry
    from asperity.drive.mechanism import Bearings
    from asperity.joint.evaluation import Bodies, Joint
    from asperity.joint.play import NO_PLAY
    from asperity.materials import Material

    standard = {
        "sun_radius": 4e-3,
        "planet_radius": 13.5e-3,
        "loading_roller_radius": 5e-3,
        "ring_radius": 40e-3,
        "planet_count": 3.0,
        "left_push_angle": 0.0,
        "right_push_angle": 0.0,
        "youngs_modulus": 206e9,
        "poisson_ratio": 0.3,
        "density": 7850.0,
        "yield_strength": 450e6,
        "hardness": 1260e6,
        "fractal_dimension": 1.4,
        "fractal_roughness": 1e-11,
        "contact_length": 5e-3,
        "friction_coefficient": 0.12,
        "ring_wall_thickness": 10e-3,
        "sun_torque": 0.0,
        "loading_roller_torque": 0.0,
        "carrier_torque": 0.0,
        "pin_friction_coefficient": 0.0,
        "pin_diameter": 0.0,
        "preload": 1000.0,
        "output_torque": 5.0,
        "sun_speed": 6000 * np.pi / 30,
        "structure": IDEAL_STRUCTURE,
        "play": NO_PLAY,
        "closure": "elastic",
        "closure_springs": "bulk",
        "contact_factor_model": "printed",
        "asperity_base": "majumdar_bhushan_1991",
    }

    def make(**changes):
        unknown = changes.keys() - standard.keys()
        assert not unknown, unknown
        x = standard | changes
        numbers = {
            key: np.asarray(value, float)
            for key, value in x.items()
            if isinstance(value, int | float | np.ndarray)
        }
        shape = np.broadcast_shapes(*(value.shape for value in numbers.values()))
        x |= {key: np.broadcast_to(value, shape).copy() for key, value in numbers.items()}

        def pick(module, *names):
            return module(*(x[name] for name in names))

        body = pick(Material, "youngs_modulus", "poisson_ratio", "density", "yield_strength", "hardness")
        surface = Surface(
            x["fractal_dimension"], x["fractal_roughness"], np.full(shape, 1.5), x["asperity_base"]
        )
        return Joint(
            geometry=pick(DriveGeometry, *list(standard)[:7]),
            bodies=Bodies(body, body, body, body),
            surfaces=(surface,),
            contact_lengths=(x["contact_length"],),
            friction_coefficients=(x["friction_coefficient"],),
            planet_length=x["contact_length"],
            loading_roller_length=x["contact_length"],
            ring_wall_thickness=x["ring_wall_thickness"],
            bearings=pick(
                Bearings,
                "sun_torque",
                "loading_roller_torque",
                "carrier_torque",
                "pin_friction_coefficient",
                "pin_diameter",
            ),
            preload=x["preload"],
            output_torque=x["output_torque"],
            sun_speed=x["sun_speed"],
            structure=x["structure"],
            play=x["play"],
            closure=x["closure"],
            closure_springs=x["closure_springs"],
            contact_factor_model=x["contact_factor_model"],
        )

    return make


@pytest.fixture(scope="session")
def evaluated_together():
    """What the chain says of up to 64 joints, always by the program for 64: one compilation for each variant."""
    from asperity.compilation import compile_fast
    from asperity.joint.evaluation import evaluate

    most = 64

    def evaluated(joint):
        shape = np.broadcast_shapes(*(np.shape(leaf) for leaf in jax.tree.leaves(joint)))
        count = int(np.prod(shape))
        assert count <= most

        def padded(leaf):
            values = np.broadcast_to(np.asarray(leaf, dtype=float), shape).ravel()
            return np.concatenate([values, np.full(most - count, values[-1])])

        numbers = jax.tree.map(padded, joint)

        def asked(leaf):
            values = np.asarray(leaf)  # without an axis where it is the same for all
            return values[..., :count].reshape((*values.shape[:-1], *shape)) if values.ndim else values

        return jax.tree.map(asked, compile_fast(evaluate, numbers)(numbers))

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
        from asperity.compilation import compile_fast
        from asperity.joint.evaluation import evaluate
        from asperity.joint_file.build import with_values

        grid = np.meshgrid(*(axis.values for axis in axes), indexing="ij")
        joint = with_values(case, {axis.path: v.ravel() for axis, v in zip(axes, grid, strict=True)})
        numbers = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), joint)
        result = compile_fast(evaluate, numbers)(numbers)
        assert np.all(result.solved)
        return result

    return evaluated


@pytest.fixture(scope="session")
def unequal_branches():
    """Three branches by hand under 5 N·m: the third loose, the first pressed 1.1 times as hard as equal ones."""
    from asperity.joint.branch_results import BranchCapacity, BranchState, UnequalBranches
    from asperity.joint.branch_sizes import BranchSizes

    def of(support=5e7, **changes):
        state = {
            "preload": np.array([1100.0, 900.0, 0.0]),
            "torque": np.array([3.0, 2.0, 0.0]),
            "slip_ratio": np.array([0.4, 0.5, np.nan]),
            "sun_displacement": np.array([-3e-6, 4e-6]),
            "sun_force": np.array([-150.0, 200.0]),
        }
        falling = np.outer(np.linspace(1.0, 0.6, 5), [1.2, 1.1, np.nan])
        capacity = BranchCapacity(first_slip=8.0, branch=1, contact=0, all_slip=12.5, equal=13.0)
        known = {
            "sizes": BranchSizes(np.array([1e-6, 0.0, -7e-6]), np.zeros(3), np.zeros(3), support),
            "torque": 5.0,
            "own_preload": 1000.0,
            "interference": np.array([14e-6, 12e-6, -1e-6]),
            "preload": np.array([1100.0, 900.0, 0.0]),
            "rest": BranchState(**state | {"torque": np.zeros(3)}),
            "standing": BranchState(**state, limits={"pressure_over_first_yield": falling}),
            "rolling": None,
            "capacity": capacity,
            "rolling_capacity": capacity,
        }
        return UnequalBranches(**known | changes)

    return of


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
