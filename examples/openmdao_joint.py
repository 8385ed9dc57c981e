"""A joint as a component of OpenMDAO: the lightest preload whose drift stays within a limit, by exact derivatives.

Run: ``pip install openmdao`` and ``python examples/openmdao_joint.py``.
"""

from pathlib import Path

import numpy as np
import openmdao.api as om

from asperity.joint.status import STATUS_MEANINGS
from asperity.joint_file.reader import read_case
from asperity.joint_file.si_tables import key_at, numeric_keys, si_values
from asperity.precision import use_compilation_cache, use_double_precision
from asperity.results import RESULTS
from asperity.study.batch import derivatives_at

FILE = Path(__file__).with_name("zou2025.toml")
ARCMINUTE = np.pi / 180.0 / 60.0


class Joint(om.ExplicitComponent):
    """Numbers of a joint file in, results out, both in SI units; ``load.preload`` is called ``load:preload``."""

    def initialize(self):
        self.options.declare("file", desc="joint file")
        self.options.declare(
            "inputs", types=dict, desc="dotted path of a number of the file -> its unit in OpenMDAO"
        )
        self.options.declare("outputs", types=dict, desc="name of a result -> its unit in OpenMDAO")

    def setup(self):
        use_double_precision()
        use_compilation_cache()
        case = read_case(self.options["file"])
        self._values, stated = si_values(case), numeric_keys(case)
        self._paths, self._results = tuple(self.options["inputs"]), tuple(self.options["outputs"])
        for path, unit in self.options["inputs"].items():
            start = stated[path].value if path in stated else 0.0
            self.add_input(path.replace(".", ":"), val=start, units=unit, desc=key_at(path).unit)
        for name, unit in self.options["outputs"].items():
            self.add_output(name, units=unit, desc=RESULTS[name].label)
        self.declare_partials("*", "*")
        self._at = None

    def _solved(self, inputs):
        """Results and derivatives at the inputs; both come from one call, which is kept for the other one."""
        at = {path: np.array([float(inputs[path.replace(".", ":")][0])]) for path in self._paths}
        if self._at != at:
            status, self._found, self._slopes = derivatives_at(self._values, at, self._results, self._paths)
            if status[0] != 0:  # an optimiser then tries a shorter step
                raise om.AnalysisError(STATUS_MEANINGS[status[0]])
            self._at = at
        return self._found, self._slopes

    def compute(self, inputs, outputs):
        found, _ = self._solved(inputs)
        for name in self._results:
            outputs[name] = found[name][0, 0]

    def compute_partials(self, inputs, partials):
        _, slopes = self._solved(inputs)
        for name in self._results:
            for place, path in enumerate(self._paths):
                partials[name, path.replace(".", ":")] = slopes[name][0, 0, place]


def problem(file: Path) -> om.Problem:
    """The lightest preload of the paper's joint that drifts no more than 40 arcmin per output turn."""
    made = om.Problem(reports=False)
    made.model.add_subsystem(
        "joint",
        Joint(
            file=file,
            inputs={"load.preload": "N", "load.output_torque": "N*m", "drive.ring_wall_thickness": "m"},
            outputs={"assembly_stiffness_output": "N*m/rad", "drift": "rad"},
        ),
        promotes=["*"],
    )
    made.model.add_design_var("load:preload", lower=500.0, upper=3000.0, ref=1000.0)
    made.model.add_constraint("drift", upper=40.0 * ARCMINUTE, ref=0.01)
    made.model.add_objective("load:preload", ref=1000.0)
    made.driver = om.ScipyOptimizeDriver(optimizer="SLSQP", tol=1e-9, disp=False)
    made.setup()
    return made


def main(file: Path) -> float:
    """Preload at which the paper's joint drifts by 40 arcmin per output turn [N]."""
    made = problem(file)
    made.run_driver()
    preload = made.get_val("load:preload", units="N")[0]
    stiffness = made.get_val("assembly_stiffness_output", units="N*m/rad")[0]
    print(
        f"40 arcmin per output turn need {preload:.4g} N of preload; the joint then has {stiffness:.4g} N·m/rad"
    )
    return float(preload)


if __name__ == "__main__":
    main(FILE)
