"""A calibration as tests make it: first loading of the assembly, one start."""

from asperity.study.calibration.calibrate import calibrate
from asperity.study.calibration.unknowns import read_unknowns


def calibrated(case, measurements, texts):
    """The calibration of a joint on measurements, with the unknowns that the texts say."""
    return calibrate(
        case=case,
        measurements=measurements,
        unknowns=read_unknowns(texts, case=case, measurements=measurements),
        level="assembly",
        history="virgin",
        starts=1,
        seed=0,
    )
