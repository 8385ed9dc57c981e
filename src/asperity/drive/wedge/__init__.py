"""The reduction of the paper's drive to two unknowns, equations (1) to (5)."""
