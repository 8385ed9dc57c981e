"""Evidence on the user's machine: published and independent results, recomputed by the installed version."""
