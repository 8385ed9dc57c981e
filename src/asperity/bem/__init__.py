"""Boundary elements: the independent check of the closed-form laws. Imports neither contact nor drive."""

from asperity.bem.elastic_pair import ElasticPair, elastic_pair
from asperity.bem.free_half_space import FreeHalfSpace
from asperity.bem.half_space import HalfSpace, PeriodicHalfSpace
from asperity.bem.normal_contact import NormalContact, normal_contact
from asperity.bem.partial_slip import PartialSlip, partial_slip
from asperity.bem.stick_stiffness import ContactStiffness, normal_stiffness, tangential_stiffness

__all__ = [
    "ContactStiffness",
    "ElasticPair",
    "FreeHalfSpace",
    "HalfSpace",
    "NormalContact",
    "PartialSlip",
    "PeriodicHalfSpace",
    "elastic_pair",
    "normal_contact",
    "normal_stiffness",
    "partial_slip",
    "tangential_stiffness",
]
