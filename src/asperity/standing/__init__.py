"""The joint that stands under a torque that changes: wind-up, hysteresis, elements for simulators."""
