"""Take ``images/page.png``: the page with the tutorial's joint, in a headless Chromium of the system."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

from playwright.sync_api import sync_playwright

HERE = Path(__file__).parent


def main() -> None:
    """Serve the joint, and take the picture once its numbers are there."""
    command = "from asperity.cli import main; main()"
    file = HERE.parent / "examples" / "tutorial_joint.toml"
    options = ["serve", str(file), "--port", "0", "--no-browser"]
    server = subprocess.Popen([sys.executable, "-c", command, *options], stderr=subprocess.PIPE, text=True)
    try:
        assert server.stderr is not None
        address = re.search(r"http://127\.0\.0\.1:\d+/", server.stderr.readline())
        assert address, "the server did not start"
        with sync_playwright() as driver:
            browser = driver.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])
            page = browser.new_page(viewport={"width": 1400, "height": 1180})
            page.goto(address.group())
            page.wait_for_selector("html[data-state=ready]", timeout=300_000)
            page.screenshot(path=HERE / "images" / "page.png")
            browser.close()
    finally:
        server.terminate()
        server.wait()


if __name__ == "__main__":
    main()
