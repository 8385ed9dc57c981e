"""The JSON schema of joint files."""

from __future__ import annotations

from typing import Any

from asperity.case.model import Case


def joint_schema() -> dict[str, Any]:
    """Schema of a joint file after TOML is read, for editors such as those with Taplo.

    Returns
    -------
    dict
        JSON Schema, draft 2020-12. Bounds of quantities with units cannot be said in it; the reader checks them.
    """
    schema = Case.model_json_schema(mode="validation")
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        **schema,
        "title": "Joint file of asperity",
    }
