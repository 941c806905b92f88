# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx's settings; its sources are what staging.py has written."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import staging  # noqa: E402

project = "Percolith"
version = release = staging.version()
html_title = f"Percolith {version}"
language = "en"
extensions = ["myst_parser", "sphinx.ext.autodoc", "docstrings", "mathml", "source_pages"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
# Quotes belong to values.
smartquotes = False
exclude_patterns = ["_extra"]
autodoc_member_order = "bysource"
autodoc_typehints = "description"
html_theme = "furo"
html_math_renderer = "mathml"
html_static_path = [str(HERE / "static")]
html_extra_path = ["../../build/docs-source/_extra"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sphinx = False
html_show_copyright = False
html_last_updated_fmt = None
pygments_style = "a11y-high-contrast-light"
pygments_dark_style = "a11y-high-contrast-dark"
# A reader without a network must get all of it.
html_theme_options = {"footer_icons": []}
