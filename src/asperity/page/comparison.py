"""Two joints side by side on the page, as ``asperity compare`` shows them."""

from __future__ import annotations

from asperity.api.comparison import compare
from asperity.api.joint import DescribedJoint
from asperity.page.joint_request import JointRequest, asked_joint
from asperity.page.requests import CompareRequest, checked
from asperity.types import Document
from asperity.views.blocks import Block, BlockDocument, Paragraph, block_documents


def comparison_request(body: object) -> list[JointRequest]:
    """The two joints of a JSON body; an ``InputError`` where it is none of its model."""
    request = checked(CompareRequest, body)
    return [asked_joint(request.one), asked_joint(request.other)]


def comparison_answer(one: JointRequest, other: JointRequest) -> Document:
    """What differs: ``parts``, texts and tables with the main results, ``all_parts``, and the ``document``."""
    names = one.name, other.name if other.name != one.name else f"{other.name}, second file"
    joints = dict(zip(names, (one, other), strict=True))
    comparison = compare(*(DescribedJoint(joint.solved_case(), name) for name, joint in joints.items()))
    measured = " and ".join(name for name, joint in joints.items() if joint.surfaces)
    felt = [
        Paragraph(
            f"Measured surfaces, {measured}: what the contacts feel of them under the torque is compared."
        )
    ]

    def plain(blocks: list[Block]) -> list[BlockDocument]:
        return block_documents([*felt, *blocks] if measured else blocks)

    return {
        "parts": plain(comparison.blocks()),
        "all_parts": plain(comparison.blocks(in_full=True)),
        "document": comparison.document(),
    }
