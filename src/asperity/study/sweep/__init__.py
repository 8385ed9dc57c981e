"""Sweeps: any numbers of a joint on a grid, in memory or streamed."""
