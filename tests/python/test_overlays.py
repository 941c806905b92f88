# SPDX-License-Identifier: BSD-3-Clause
"""What lies over maps: cracks in the colours of their quantities, crosses and arrows."""

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.collections import LineCollection
from matplotlib.colors import to_rgb
from matplotlib.quiver import Quiver
from percolith import ArgumentError, RunDirectory, RunDirectoryError, plot
from percolith.crack_fields import (
    CRACK_FIELDS,
    chosen_segments,
    end_values,
    range_of_cracks,
    shown_values,
)
from percolith.crack_picture import MODES, OUTLINE
from percolith.cross_picture import draw_arrows
from percolith.map_picture import map_axes
from percolith.model_figure import fitting_columns
from percolith.overlays import CRACKS, Overlays, check_overlays
from percolith.run_directory import Frame
from percolith.view import view_of_frame, view_of_times
from synthetic_coupled_run import OPENING, PRESSURE
from synthetic_run import write_mechanics_run


def labels(axes) -> list[str]:
    """Labels of the colour bars and entries of the legend of a map in a figure of its own."""
    bars = [other.get_ylabel() or other.get_xlabel() for other in axes.figure.axes[1:]]
    return bars + [text.get_text() for legend in axes.figure.legends
                   for text in legend.get_texts()]


def coloured_lines(axes) -> list[np.ndarray]:
    """Values of the lines that have colours by values."""
    return [one.get_array() for one in axes.collections
            if isinstance(one, LineCollection) and one.get_array() is not None]


def test_cracks_have_the_colours_of_their_aperture(coupled):
    axes = coupled.plot("pressure", cracks="aperture")
    assert "Aperture of cracks, hydraulic (µm)" in labels(axes)
    (values,) = coloured_lines(axes)
    wet = coupled.frame().cracks.cell_data["wet"] != 0
    assert len(values) == 2 * wet.sum()
    assert values.max() == pytest.approx(1e6 * OPENING)


def test_cracks_have_the_colours_of_the_time_they_broke(coupled):
    cracks = coupled.frame().cracks
    assert np.array_equal(chosen_segments(cracks, "break_time"), cracks.cell_data["mode"] > 0)
    axes = coupled.plot("damage", cracks="break_time")
    assert "Time of breakage (ms)" in labels(axes)
    (values,) = coloured_lines(axes)
    assert np.allclose(values, 5.0)  # all at the end of the run, 5 ms


def test_pressure_in_cracks_over_a_field_of_mechanics(coupled):
    axes = coupled.plot("principal_stress_2", cracks="pressure")
    assert "Pressure in cracks (MPa)" in labels(axes)
    assert coloured_lines(axes)[0].max() == pytest.approx(PRESSURE / 1e6, rel=0.02)


def test_modes_over_a_field_of_flow(coupled):
    names = labels(coupled.plot("pressure", cracks="mode"))
    frame = coupled.frame()
    assert f"{MODES[1][0]} ({(frame.cracks.cell_data['mode'] == 1).sum()})" in names


def test_cracks_may_be_left_out(block):
    def lines(cracks):
        axes = block.plot("displacement", cracks=cracks)
        return sum(isinstance(one, LineCollection) for one in axes.collections)

    assert lines("none") == 0 and lines("thin") == lines("auto") == 1


def test_every_choice_is_there_or_says_what_is(coupled):
    for name in CRACKS:
        if name in ("head", "released_energy"):
            with pytest.raises(RunDirectoryError, match="the cracks of this run have none"):
                check_overlays(coupled, Overlays(name))
        else:
            check_overlays(coupled, Overlays(name))
            assert view_of_frame(coupled, coupled.frame(), "displacement",
                                 overlays=Overlays(name)).crack_colours != "auto"


def test_ends_of_the_colours_of_cracks(coupled):
    assert range_of_cracks("saturation", np.array([0.5])).high == 1.0
    empty = range_of_cracks("break_time", np.empty(0))
    assert (empty.low, empty.high, empty.scale.unit) == (0.0, 1.0, "s")
    cut = range_of_cracks("opening", np.append(np.full(999, 1e-6), 1.0))
    assert cut.high < 2e-6 and cut.beyond == "max"
    assert shown_values(coupled.frame(), "thin").size == 0
    flux = coupled.frame().cracks
    flux.cell_data["flux_m2_per_s"] = -flux.cell_data["flux_m2_per_s"]
    assert end_values(flux, "flux").min() > 0.0
    assert set(CRACK_FIELDS) < set(CRACKS)


def test_crosses_lie_over_any_field(block, coupled):
    assert "tension" in labels(block.plot("displacement", crosses=True))
    assert "tension" in labels(coupled.plot("pressure", crosses=True))
    assert "tension" in labels(block.plot("principal_stress_1"))
    assert "tension" not in labels(block.plot("principal_stress_1", crosses=False))
    assert "tension" not in labels(coupled.plot("principal_stress_1"))  # modes of cracks instead


def test_the_legend_tells_the_stress_of_the_longest_cross(block):
    stress = np.abs(block.frame().matrix.cell_data["principal_stress_2_Pa"])
    longest = f"longest cross: {np.percentile(stress, 95) / 1e6:.3g} MPa"
    assert longest in labels(block.plot("principal_stress_2"))
    assert longest in labels(block.plot("principal_stress_1"))  # one scale, whatever lies beneath
    assert longest in labels(block.plot("damage", crosses=True))


def pressed(run, *, peak: float = 1.0) -> Frame:
    """The last frame under -8 and -12 MPa; `peak` times as much in its first triangle."""
    frame = run.frame()
    for name, stress in (("principal_stress_1_Pa", -8e6), ("principal_stress_2_Pa", -12e6)):
        values = np.full(len(frame.matrix.cells), stress)
        values[0] *= peak
        frame.matrix.cell_data[name] = values
    return frame


def drawn_map(run, frame, field):
    overlays = Overlays(crosses=True, cracks="none")
    return map_axes(run, frame, field, view_of_frame(run, frame, field, 1.0, overlays=overlays))


@pytest.mark.parametrize("field", ["principal_stress_1", "principal_stress_2", "displacement"])
def test_arms_of_crosses_are_as_long_as_their_stress(block, field):
    axes = drawn_map(block, pressed(block), field)
    lines = np.concatenate([one.get_segments() for one in axes.collections
                            if isinstance(one, LineCollection) and len(one.get_segments())])
    lengths = np.sort(np.hypot(*(lines[:, 1] - lines[:, 0]).T))
    assert len(lengths) > 100
    half = len(lengths) // 2
    assert np.allclose(lengths[:half], lengths[-1] * 8 / 12)
    assert np.allclose(lengths[half:], lengths[-1])


def test_the_legend_tells_of_crosses_that_are_cut(block):
    for peak, is_cut in ((1.0, False), (1.04, False), (3.0, True)):
        names = labels(drawn_map(block, pressed(block, peak=peak), "principal_stress_1"))
        assert f"longest cross: 12 MPa{' (larger ones cut)' * is_cut}" in names


def test_arrows_lie_over_any_field_of_a_run_with_flow(coupled):
    for field in ("pressure", "damage"):
        axes = coupled.plot(field, arrows=True)
        (arrows,) = (one for one in axes.collections if isinstance(one, Quiver))
        assert arrows.N > 100 and any(name.startswith("longest arrow:") for name in labels(axes))
    assert not any(isinstance(one, Quiver) for one in coupled.plot("pressure").collections)


def test_fluxes_that_are_next_to_nothing_have_no_arrows(coupled):
    frame = coupled.frame()
    flow = np.tile([1e-6, 0.0], (len(frame.matrix.cells), 1))
    left = frame.matrix.points[frame.matrix.cells].mean(axis=1)[:, 0] < np.median(
        frame.matrix.points[:, 0])
    frame.matrix.cell_data["darcy_flux_m_per_s"] = flow

    def count(small):
        flow[left, 0] = small
        view = view_of_frame(coupled, frame, "pressure", 1.0, overlays=Overlays(arrows=True))
        axes = map_axes(coupled, frame, "pressure", view)
        axes.figure.canvas.draw()
        return sum(one.N for one in axes.collections if isinstance(one, Quiver))

    every, some = count(2.1e-8), count(1.9e-8)
    assert 0.3 * every < some < 0.7 * every
    assert count(0.0) == some


def test_a_moment_of_a_series_at_which_nothing_flows_has_no_arrows(coupled):
    frame = coupled.frame()
    frame.matrix.cell_data["darcy_flux_m_per_s"] = np.zeros((len(frame.matrix.cells), 2))
    axes = plt.figure().gca()
    draw_arrows(axes, frame, frame.matrix.points, 1e-6)  # of another moment
    axes.figure.canvas.draw()
    assert all(one.N == 0 for one in axes.collections)


def test_fluxes_of_rock_and_cracks_have_colours_of_their_own(coupled):
    # That of the rock is m/s, that along cracks m2/s.
    view = view_of_frame(coupled, coupled.frame(), "flux", overlays=Overlays("flux"))
    assert view.cracks is not None
    assert view.cracks.scale.unit != view.rock.scale.unit
    assert view.cracks.high >= np.percentile(shown_values(coupled.frame(), "flux"), 90)


@pytest.mark.parametrize("words, message", [
    (["--cracks", "pressure"], "--cracks = pressure: the cracks of this run have none; they have: "
                               "mode, opening, damage"),
    (["--arrows"], "--arrows shows the Darcy flux, and this is a run of mechanics"),
])
def test_what_a_run_of_mechanics_lacks(block, words, message, capsys):
    assert plot.main([str(block.path), *words]) == 2
    assert message in capsys.readouterr().err


def test_what_a_run_of_flow_lacks(tmp_path, capsys):
    (tmp_path / "resolved.toml").write_text('[model]\nphysics = "seepage"\n')
    assert plot.main([str(tmp_path), "--crosses"]) == 2
    assert "--crosses shows the principal stresses, and this is a run of flow" in (
        capsys.readouterr().err)
    with pytest.raises(RunDirectoryError, match="^crosses shows the principal stresses"):
        RunDirectory(tmp_path).plot(crosses=True)
    with pytest.raises(RunDirectoryError, match="^scale is for runs of mechanics"):
        RunDirectory(tmp_path).plot(scale=2.0)


@pytest.mark.parametrize("wrong, message", [
    ({"time": "abc"}, "time = 'abc': does not begin with a number; allowed: seconds"),
    ({"time": float("nan")}, "time = nan: not a finite time; allowed: seconds"),
    ({"scale": "x"}, "scale = 'x': allowed: "),
    ({"scale": -1}, "scale = -1: allowed: "), ({"window": [1, [2]]}, "window = .*; allowed: X0 X1"),
    ({"window": (1, 2, None, 3)}, "window = .*: not four numbers"), ({"field": 3}, "no 3 in this"),
    ({"window": (8, 9, 8, 9)}, "^window = 8 9 8 9: no rock there"),
])
def test_arguments_that_mean_nothing_name_themselves(block, wrong, message):
    with pytest.raises(RunDirectoryError, match=message):
        block.plot(**wrong)


def test_an_unknown_quantity_of_cracks(block, capsys):
    with pytest.raises(SystemExit):
        plot.main([str(block.path), "--cracks", "colour"])
    assert "invalid choice: 'colour' (choose from" in capsys.readouterr().err
    with pytest.raises(ArgumentError, match="^cracks = colour: unknown; allowed: auto, mode"):
        block.plot(cracks="colour")


def test_a_run_whose_rock_is_whole_has_no_cracks_to_miss(tmp_path):
    run = RunDirectory(write_mechanics_run(tmp_path / "run", events=0, cracked=False))
    for cracks in ("mode", "break_time"):
        assert not coloured_lines(run.plot("damage", cracks=cracks))
    with pytest.raises(RunDirectoryError, match="they have: mode, opening, slip"):
        run.plot("damage", cracks="pressure")


def test_fractures_of_rock_at_rest(run_example):
    run = run_example("single_fracture").results
    axes = run.plot("flux", cracks="aperture")
    assert any(label.startswith("Aperture of cracks") for label in labels(axes))
    assert len(coloured_lines(axes)[0]) == 2 * len(run.frame().cracks.cells)
    with pytest.raises(RunDirectoryError, match="they have: pressure, saturation, aperture, flux"):
        run.plot(cracks="mode")


def test_a_series_has_one_longest_cross_and_arrow(coupled):
    overlays = Overlays(crosses=True, arrows=True, cracks="break_time")
    view = view_of_times(coupled, coupled.times, "displacement", overlays=overlays)
    last = view_of_times(coupled, coupled.times[-1:], "displacement", overlays=overlays)
    assert view.cross >= last.cross > 0.0 and view.arrow >= last.arrow > 0.0
    assert view.cracks.low < last.cracks.low


def test_legends_fit_their_figures():
    assert fitting_columns(["tension", "compression"], 7.0) == 2
    assert fitting_columns(["tension", "compression"], 1.0) == 1
    long = ["past its peak (826)", "tensile (33)", "mixed (115)", "tension", "compression"]
    assert fitting_columns(long, 7.0) == 3
    assert fitting_columns(["longest arrow: 2.81 × $10^{-3}$ m/s"] * 2, 6.5) == 2


def test_hardly_damaged_joints_can_be_told_from_their_outlines(coupled):
    axes = coupled.plot("displacement", cracks="damage")
    (cracks,) = [one for one in axes.collections
                 if isinstance(one, LineCollection) and one.get_array() is not None]
    low = np.array(cracks.cmap(0.0)[:3])
    assert np.abs(low - np.array(to_rgb(OUTLINE))).max() > 0.25
    axes = coupled.plot("displacement", cracks="aperture")
    (cracks,) = [one for one in axes.collections
                 if isinstance(one, LineCollection) and one.get_array() is not None]
    assert cracks.cmap(0.0) == plt.get_cmap("inferno")(0.0)
