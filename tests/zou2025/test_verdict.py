"""A claim is met only in all its statements."""

from asperity.zou2025.verdict import Claim, Statement


def test_a_claim_is_met_only_in_all_its_statements():
    met = Statement("rises", True, "from 1 to 2 N", {"start_N": 1.0})
    unmet = Statement("falls", False, "from 1 to 2 N", {"start_N": 1.0})
    assert Claim("C1", "title", ("4a",), (met, met)).met
    claim = Claim("C2", "title", ("4a", "4b"), (met, unmet))
    assert not claim.met
    document = claim.as_dict()
    assert (document["name"], document["panels"], document["met"]) == ("C2", ["4a", "4b"], False)
    assert document["statements"][1] == {
        "says": "falls",
        "met": False,
        "evidence": "from 1 to 2 N",
        "numbers": {"start_N": 1.0},
    }
