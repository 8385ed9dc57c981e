"""The command prints what differs, and one document of it."""

import json


def test_the_command_prints_both_tables(call, zou_file, tmp_path):
    file = tmp_path / "more.toml"
    file.write_text(zou_file.read_text().replace('preload = "1000 N"', 'preload = "1100 N"'))
    seen = call("compare", zou_file, file)
    assert seen.code == 0
    assert "What differs in the files" in seen.out
    assert "more.toml" in seen.out
    assert "torque capacity" in seen.out
    assert json.loads(call("compare", zou_file, file, "--json").out)["inputs"][0]["name"] == "load.preload"
