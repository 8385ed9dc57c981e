"""One roller pair: from load to contact spots to stiffness, creep, strength and life."""
