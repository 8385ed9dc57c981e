"""What a user does on the page in a browser, waiting until it has been redrawn."""


def do(page, action):
    """Do something and wait until the page has been redrawn."""
    before = int(page.evaluate("document.documentElement.dataset.revision"))
    action()
    page.wait_for_function(
        "before => Number(document.documentElement.dataset.revision) > before", arg=before, timeout=300_000
    )


def field(page, path):
    """The field of a key by its dotted path."""
    return page.locator(f"#value-{path.replace('.', '-')}")


def write(page, path, text):
    """Write a text into the field of a key."""

    def action():
        field(page, path).fill(text)
        field(page, path).press("Enter")

    do(page, action)
