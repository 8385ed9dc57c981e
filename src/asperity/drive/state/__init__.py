"""Forces, displacements and speeds of a drive: assembled, standing, rolling."""
