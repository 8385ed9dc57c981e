"""Numbers that a file keeps as they are written."""

import pytest

from asperity.joint_file.edited_text import set_texts
from asperity.joint_file.entered_values import entered_key_at, entered_values
from asperity.joint_file.reader import parse_case


def test_an_rz_and_the_shares_of_a_file(joint_text):
    rough = joint_text.replace('fractal_roughness = "', 'mean_roughness_depth = "1.6 um +- 0.2 um" # was "')
    loads = '[[duty]]\noutput_torque = "1 N*m"\nsun_speed = "1 rpm"\nshare = {}\n\n'
    text = f"{rough}\n\n" + loads.format('"40 %"') + loads.format(0.6)
    found = entered_values(parse_case(text, source="x"))
    assert {path: entry.value for path, (_, entry) in found.items()} == pytest.approx(
        {"surface.mean_roughness_depth": 1.6e-6, "duty.1.share": 0.4, "duty.2.share": 0.6}
    )
    _, depth = found["surface.mean_roughness_depth"]
    assert (depth.text, depth.tolerance) == ("1.6 um +- 0.2 um", pytest.approx(0.2e-6))


def test_paths_of_one_contact_and_of_other_keys():
    assert entered_key_at("surface.pr.mean_roughness_depth", "planetary").unit == "um"
    assert entered_key_at("duty.12.share", "zou2025").unit == "1"
    assert entered_key_at("surface.roughness_average", "planetary") is None
    assert entered_key_at("mean_roughness_depth", "planetary") is None


def test_an_rz_takes_the_place_of_g_and_of_ra_and_gives_it_back():
    tables = {"surface": {"fractal_roughness": "1 nm", "frequency_ratio": 1.5}}
    set_texts(
        tables, {"surface.mean_roughness_depth": "1.6 um", "surface.partner_mean_roughness_depth": "1 um"}
    )
    assert "fractal_roughness" not in tables["surface"]
    set_texts(tables, {"surface.partner_roughness_average": "0.1 um"})
    assert set(tables["surface"]) == {"frequency_ratio", "mean_roughness_depth", "partner_roughness_average"}
    set_texts(tables, {"surface.roughness_average": "0.2 um"})
    assert "mean_roughness_depth" not in tables["surface"]
    set_texts(tables, {"surface.sp.mean_roughness_depth": "1.6 um"})
    assert tables["surface"]["sp"]["mean_roughness_depth"] == "1.6 um"
    assert "roughness_average" in tables["surface"]["wlo"]
