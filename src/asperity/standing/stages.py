"""The stages of a wind-up that catalogues of gears state, K1 to K3."""

#: Torques at which K1 ends and K3 begins, as shares of the largest torque, unless stated otherwise.
STAGE_SHARES = (1.0 / 3.0, 2.0 / 3.0)
