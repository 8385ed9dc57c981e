import pytest


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_a_script_for_every_shell(call, shell):
    outcome = call("completion", shell)
    assert outcome.code == 0
    assert "_ASPERITY_COMPLETE" in outcome.out


def test_an_unknown_shell(call):
    outcome = call("completion", "cmd")
    assert outcome.code == 2
    assert "bash" in outcome.err


def test_commands_are_completed(call, monkeypatch):
    monkeypatch.setenv("_ASPERITY_COMPLETE", "bash_complete")
    monkeypatch.setenv("COMP_WORDS", "asperity jo")
    monkeypatch.setenv("COMP_CWORD", "1")
    assert call().out == "plain,joint\n"
