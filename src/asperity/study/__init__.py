"""Studies on the vectorised solver: vary, compare, optimise, calibrate."""
