"""Joints with any planar roller drive: the same chain and the same results as for the drive of Zou et al. 2025."""
