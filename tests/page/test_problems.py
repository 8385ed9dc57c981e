"""Messages of the command line as answers, with the keys that they are about."""

from asperity.page.problems import errors_by_key


def test_messages_are_found_by_key():
    message = "a.toml: 2 errors\n  load.preload: bad\n  bodies.sun, bodies.ring: there is no material 'x'"
    assert errors_by_key(message, source="a.toml") == {
        "load.preload": "bad",
        "bodies.sun": "there is no material 'x'",
        "bodies.ring": "there is no material 'x'",
    }
    assert errors_by_key("the output torque is too large: lower it", source="a.toml") == {}
