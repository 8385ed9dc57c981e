"""The page of a joint file in a headless Chromium of the system, for the pictures of the manual."""

from __future__ import annotations

import contextlib
import re
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

from playwright.sync_api import Page, sync_playwright


@contextlib.contextmanager
def served(file: Path) -> Iterator[Callable[[int, int], Page]]:
    """Opens the page of a joint file at a width and a height of the window, once its numbers are there."""
    command = "from asperity.cli import main; main()"
    options = ["serve", str(file), "--port", "0", "--no-browser"]
    server = subprocess.Popen([sys.executable, "-c", command, *options], stderr=subprocess.PIPE, text=True)
    try:
        assert server.stderr is not None
        address = re.search(r"http://127\.0\.0\.1:\d+/", server.stderr.readline())
        assert address, "the server did not start"
        with sync_playwright() as driver:
            browser = driver.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])

            def opened(width: int, height: int) -> Page:
                page = browser.new_page(viewport={"width": width, "height": height})
                page.goto(address.group())
                page.wait_for_selector("html[data-state=ready]", timeout=300_000)
                return page

            yield opened
            browser.close()
    finally:
        server.terminate()
        server.wait()
