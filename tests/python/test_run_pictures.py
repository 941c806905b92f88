# SPDX-License-Identifier: BSD-3-Clause
"""The pictures as functions of an open run."""

import subprocess
import sys

import matplotlib.pyplot as plt
import numpy as np
import percolith
import pytest
from percolith import RunDirectoryError, pictures, plot
from synthetic_coupled_run import SIZE
from synthetic_run import write_mechanics_run


def quantities(figure) -> list[str]:
    """What the panels that are shown have on their axes, without units."""
    return [axes.get_ylabel().split(" (")[0] for axes in figure.axes if axes.get_visible()]


def test_defaults(block, coupled):
    assert "Displacement, t = 2 ms" in block.plot().get_title()
    assert "Pressure, t = 5 ms" in coupled.plot().get_title()
    assert "t = 0 ms" in block.plot("damage", time=1e-4).get_title()


def test_times_have_units(block, tmp_path):
    assert block.frame("2 ms").time == block.frame(2e-3).time == block.frame("0.002").time
    assert "t = 0 ms" in block.plot("damage", time="10 us").get_title()
    assert plot.main([str(block.path), "--field", "damage", "--time", "10 us", "--output",
                      str(tmp_path / "early.png")]) == 0
    with pytest.raises(RunDirectoryError, match='time = .2 MPa.: the unit "MPa" is not '):
        block.plot(time="2 MPa")
    with pytest.raises(RunDirectoryError, match="time = .noon.: does not begin with a number"):
        block.frame("noon")
    with pytest.raises(RunDirectoryError, match="no time; allowed: seconds, or a number with a"):
        block.frame([1.0])


def test_a_map_can_be_a_part_of_a_figure(coupled):
    figure, (left, right) = plt.subplots(1, 2, figsize=(14, 6))
    assert coupled.plot("pressure", ax=left, arrows=True) is left
    assert coupled.plot("damage", ax=right, crosses=True) is right
    assert not figure.legends
    names = [text.get_text() for text in right.get_legend().get_texts()]
    assert "tension" in names and "broken from the start (4)" in names
    assert left.get_legend() and figure.get_size_inches().tolist() == [14.0, 6.0]


def test_a_window_has_four_ends(coupled):
    axes = coupled.plot("pressure", window=(0.0, 1.0, -0.5, 0.5), scale=1)
    assert axes.get_xlim() == (0.0, 1.0) and axes.get_ylim() == (-0.5, 0.5)
    for wrong, reason in (((0.0, 1.0), "not four numbers"), ((1.0, 0.0, 0.0, 1.0), "reversed")):
        with pytest.raises(RunDirectoryError, match=f"window = .*: {reason}; allowed: X0 X1 Y0 Y1"):
            coupled.plot(window=wrong)
    with pytest.raises(RunDirectoryError, match="no rock there"):
        coupled.plot(window=(5 * SIZE, 6 * SIZE, 0.0, 1.0))


def test_a_scale_must_mean_something(block):
    assert "displacements × 3" in block.plot(scale=3).get_title()
    with pytest.raises(RunDirectoryError, match="scale = -1: allowed: a number that is not"):
        block.plot(scale=-1)


def test_histories(block, coupled):
    rock = ["Energy held", "Energy exchanged", "Energy residual", "Unbalanced force ratio",
            "Broken joints", "Reaction", "Fragments"]
    assert quantities(block.plot_history()) == rock
    assert quantities(coupled.plot_history()) == quantities(coupled.plot_history("rock")) == rock
    fluid = ["Fluid volume", "Mass balance error", "Pressure", "Rate into the model"]
    assert quantities(coupled.plot_history("fluid")) == fluid
    with pytest.raises(RunDirectoryError, match="history of fluid: .* has none; allowed: rock"):
        block.plot_history("fluid")


def test_a_steady_run_has_no_history(run_example):
    run = run_example("radial").results
    with pytest.raises(RunDirectoryError, match="a steady run has no history"):
        run.plot_history()
    assert run.plot_events() is None and run.plot_loading() is None
    assert run.plot_crack_growth() is None
    assert quantities(run.plot_probes())


def test_injection_events_and_loading(block, coupled):
    growth = quantities(coupled.plot_crack_growth())
    assert growth[:2] == ["Pressure at the source", "Length of cracks"]
    assert block.plot_crack_growth() is None
    assert quantities(block.plot_events()) == [
        "Magnitude M", "y", "Released energy, summed", "Number of events of M or more"]
    (axes,) = block.plot_loading().axes
    assert axes.get_title() == "boundary.top, y\npeak \N{MINUS SIGN}1.05 MN/m at \N{MINUS SIGN}70.4 µm"


def test_probes(block, coupled, tmp_path):
    assert quantities(block.plot_probes())[0] == "Displacement along x"
    assert "Saturation" in quantities(coupled.plot_probes("saturation"))
    bare = percolith.open_run(write_mechanics_run(tmp_path / "bare"))
    (bare.path / "probes/axis.csv").unlink()
    with pytest.raises(RunDirectoryError, match="this run has no probes"):
        bare.plot_probes()


def test_reactions_that_are_noise_have_no_panel(tmp_path):
    directory = write_mechanics_run(tmp_path / "results")
    with open(directory / "resolved.toml", "a") as file:
        file.write("[material.rock]\nyoung_modulus = 3e10\n")
    run = percolith.open_run(directory)
    assert "Reaction" in quantities(run.plot_history())
    for name in run.history:
        if "reaction" in name:
            run.history.columns[name] = 1e-6 * run.history[name]
    assert "Reaction" not in quantities(run.plot_history())


def test_the_command_line_draws_the_same_picture(coupled, monkeypatch, tmp_path):
    saved = []
    monkeypatch.setattr(pictures, "save", lambda figure, path: saved.append(figure) or path)
    words = ["--field", "displacement", "--output", str(tmp_path / "command.png")]
    assert plot.main([str(coupled.path), *words, "--cracks", "aperture", "--crosses"]) == 0
    ours = coupled.plot("displacement", cracks="aperture", crosses=True)
    theirs = saved[0].axes[0]
    assert ours.get_title() == theirs.get_title()
    assert len(ours.collections) == len(theirs.collections) > 4
    for one, other in zip(ours.collections, theirs.collections):
        assert np.array_equal(one.get_array(), other.get_array())
        assert len(one.get_paths()) == len(other.get_paths())


def test_vector_graphics(block, tmp_path, capsys):
    output = tmp_path / "damage.svg"
    assert plot.main([str(block.path), "--field", "damage", "--output", str(output)]) == 0
    assert output.read_bytes().startswith(b"<?xml")
    with pytest.raises(SystemExit):
        plot.main([str(block.path), "--output", "damage.jpeg2"])
    assert "not the name of a picture; allowed: FILE.png, FILE.pdf, FILE.svg" in (
        capsys.readouterr().err)


def test_results_open_without_matplotlib(block):
    code = ("import sys; sys.modules['matplotlib'] = None\n"
            "import percolith\n"
            f"print(len(percolith.open_run({str(block.path)!r}).frame().matrix.cells))")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.strip() == "1600"
