"""Boundary elements: the independent check of every closed-form contact law. Imports neither contact nor drive."""

from asperity.bem.elastic_pair import ElasticPair, elastic_pair
from asperity.bem.free_half_space import FreeHalfSpace
from asperity.bem.half_space import HalfSpace, PeriodicHalfSpace
from asperity.bem.normal_contact import NormalContact, normal_contact

__all__ = [
    "ElasticPair",
    "FreeHalfSpace",
    "HalfSpace",
    "NormalContact",
    "PeriodicHalfSpace",
    "elastic_pair",
    "normal_contact",
]
