from asperity.case.schema import joint_schema


def test_the_schema_tells_editors_what_a_joint_file_may_say():
    schema = joint_schema()
    assert set(schema["required"]) == {"drive", "load", "model", "materials", "bodies", "surface"}
    assert schema["additionalProperties"] is False
    drive = schema["$defs"]["Drive"]
    assert drive["properties"]["sun_radius"]["type"] == "string"  # a quantity is text with a unit
    assert drive["properties"]["planets"]["type"] == "integer"
    assert "planet_length" not in drive["required"]
    number, text = schema["$defs"]["SurfaceEntry"]["properties"]["fractal_dimension"]["anyOf"]
    assert (number["exclusiveMinimum"], number["exclusiveMaximum"]) == (1.0, 2.0)
    assert text["type"] == "string"
    assert schema["$defs"]["ModelChoice"]["properties"]["closure"]["enum"] == [
        "elastic",
        "constant_pin_force",
    ]


def test_every_key_is_described():
    for name, section in joint_schema()["$defs"].items():
        for key, entry in section.get("properties", {}).items():
            assert entry.get("description") or "$ref" in entry, f"{name}.{key}"
