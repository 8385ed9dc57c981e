"""The best joint within limits, and Pareto fronts."""
