# SPDX-License-Identifier: BSD-3-Clause
"""What lies over the field of a map: cracks in the colours of a quantity, crosses of the principal
stresses, arrows of the flux."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from percolith.crack_fields import CRACK_FIELDS, has_crack_field
from percolith.flow_fields import FIELDS, flux_size
from percolith.mechanics_fields import STRESSES, array_of
from percolith.run_directory import ArgumentError, Frame, RunDirectory

CRACKS = ("auto", "mode", *CRACK_FIELDS, "thin", "none")
"""What cracks can be coloured by; `thin` draws them dark."""
_PERCENT = 95.0  # of the crosses and arrows are drawn in full, those beyond are cut


@dataclass(frozen=True)
class Overlays:
    """What was asked for; `auto` and None leave the choice to the field."""

    cracks: str = "auto"
    crosses: bool | None = None  # of the principal stresses
    arrows: bool = False  # of the Darcy flux

    def colours_of_cracks(self, field: str, shows_modes: bool) -> str:
        """One of CRACKS but `auto`. Pictures of flow fill cracks with the same quantity;
        `shows_modes` tells modes apart in all others, which that of the damage always does."""
        if self.cracks != "auto":
            return self.cracks
        if field in FIELDS:
            return "thin" if field == "flux" else field
        return "mode" if field == "damage" or shows_modes else "thin"

    def has_crosses(self, field: str, colours: str) -> bool:
        """Whether there are crosses: where not said, over principal stresses, unless cracks have
        colours, which they would hide."""
        return field in STRESSES and colours == "thin" if self.crosses is None else self.crosses

    def has_arrows(self, field: str) -> bool:
        return self.arrows or field == "flux"


def check_overlays(run: RunDirectory, overlays: Overlays) -> None:
    """Raises RunDirectoryError where the run has nothing to draw what was asked for from."""
    if overlays.cracks not in CRACKS:
        raise ArgumentError(f"cracks = {overlays.cracks}: unknown; allowed: {', '.join(CRACKS)}")
    if overlays.crosses and not run.has_mechanics:
        raise ArgumentError("crosses shows the principal stresses, and this is a run of flow")
    if overlays.arrows and not run.has_flow:
        raise ArgumentError("arrows shows the Darcy flux, and this is a run of mechanics")
    if overlays.cracks in ("auto", "thin", "none"):
        return
    known = _quantities_of_cracks(run)
    if overlays.cracks not in known:
        raise ArgumentError(f"cracks = {overlays.cracks}: the cracks of this run have none; "
                            f"they have: {', '.join(known)}")


def _quantities_of_cracks(run: RunDirectory) -> list[str]:
    """What cracks of this run can be coloured by; where none has appeared, what they would have."""
    cracks, names = run.last_cracks, ("mode", *CRACK_FIELDS)
    if cracks is not None:
        return [name for name in names if has_crack_field(cracks, name)]
    of_fluid = [name for name, field in CRACK_FIELDS.items() if field.which == "wet"]
    return [name for name in names if (run.has_flow if name in of_fluid else run.has_mechanics)]


def stress_sizes(frame: Frame) -> np.ndarray:
    """The larger magnitude of both principal stresses (Pa) of every triangle, (n,)."""
    data = frame.matrix.cell_data
    return np.max([np.abs(array_of(data, name)) for name in STRESSES.values()], axis=0)


def cross_size(frame: Frame) -> float:
    """The stress (Pa) that the longest line of a cross stands for. It is one of both principal
    stresses, whichever the picture shows: by the smaller of them alone, the longer arms would be
    cut to the length of the shorter ones, and all crosses look alike."""
    return _largest(stress_sizes(frame))


def arrow_size(frame: Frame) -> float:
    """The Darcy flux (m/s) that the longest arrow stands for."""
    return _largest(flux_size(frame))


def _largest(size: np.ndarray) -> float:
    size = size[np.isfinite(size)]
    return float(np.percentile(size, _PERCENT)) if len(size) else 0.0
