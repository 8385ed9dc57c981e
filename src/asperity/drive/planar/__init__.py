"""Any planar roller drive: bodies, contacts and pins as data; kinematics, state at rest and rolling state from them."""
