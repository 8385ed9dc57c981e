"""The paper's advice to designers, put to the test: does a search on the paper's own joint find it?

Advice (Zou et al. 2025, section 6): D between 1.7 and 1.85, small G, preload in proportion to the load, and a
balance of contact length against compactness. Each is asked at the level the paper computes (published) and at the
level of the assembled joint. Run it in the folder of the examples: python design_advice.py
"""

import tempfile
import tomllib
from pathlib import Path

from asperity.precision import use_compilation_cache, use_double_precision
from asperity.study.design.design import DesignResult, design
from asperity.study.design.design_file import design_from_tables

HERE = Path(__file__).parent
LEVELS = ("published", "assembly")
#: The advice knows no damage, and the paper's steel yields under its own preload: the designs may.
ALLOWED = """pressure_over_first_yield = { at_most = 100.0 }
        shakedown_ratio = { at_most = 100.0 }"""
G_RANGE = 'surface.fractal_roughness = { lower = "1e-10 mm", upper = "1e-6 mm" }'


def solve(text: str) -> DesignResult:
    return design(design_from_tables(tomllib.loads(text), folder=HERE))


def best_surface(level: str, roughness: str | None) -> DesignResult:
    """The stiffest D (and G, if it is not given) at 5 N·m."""
    free = G_RANGE if roughness is None else ""
    joint = "zou2025.toml" if roughness is None else write_joint(roughness)
    return solve(
        f"""
        joint = "{joint}"
        level = "{level}"
        [variables]
        surface.fractal_dimension = {{ lower = 1.05, upper = 1.98 }}
        {free}
        [objective]
        maximise = "stiffness"
        [constraints]
        {ALLOWED}
        [search]
        starts = 4
        """
    )


def write_joint(roughness: str) -> str:
    path = Path(tempfile.gettempdir()) / f"joint_{roughness.replace(' ', '_')}.toml"
    path.write_text((HERE / "zou2025.toml").read_text().replace("1e-8 mm", roughness))
    return str(path)


def smallest_preload(level: str, torque: float, stiffness: float | None) -> DesignResult:
    """The smallest preload that carries a torque with a slip ratio of 0.8, and a stiffness if one is asked for."""
    needed = f'stiffness = {{ at_least = "{stiffness} N*m/rad" }}' if stiffness else ""
    return solve(
        f"""
        joint = "zou2025.toml"
        level = "{level}"
        [variables]
        load.preload = {{ lower = "20 N", upper = "20000 N" }}
        [objective]
        minimise = "preload"
        [constraints]
        slip_ratio = {{ at_most = 0.8 }}
        {needed}
        {ALLOWED}
        [worst_case]
        torque = {{ lower = "0 N*m", upper = "{torque} N*m", points = 3 }}
        [search]
        starts = 3
        """
    )


def length_for_stiffness(level: str, gain: float, start: float) -> DesignResult:
    """The shortest contact lines for a stiffness that is larger by a factor."""
    return solve(
        f"""
        joint = "zou2025.toml"
        level = "{level}"
        [variables]
        drive.contact_length = {{ lower = "1 mm", upper = "100 mm" }}
        [objective]
        minimise = "envelope_volume"
        [constraints]
        stiffness = {{ at_least = "{gain * start} N*m/rad" }}
        {ALLOWED}
        [search]
        starts = 3
        """
    )


def main() -> None:
    use_double_precision()
    use_compilation_cache()
    print("1. D of the stiffest joint at 5 N·m (window 1.7 to 1.85)")
    for level in LEVELS:
        for roughness in ("1e-9 mm", "1e-8 mm", "1e-7 mm", "1e-6 mm"):
            found = best_surface(level, roughness)
            before, after = found.objective_before, found.objective_after
            print(
                f"  {level:10s} G = {roughness}: D = {found.point['surface.fractal_dimension']:.4f}, "
                f"{after:.4g} N·m/rad, {after / before:.4g} times that of D = 1.4"
            )
    print("2. G of the stiffest joint, together with D (G from 1e-10 to 1e-6 mm)")
    for level in LEVELS:
        found = best_surface(level, None)
        print(
            f"  {level:10s} G = {found.point['surface.fractal_roughness'] * 1e3:.3g} mm "
            f"({found.at_bound.get('surface.fractal_roughness', 'inside')} bound), "
            f"D = {found.point['surface.fractal_dimension']:.4f}, {found.objective_after:.4g} N·m/rad"
        )
    print(
        "3. Smallest preload for a slip ratio of 0.8, over the largest torque; and to keep the stiffness of 5 N·m"
    )
    for torque in (1.0, 2.5, 5.0, 10.0):
        found = smallest_preload("assembly", torque, None)
        preload = found.point["load.preload"]
        print(f"  {torque:4g} N·m: {preload:.5g} N, {preload / torque:.4g} N per N·m")
    for level in LEVELS:
        reference = smallest_preload(level, 5.0, None).nominal[f"{level}_stiffness_output"][0]
        found = smallest_preload(level, 10.0, float(reference))
        print(
            f"  {level:10s} the stiffness at 5 N·m and its smallest preload, kept up to 10 N·m: {found.point}"
        )
    print("4. Contact length for a larger stiffness (5 mm to begin with)")
    for level in LEVELS:
        start = float(best_surface(level, "1e-8 mm").objective_before)
        for gain in (1.02, 1.5, 2.0):
            found = length_for_stiffness(level, gain, start)
            length = found.point["drive.contact_length"] * 1e3
            state = (
                f"{length:.4g} mm"
                if found.feasible
                else f"not up to 100 mm (misses the limit by {100.0 * found.violation:.3g} %)"
            )
            print(f"  {level:10s} {gain:g} times: {state}")


if __name__ == "__main__":
    main()
