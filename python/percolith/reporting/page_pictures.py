# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a page: those of `percolith plot`, drawn anew, and animations that are there."""

from __future__ import annotations

import base64
from dataclasses import dataclass

from percolith.flow_fields import LABEL
from percolith.mechanics_fields import LABEL as MECHANICS_LABEL
from percolith.mechanics_fields import label_of
from percolith.pictures import MapOptions, default_fields, draw_map, table_figures
from percolith.reporting.outcome import history_of
from percolith.run_directory import Frame, RunDirectory
from percolith.saving import png_of

LARGEST_ANIMATION = 30_000_000  # bytes
_FILMS = {".gif": "image/gif", ".mp4": "video/mp4", ".webm": "video/webm"}
_CAPTIONS = {
    "probes": "What the probes recorded.",
    "loading": "Reaction of each loaded boundary and body over its displacement.",
    "events": "The joints that broke: when, where, how much energy they released, and how many "
              "there are above each magnitude.",
    "crack_growth": "Pressure at the sources; length, volume and aperture of the cracks; where the "
                    "fluid went.",
    "fluid": "Volumes of the fluid, error of their balance, extremes of the pressure, and the rate "
             "at which each condition lets fluid in.",
}
_HISTORY_OF_FLOW = _CAPTIONS["fluid"]
_HISTORY_OF_MECHANICS = ("Energies and what their balance lacks, unbalanced force, broken joints "
                         "and fragments, and reactions over time.")


@dataclass(frozen=True)
class PagePicture:
    """A picture or film with its content; `content` is empty where it is too large to hold."""

    name: str
    caption: str
    kind: str
    content: str  # base64

    @property
    def is_film(self) -> bool:
        return self.kind.startswith("video")


def _field_words(name: str) -> str:
    return (LABEL | MECHANICS_LABEL).get(name, name.replace("_", " ").capitalize())


def _caption(run: RunDirectory, name: str) -> str:
    if name == "history":
        return _HISTORY_OF_MECHANICS if run.has_mechanics else _HISTORY_OF_FLOW
    return _CAPTIONS.get(name) or f"{_field_words(name)}."


def _text(content: bytes) -> str:
    return base64.b64encode(content).decode()


def _picture(run: RunDirectory, name: str, figure) -> PagePicture:
    return PagePicture(name, _caption(run, name), "image/png", _text(png_of(figure)))


def _map(run: RunDirectory, frame: Frame, name: str, options: MapOptions) -> PagePicture:
    caption = f"{LABEL.get(name) or label_of(frame, name)}."
    figure = draw_map(run, frame, name, options).figure
    return PagePicture(name, caption, "image/png", _text(png_of(figure)))


def drawn(run: RunDirectory, time: float | str | None, scale: float | None) -> list[PagePicture]:
    """What `percolith plot` draws of the frame nearest to `time`; nothing is left in the run
    directory. Of a run without frames what its tables give, without tables nothing of them."""
    pictures = []
    if run.times:
        frame, options = run.frame(time), MapOptions(scale)
        pictures += [_map(run, frame, name, options) for name in default_fields(run, frame)]
    if run.probe_names:
        pictures.append(_picture(run, "probes", run.plot_probes()))
    if history_of(run):
        pictures += [_picture(run, name, figure) for name, figure in table_figures(run).items()]
    return pictures


def animations(run: RunDirectory) -> list[PagePicture]:
    """The animations that `percolith plot --animate` has left; one that is too large is named
    alone."""
    found = []
    for path in sorted(run.path.iterdir()):
        kind = _FILMS.get(path.suffix.lower())
        if kind is None:
            continue
        caption = f"{_field_words(path.stem)} over time ({path.name})."
        if path.stat().st_size > LARGEST_ANIMATION:
            megabytes = path.stat().st_size / 1e6
            caption += f" It has {megabytes:.0f} MB and is not in this page."
            found.append(PagePicture(path.stem, caption, kind, ""))
        else:
            found.append(PagePicture(path.stem, caption, kind, _text(path.read_bytes())))
    return found
