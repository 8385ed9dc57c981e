"""``asperity serve``: which joint it opens, what it says, and how it ends."""

import pytest

pytest.importorskip("uvicorn", reason="the page needs the extra 'page'")


@pytest.fixture
def served(monkeypatch):
    """What the command asks the server for; nothing listens."""
    asked, opened = {}, []

    def listening(host, port):
        asked.update(host=host, port=port)
        return "socket"

    def serve(start, *, listening, host, ready, stopping):
        asked["start"] = start
        ready("http://127.0.0.1:8642/")
        raise KeyboardInterrupt

    monkeypatch.setattr("asperity.cli.runs.serve.listening_socket", listening)
    monkeypatch.setattr("asperity.cli.runs.serve.serve_page", serve)
    monkeypatch.setattr("webbrowser.open", opened.append)
    return asked, opened


def test_the_example_without_a_file(call, served, joint_text):
    asked, opened = served
    outcome = call("serve")
    assert (outcome.code, outcome.out) == (0, "")
    assert outcome.err.splitlines() == [
        "asperity: http://127.0.0.1:8642/ (Ctrl+C stops it)",
        "asperity: stopped",
    ]
    assert (asked["host"], asked["port"]) == ("127.0.0.1", 8642)
    assert (asked["start"].name, asked["start"].text) == ("zou2025.toml", joint_text)
    assert opened == ["http://127.0.0.1:8642/"]


def test_a_file_without_a_browser(call, served, joint_file):
    asked, opened = served
    call("serve", joint_file(('"1000 N"', '"900 N"')), "--no-browser", "--port", "0")
    assert asked["port"] == 0
    assert asked["start"].name == "joint.toml"
    assert asked["start"].case().load.preload.value == 900.0
    assert opened == []


def test_an_address_for_others_is_warned_of(call, served):
    outcome = call("serve", "--host", "0.0.0.0", "--no-browser")
    assert "every computer that reaches this address can use it" in outcome.err


def test_a_wrong_file_opens_nothing(call, served, joint_file):
    asked, opened = served
    outcome = call("serve", joint_file(('"1000 N"', '"1000 mm"')))
    assert outcome.code == 2
    assert "load.preload" in outcome.err
    assert (asked, opened) == ({}, [])


@pytest.mark.parametrize(
    ("name", "shown"), [("we\x07lle\udcfc.toml", r"we\x07lle\udcfc.toml"), ("a\n  b.toml", r"a\n  b.toml")]
)
def test_any_name_of_a_file_is_shown(call, served, joint_file, name, shown):
    asked, _ = served
    file = joint_file()
    try:
        file = file.rename(file.with_name(name))
    except OSError:
        pytest.skip("this system has no such names")
    assert call("serve", file, "--no-browser").code == 0
    assert asked["start"].name == shown
