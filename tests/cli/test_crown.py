"""``asperity crown``: tables, JSON and refusals; the numbers are tested in tests/results and tests/contact."""

import json

import pytest


def test_every_contact_has_a_table_and_the_same_numbers_in_json(call, zou_file):
    shown = call("crown", zou_file, "--tilt", "0.2 mrad")
    assert shown.code == 0
    document = json.loads(call("crown", zou_file, "--tilt", "0.2 mrad", "--json").out)
    assert document["tilt_rad"] == pytest.approx(0.2e-3)
    assert list(document["contacts"]) == ["sp", "pwr", "pwl", "wro", "wlo"]
    said = " ".join(shown.out.split())
    for name, contact in document["contacts"].items():
        assert f"{name}: {contact['normal_force_N']:.4g} N on 5 mm, tilt 0.2 mrad" in said
        recommended = contact["profiles"][2]
        assert (
            f"circular, recommended {1e6 * recommended['end_drop_m']:.4g} {1e3 * recommended['crown_radius_m']:.4g} –"
        ) in said
    assert "loads no end" in said


def test_what_is_no_angle_or_too_large_is_refused(call, zou_file):
    refused = call("crown", zou_file, "--tilt", "0.2 mm")
    assert (refused.code, "--tilt: expected an angle" in refused.err) == (2, True)
    refused = call("crown", zou_file, "--tilt", "200 mrad")
    assert (refused.code, "sp: no crown takes up a tilt of 200 mrad" in refused.err) == (3, True)
