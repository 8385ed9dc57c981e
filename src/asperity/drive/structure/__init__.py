"""What the structure around the rollers carries: bearings, pins, inertias."""
