"""Take ``images/page.png``: the page with the tutorial's joint, in a headless Chromium of the system."""

from pathlib import Path

from page_in_browser import served

HERE = Path(__file__).parent


def main() -> None:
    """Serve the joint, and take the picture once its numbers are there."""
    with served(HERE.parent / "examples" / "tutorial_joint.toml") as opened:
        opened(1400, 1180).screenshot(path=HERE / "images" / "page.png")


if __name__ == "__main__":
    main()
