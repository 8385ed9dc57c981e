"""A joint as a machine without torque, and its states under its torque."""

from asperity.joint.assembled import assembled
from asperity.joint.evaluation import states_under_torque
from asperity.joint.machine import joint_machine


def assembled_laws(joint):
    """Laws of the contacts of a joint."""
    return assembled(joint_machine(joint)).laws


def laws_and_states(joint):
    """Laws of the contacts of a joint, and its drive assembled, standing and rolling."""
    machine = joint_machine(joint)
    without_torque = assembled(machine)
    return without_torque.laws, states_under_torque(machine, without_torque)
