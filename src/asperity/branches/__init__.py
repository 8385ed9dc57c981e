"""Joints whose branches differ in size."""
