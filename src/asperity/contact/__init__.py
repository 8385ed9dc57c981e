"""One roller pair: load to spots to stiffness."""
