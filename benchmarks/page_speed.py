"""Time from a key press on a slider of the page to the new key figures, and to all plots redrawn, in headless Chromium.

    python benchmarks/page_speed.py [FILE] [--presses 50]

Needs the extras 'page' and 'test' and an installed Chromium. Prints median and worst time of the key presses, how many
empty round trips to the server that is, the time of the first load, and the bytes transferred.
"""

from __future__ import annotations

import argparse
import re
import shutil
import statistics
import subprocess
import sys
from pathlib import Path

from playwright.sync_api import sync_playwright

FILE = Path(__file__).parents[1] / "examples" / "tutorial_joint.toml"

# From the key press until the browser has painted what is new: the second frame after it is drawn.
PRESS = """
async () => {
  const slider = document.querySelector('[aria-label="preload, slider"], [aria-label="interference, slider"]');
  const page = document.documentElement.dataset;
  slider.focus(); // otherwise the page sets it to the rounded value that it shows, and it stays there
  if (Number(slider.value) >= Number(slider.max)) throw new Error("the slider is at its end: ask for fewer presses");
  const start = performance.now();
  const painted = (name) => new Promise((done) => {
    const before = page[name];
    const seen = new MutationObserver(() => {
      if (page[name] === before) return;
      seen.disconnect();
      requestAnimationFrame(() => requestAnimationFrame(() => done(performance.now() - start)));
    });
    seen.observe(document.documentElement, { attributes: true });
  });
  const both = Promise.all([painted("figures"), painted("revision")]);
  slider.stepUp(1); // a new value each time: the server keeps the latest answers
  slider.dispatchEvent(new Event("input", { bubbles: true }));
  return both;
}
"""
ROUND_TRIP = """
async () => {
  const start = performance.now();
  await (await fetch("/icon.svg")).text();
  return performance.now() - start;
}
"""


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file", nargs="?", default=str(FILE))
    parser.add_argument("--presses", type=int, default=50)
    asked = parser.parse_args()
    browser_path = shutil.which("chromium") or shutil.which("google-chrome")
    if browser_path is None:
        sys.exit("no Chromium here")
    command = [sys.executable, "-c", "from asperity.cli import main; main()", "serve", asked.file]
    server = subprocess.Popen([*command, "--port", "0", "--no-browser"], stderr=subprocess.PIPE, text=True)
    assert server.stderr is not None
    found = re.search(r"http://\S+", server.stderr.readline())
    assert found, "the server did not start"
    try:
        with sync_playwright() as driver:
            browser = driver.chromium.launch(executable_path=browser_path, args=["--no-sandbox"])
            _measure(browser, found.group(), asked.presses)
            browser.close()
    finally:
        server.terminate()
        server.wait()


def _measure(browser: object, address: str, presses: int) -> None:
    page = browser.new_page(viewport={"width": 1400, "height": 1000})  # type: ignore[attr-defined]
    page.goto(address)
    page.wait_for_selector("html[data-state=ready]", timeout=600_000)
    page.close()
    sizes: list[int] = []
    page = browser.new_page(viewport={"width": 1400, "height": 1000})  # type: ignore[attr-defined]
    page.on("response", lambda response: sizes.append(int(response.headers.get("content-length", 0))))
    page.goto(address)
    page.wait_for_selector("html[data-state=ready]")
    loaded, loaded_bytes = page.evaluate("performance.now()"), sum(sizes)
    for _ in range(5):
        page.evaluate(PRESS)
    figures, everything = zip(*(page.evaluate(PRESS) for _ in range(presses)), strict=True)
    empty = statistics.median(page.evaluate(ROUND_TRIP) for _ in range(presses))
    plots = page.locator("#plots svg[role=img]").count()
    print(f"key press, {presses} times, until what is new is on the screen:")
    _told("key figures but the torque capacity", figures, empty)
    _told(f"everything: {plots} plots, drawing and tables", everything, empty)
    print(f"empty round trip: median {empty:.1f} ms")
    print(f"first load: {loaded:.0f} ms, {loaded_bytes / 1e3:.0f} kB")


def _told(what: str, times: tuple[float, ...], empty: float) -> None:
    median = statistics.median(times)
    print(
        f"  {what}: median {median:.0f} ms, worst {max(times):.0f} ms, {median / empty:.0f} empty round trips"
    )


if __name__ == "__main__":
    main()
