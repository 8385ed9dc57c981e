"""Unknowns of a joint from a measured torque-angle curve."""
