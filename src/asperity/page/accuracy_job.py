"""The accuracy of a joint over a turn as a job of the page: its document, one turn of the output, and a view."""

from __future__ import annotations

import numpy as np

from asperity.joint_file.accuracy import joint_accuracy
from asperity.joint_file.reader import read_case
from asperity.page.job_process import Report
from asperity.results.accuracy_document import accuracy_document
from asperity.types import Document
from asperity.views.accuracy import accuracy as accuracy_shown
from asperity.views.blocks import block_documents


def accuracy(file: str, options: Document, report: Report) -> Document:
    """What form errors do over a turn, with ``reverse`` in both directions, and the turn that the page draws.

    The turn has the force of the contact that swings most.
    """
    found = joint_accuracy(read_case(file), reverse=options["reverse"])
    document, turn = accuracy_document(found), found.over_turn
    most = int(np.argmax(np.ptp(turn.normal, axis=0)))
    return document | {
        "over_turn": {
            "output": found.output,
            "angle_rad": turn.angle.tolist(),
            "transmission_error_rad": turn.transmission_error.tolist(),
            "input_torque_Nm": turn.input_torque.tolist(),
            "contact": found.forward.contact_names[most],
            "normal_N": turn.normal[:, most].tolist(),
        },
        "views": block_documents(list(accuracy_shown(document))),
    }
