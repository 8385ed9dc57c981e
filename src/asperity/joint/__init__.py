"""The whole chain: from a joint's description to forces, contacts, stiffness, wind-up and diagnostics."""
