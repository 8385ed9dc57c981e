"""The joint that stands under a torque that changes: wind-up, hysteresis, elements for simulators."""

#: Torques at which K1 ends and K3 begins, as shares of the largest torque, unless stated otherwise.
STAGE_SHARES = (1.0 / 3.0, 2.0 / 3.0)
