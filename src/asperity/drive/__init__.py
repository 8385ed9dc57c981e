"""The mechanism: geometry, force balance, torsional stiffness."""
