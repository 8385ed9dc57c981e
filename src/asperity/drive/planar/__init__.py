"""Any planar roller drive: bodies, contacts and pins as data; kinematics, standing and rolling state from them."""
