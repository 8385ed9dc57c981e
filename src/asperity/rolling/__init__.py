"""The joint that turns: creep, drift, losses, life."""
