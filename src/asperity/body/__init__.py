"""Discs and annuli as exact plane elasticity: compliance between contacts, stresses at the rims."""
