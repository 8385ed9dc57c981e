"""A server in a process of its own, and a headless Chromium that the system provides."""

import re
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PROGRAM = "from asperity.cli import main; main()"


class Served:
    """``asperity serve`` on a free port."""

    def __init__(self, file):
        self.process = subprocess.Popen(
            [
                sys.executable,
                "-c",
                PROGRAM,
                "serve",
                str(file),
                "--port",
                "0",
                "--no-browser",
            ],
            stderr=subprocess.PIPE,
            text=True,
        )
        assert self.process.stderr is not None
        line = self.process.stderr.readline()
        found = re.search(r"http://127\.0\.0\.1:\d+/", line)
        assert found, line + self.process.stderr.read()
        self.address = found.group()

    def stop(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
            self.process.wait(timeout=60)
        self.process.stderr.close()
        return self.process.returncode


@pytest.fixture(scope="session")
def serve():
    """Starter of servers, which are stopped at the end."""
    pytest.importorskip("uvicorn", reason="the page needs the extra 'page'")
    started = []

    def start(file):
        started.append(Served(file))
        return started[-1]

    yield start
    for each in started:
        each.stop()


@pytest.fixture(scope="session")
def served(serve):
    return serve(ROOT / "examples" / "tutorial_joint.toml")


@pytest.fixture(scope="session")
def served_text(serve, tmp_path_factory):
    """Starter of a server of a joint file of this text."""

    def start(text):
        file = tmp_path_factory.mktemp("joint") / "planetary.toml"
        file.write_text(text, encoding="utf-8")
        return serve(file)

    return start


@pytest.fixture(scope="session")
def chromium():
    api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    found = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if found is None:
        pytest.skip("no Chromium here: install the system's package 'chromium'")
    with api.sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=found, args=["--no-sandbox"])
        yield browser
        browser.close()


@pytest.fixture
def page(chromium, served):
    """The page, opened and computed; the test fails if the browser reports an error."""
    context = chromium.new_context(accept_downloads=True, viewport={"width": 1400, "height": 1000})
    found = context.new_page()
    errors = []
    found.on("pageerror", lambda error: errors.append(str(error)))
    # refused values answer with 422, which Chromium also reports as an error
    found.on(
        "console",
        lambda message: (
            errors.append(message.text)
            if message.type == "error" and "status of 422" not in message.text
            else None
        ),
    )
    found.goto(served.address)
    found.wait_for_selector("html[data-state=ready]", timeout=300_000)
    yield found
    context.close()
    assert errors == []


@pytest.fixture(scope="session")
def described_as():
    """Entries by which an answer and what the interface says of it by a name differ; their kinds are checked."""
    import jsonschema

    from asperity.page.openapi import openapi

    components = openapi()["components"]

    def check(name: str, answer: dict) -> set[str]:
        jsonschema.validate(answer, {"$ref": f"#/components/schemas/{name}", "components": components})
        schema = components["schemas"][name]
        return (set(answer) ^ set(schema["properties"])) | (set(answer) ^ set(schema["required"]))

    return check
