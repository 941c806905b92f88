# SPDX-License-Identifier: BSD-3-Clause
"""The parts of the page that `percolith report` makes of a run: what it says in words and tables,
pictures, and a view to move about in."""
