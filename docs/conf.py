"""How the documentation is built: `python -m sphinx -j 2 -W docs docs/_build/html`. The pages need no network."""

from __future__ import annotations

import importlib.metadata
import re
from typing import Any

import numpydoc.docscrape_sphinx
from jinja2.sandbox import SandboxedEnvironment

project = "asperity"
author = "the asperity authors"
copyright = "the asperity authors, Apache-2.0"
try:
    release = importlib.metadata.version("asperity")
except importlib.metadata.PackageNotFoundError:
    release = "from source"

extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "numpydoc",
    "sphinx_copybutton",
    "sphinx.ext.mathjax",
    "sphinx-mathjax-offline",  # copies MathJax and its fonts into the pages instead of fetching them
]
templates_path = ["_templates"]
exclude_patterns = ["_build", "_templates"]

html_theme = "furo"
html_title = "asperity"
html_static_path = ["_static"]
html_css_files = ["asperity.css"]
html_show_sphinx = False

myst_enable_extensions = ["colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 3
nb_execution_mode = "cache"  # a page that computes runs once, and again only after it has changed
nb_execution_raise_on_error = True
nb_execution_timeout = 600  # a slow machine compiles for minutes
nb_merge_streams = True

autosummary_generate = True
autodoc_default_options = {"members": True, "show-inheritance": False}
autodoc_member_order = "bysource"
autodoc_typehints = "none"  # the docstrings say it, with shape and unit
autodoc_preserve_defaults = True
numpydoc_show_class_members = False
numpydoc_validation_checks: set[str] = set()

suppress_warnings = ["mystnb.unknown_mime_type"]


_templates: list[SandboxedEnvironment] = []


def _one_environment(loader: Any) -> SandboxedEnvironment:
    """The templates of numpydoc, which it would compile again for each of 12,000 docstrings."""
    if not _templates:
        _templates.append(SandboxedEnvironment(loader=loader))
    return _templates[0]


numpydoc.docscrape_sphinx.SandboxedEnvironment = _one_environment


def _skip(app: Any, what: str, name: str, thing: Any, skip: bool, options: Any) -> bool | None:
    """Leave out what is not written as a class of its own: specialised generics and names of types."""
    return (
        True
        if "[" in name or getattr(thing, "__name__", name).rpartition(".")[2] != name.rpartition(".")[2]
        else None
    )


def _escape_shapes(app: Any, what: str, name: str, thing: Any, options: Any, lines: list[str]) -> None:
    """Keep the star of a shape like (2, *grid) from starting an emphasis."""
    lines[:] = [re.sub(r"(?<=[( ])\*(?=[\w-]+[),])", r"\\*", line) for line in lines]


def _short_navigation(app: Any, page: str, template: str, context: dict[str, Any], doctree: Any) -> None:
    """List the pages and the rooms of the package beside every page, but not each of its hundreds of modules."""
    tree = context.get("toctree")
    if tree is not None:
        context["toctree"] = lambda **options: tree(**(options | {"collapse": True, "maxdepth": 2}))


def setup(app: Any) -> None:
    """Connect all three: the shapes before numpydoc sees them, the navigation before the theme asks for it."""
    # it only copies files; unless it says so, one process reads all pages
    app.extensions["sphinx-mathjax-offline"].parallel_read_safe = True
    app.connect("html-page-context", _short_navigation, priority=100)
    app.connect("autodoc-skip-member", _skip)
    app.connect("autodoc-process-docstring", _escape_shapes, priority=100)
