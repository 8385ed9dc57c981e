"""Incremental stiffness of a drive and where its compliance comes from."""
