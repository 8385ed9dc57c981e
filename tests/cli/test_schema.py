import json


def test_the_schema_is_json(call):
    outcome = call("schema")
    assert outcome.code == 0
    assert json.loads(outcome.out)["title"] == "Joint file of asperity"
