# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of an open run, for programs and notebooks: those of `percolith plot`, as figures."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

# Reading results needs no matplotlib: what draws is imported where it is called.


class RunPictures:
    """What can be drawn of a run. Maps give their axes, all else a figure; None stands for a picture
    that this run has nothing for. All raise RunDirectoryError where the run lacks what was asked
    for."""

    def plot(self, field: str | None = None, time: float | str | None = None, *,
             cracks: str = "auto", crosses: bool | None = None, arrows: bool = False,
             scale: float | None = None, window: Sequence[float] | None = None,
             ax: Axes | None = None) -> Axes:
        """A map of `field` at the frame nearest to `time` (s, or a text such as "10 ms"), the last
        one without; drawn into `ax` or a new figure. Without `field` it is the pressure of a run
        with flow, else the displacement; run.fields names all. `cracks` are coloured by
        `pressure`, `mode`, `aperture`, `break_time` or another quantity of theirs, drawn `thin` or not at all (`none`); `auto`
        suits the field. `crosses` of the principal stresses and `arrows` of the Darcy flux lie over
        it. `scale` multiplies the displacements, None chooses it. `window` is the part to show: X0,
        X1, Y0, Y1 in m."""
        from percolith import pictures
        from percolith.overlays import Overlays
        from percolith.window import as_window

        options = pictures.MapOptions(scale, as_window(window), Overlays(cracks, crosses, arrows))
        options.check(self)
        field = pictures.check_field(self, field) or pictures.default_field(self)
        return pictures.draw_map(self, self.frame(time), field, options, ax)

    @property
    def fields(self) -> tuple[str, ...]:
        """What `plot` and `animate` can show of this run."""
        from percolith.pictures import fields_of

        return fields_of(self)

    def plot_history(self, of: str | None = None) -> Figure:
        """The history `of` the `rock` (energies, their balance, broken joints, reactions) or of the
        `fluid` (volumes, mass balance, pressures, rates); without `of` that of the rock, in a run of
        flow that of the fluid."""
        from percolith.pictures import history_of

        return history_of(self, of)

    def plot_crack_growth(self) -> Figure | None:
        """Pressure of injection, length, volume and aperture of cracks, and what went into them,
        over time. None in a run whose history has none of them."""
        from percolith.crack_growth_picture import crack_growth_figure

        return crack_growth_figure(self)

    def plot_loading(self) -> Figure | None:
        """The reaction of each loaded boundary over its displacement. None where nothing is."""
        from percolith.pictures import loading_of

        return loading_of(self)

    def plot_events(self, window: Sequence[float] | None = None) -> Figure | None:
        """Magnitudes of the joints that broke over time, their places (those in the window X0, X1,
        Y0, Y1 in m), energies, and numbers over the magnitude with the b-value. None where no joint
        broke."""
        from percolith.event_picture import events_figure
        from percolith.window import as_window

        return events_figure(self, as_window(window))

    def plot_probes(self, field: str | None = None,
                    reference: str | os.PathLike | Sequence[str | os.PathLike] = ()) -> Figure:
        """Profiles and series of all probes: of flow `field`, or the pressure; of mechanics every
        component. Values of the CSV files `reference` lie over them as markers. Raises CaseError
        with FILE:LINE of every mistake in these."""
        from percolith.pictures import check_field
        from percolith.probe_picture import probes_figure
        from percolith.reference_curves import read_references

        return probes_figure(self, check_field(self, field) or "pressure",
                             read_references(reference, self))

    def animate(self, file: str | os.PathLike | None = None, field: str | None = None, *,
                cracks: str = "auto", crosses: bool | None = None, arrows: bool = False,
                scale: float | None = None, window: Sequence[float] | None = None) -> Path:
        """Writes a field over time to `file`, a GIF or an MP4 by its ending, or to FIELD.gif in the
        run directory, and returns where. The options are those of `plot`; without `field` it is the
        pressure of a run with flow, else the first principal stress. An MP4 needs the package
        av."""
        from percolith.animation import draw_animation
        from percolith.overlays import Overlays
        from percolith.window import as_window

        return draw_animation(self, field, Path(file) if file is not None else None, scale,
                              as_window(window), Overlays(cracks, crosses, arrows))
