"""Boundary elements: independent check of the closed-form laws. Imports neither contact nor drive."""

from asperity.bem.coupled_rolling import CoupledSteadyRolling, coupled_steady_rolling
from asperity.bem.elastic_pair import ElasticPair, elastic_pair
from asperity.bem.free_half_space import FreeHalfSpace
from asperity.bem.half_space import HalfSpace, PeriodicHalfSpace
from asperity.bem.normal_contact import NormalContact, normal_contact
from asperity.bem.partial_slip import PartialSlip, partial_slip
from asperity.bem.steady_rolling import SteadyRolling, steady_rolling
from asperity.bem.stick_stiffness import ContactStiffness, normal_stiffness, tangential_stiffness
from asperity.bem.transient_rolling import TransientRolling, transient_rolling

__all__ = [
    "ContactStiffness",
    "CoupledSteadyRolling",
    "ElasticPair",
    "FreeHalfSpace",
    "HalfSpace",
    "NormalContact",
    "PartialSlip",
    "PeriodicHalfSpace",
    "SteadyRolling",
    "TransientRolling",
    "coupled_steady_rolling",
    "elastic_pair",
    "normal_contact",
    "normal_stiffness",
    "partial_slip",
    "steady_rolling",
    "tangential_stiffness",
    "transient_rolling",
]
