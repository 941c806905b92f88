# SPDX-License-Identifier: BSD-3-Clause
"""A case while it runs: the bits of the command line, parts, looks, writes."""

import gc
import json
from pathlib import Path

import numpy as np
import percolith
import pytest
from conftest import SHORT, short_case
from percolith.toml_text import inline

ROOT = Path(__file__).resolve().parents[2]


def results(folder: Path) -> dict[str, object]:
    """All that is to be equal: every file but the log, and of the summary but the wall times."""
    files = {}
    for path in sorted(folder.rglob("*")):
        if path.is_file() and path.name not in ("run.log", "summary.json"):
            files[str(path.relative_to(folder))] = path.read_bytes()
    summary = json.loads((folder / "summary.json").read_text())
    del summary["wall_time_s"]
    return {**files, "summary": summary}


@pytest.mark.parametrize("name", SHORT)
def test_files_are_those_of_the_command_line(name, program, tmp_path):
    settings = [word for key, value in SHORT[name].items()
                for word in ("--set", f"{key}={inline(value)}")]
    ended = program("run", ROOT / f"examples/{name}/case.toml", "--output", tmp_path / "one",
                    "--quiet", *settings)
    assert ended.returncode == 0, ended.stderr
    run = short_case(name).run(tmp_path / "two")
    assert results(tmp_path / "one") == results(tmp_path / "two")
    assert len(run.times) >= 3


@pytest.mark.parametrize("name", SHORT)
def test_a_run_in_parts_with_looks_in_between_is_a_run_in_one(name, tmp_path):
    whole = short_case(name).run(tmp_path / "whole")
    with short_case(name).simulation(tmp_path / "parts") as simulation:
        while simulation.advance(steps=7):
            simulation.frame()
            simulation.values()
            simulation.summary()
    assert results(tmp_path / "whole") == results(tmp_path / "parts")
    assert simulation.state_hash == whole.summary["state_hash"]


def test_advance_stops_where_it_is_told(strip):
    simulation = strip.simulation()
    assert simulation.advance(until="4.5 ms") and simulation.time == pytest.approx(0.005)
    assert simulation.advance(until=0.0051) and simulation.time == pytest.approx(0.006)
    assert not simulation.advance(until=0.0051) and simulation.time == pytest.approx(0.006)
    assert not simulation.advance(until=0.0055) and simulation.steps == 6
    assert simulation.advance(output=True) and simulation.time == pytest.approx(0.01)
    assert simulation.advance(steps=2) and simulation.steps == 12
    assert not simulation.advance() and simulation.time == simulation.end
    assert not simulation.advance() and simulation.is_over


def test_a_loop_until_a_time_ends(strip, coupled):
    for case, until in [(strip, "2.5 ms"), (strip, "3 ms"), (strip, "1 s"), (coupled, "3 us")]:
        simulation, calls = case.simulation(), 0
        while simulation.advance(until=until):
            calls += 1
            assert calls == 1
        assert simulation.is_over == (until == "1 s")
        assert simulation.time >= min(percolith.quantity(until, "s"), simulation.end) * (1 - 1e-9)
    simulation = strip.simulation()
    times = [simulation.time for wanted in np.arange(1, 9) * 0.3e-3
             if simulation.advance(until=wanted)]
    assert times == pytest.approx([0.001, 0.002, 0.003])


def test_a_time_that_has_passed_is_refused(strip):
    simulation = strip.simulation()
    assert not simulation.advance(until=0)
    with pytest.raises(percolith.CaseError, match="until = -1: the simulation is at 0 s already"):
        simulation.advance(until=-1)
    simulation.advance(steps=5)
    assert not simulation.advance(until="5 ms")
    for past in ("1 ms", 0, 0.0049):
        with pytest.raises(percolith.CaseError, match="the simulation is at 0.005 s already"):
            simulation.advance(until=past)
    assert simulation.steps == 5
    simulation.advance()
    with pytest.raises(percolith.CaseError, match="0.02 s already"):
        simulation.advance(until="1 ms")


@pytest.mark.parametrize("wrong", [
    {"steps": 0}, {"steps": 2.5}, {"steps": "2"}, {"steps": True}, {"until": "3 MPa"},
    {"until": float("nan")}, {"until": "abc"}, {"until": [1.0]},
])
def test_a_pause_that_is_none_is_refused(strip, wrong):
    with pytest.raises(percolith.CaseError, match="error: "):
        strip.simulation().advance(**wrong)


def test_a_steady_case_has_one_step(strip):
    strip["time"] = {"scheme": "steady"}
    del strip["output.times"]
    del strip["initial"]
    simulation = strip.simulation()
    assert not simulation.advance(steps=1) and simulation.steps == 1


def test_callbacks_see_every_step_and_output(strip):
    outputs, steps = [], []
    simulation = strip.simulation()
    simulation.run(on_output=lambda s: outputs.append(s.time), on_step=lambda s: steps.append(s.steps))
    assert outputs == pytest.approx([0, 0.005, 0.01, 0.02])
    assert steps == list(range(1, 21))
    again = []
    strip.simulation().run(on_output=lambda s: again.append(s.time))
    assert again == pytest.approx(outputs)


def test_arrays_are_views_that_follow_the_state(strip):
    simulation = strip.simulation()
    pressure = simulation.flow.pressure
    before = pressure.copy()
    simulation.advance(steps=1)
    assert not np.array_equal(before, pressure)
    assert np.shares_memory(pressure, simulation.flow.pressure)
    with pytest.raises(ValueError):
        pressure[0, 0, 0] = 1.0
    values = simulation.triangle_values(pressure)
    frame = simulation.frame().matrix
    assert np.array_equal(values, frame.point_data["pressure_Pa"][frame.cells])


def test_arrays_outlive_their_simulation(strip):
    simulation = strip.simulation()
    pressure = simulation.flow.pressure
    vertices = simulation.mesh.vertices
    frame = simulation.frame()
    del simulation
    gc.collect()
    assert np.isfinite(pressure).all() and np.isfinite(vertices).all()
    assert np.isfinite(frame.matrix.points).all()


def test_the_mesh_fits_together(coupled):
    mesh = coupled.simulation().mesh
    corners = mesh.joint_corners
    triangle, local = corners // 24 * 8 + corners % 8, corners % 24 // 8
    vertices = mesh.triangles[triangle, local]
    assert np.array_equal(vertices[:, 0], mesh.joint_vertices)
    assert np.array_equal(vertices[:, 1], mesh.joint_vertices)
    assert mesh.region.shape == (len(mesh.triangles),)
    assert mesh.region_names == ["rock"]


def test_a_coupled_state_has_both_halves(coupled):
    with coupled.simulation() as simulation:
        simulation.advance(until="10 us")
        motion, flow, mesh = simulation.motion, simulation.flow, simulation.mesh
        assert np.abs(motion.displacement_x).max() > 0
        assert motion.joint_state.shape == (len(mesh.joint_vertices),)
        assert set(np.unique(motion.joint_state)) <= {0, 1, 2, 3, 4}
        assert len(motion.joint_damage_0) == len(mesh.joint_vertices)
        assert flow.crack_pressure.shape == (len(mesh.vertices),)
        assert (flow.crack_pressure[flow.crack_nodes] > 0).any()
        assert (flow.aperture[flow.broken_joints] > 0).all()
        assert {"kinetic_J_per_m", "fluid_work_J_per_m"} <= simulation.energies.keys()
        assert simulation.mass_balance["in_m2"] > 0
        assert len(simulation.probe("tip")) == 1
        assert len(simulation.probe_history("tip")) == 3
        assert simulation.frame().cracks is not None
        assert "mode" in simulation.events


def test_what_a_run_lacks_is_told(strip, mechanics):
    flow = strip.simulation()
    with pytest.raises(percolith.RunDirectoryError, match="no energies"):
        flow.energies
    assert flow.motion is None
    with pytest.raises(percolith.RunDirectoryError, match="^no probe nothing; there are: centre$"):
        flow.probe("nothing")
    with pytest.raises(percolith.RunDirectoryError, match="writes no results"):
        flow.results()
    flow.advance(steps=1)
    for pieces in ("events", "fragments"):
        with pytest.raises(percolith.RunDirectoryError, match=f"^a run of flow has no {pieces}$"):
            getattr(flow, pieces)
    with pytest.raises(KeyError, match="no column pressure; there are: pressure_Pa, time_s"):
        flow.probe("centre")["pressure"]
    with pytest.raises(KeyError, match="no array saturatio; there are: saturation, "):
        flow.frame().matrix.point_data["saturatio"]
    rock = mechanics.simulation()
    for pieces in ("events", "fragments"):
        with pytest.raises(percolith.RunDirectoryError, match=f"^there are no {pieces} before the"):
            getattr(rock, pieces)
    assert rock.flow is None
    with pytest.raises(percolith.RunDirectoryError, match="no mass balance"):
        rock.mass_balance


def test_pressures_are_written(strip):
    simulation = strip.simulation()
    x = simulation.mesh.vertices[:, 0]
    simulation.set_pressure(1e4 + 1e3 * x)
    values = simulation.triangle_values(simulation.flow.pressure)
    assert values == pytest.approx((1e4 + 1e3 * x)[simulation.mesh.triangles], rel=1e-12)
    simulation.advance(steps=3)
    simulation.set_pressure(5e4)
    assert abs(simulation.mass_balance["relative_error"]) < 1e-12
    simulation.advance(steps=3)
    simulation.set_pressure(simulation.triangle_values(simulation.flow.pressure))
    simulation.advance()
    assert abs(simulation.mass_balance["relative_error"]) < 1e-12


def test_displacements_and_velocities_are_given_before_the_start(mechanics, tmp_path):
    simulation = mechanics.simulation()
    places = simulation.mesh.vertices.copy()
    former = simulation.motion.displacement_x
    simulation.set_motion(displacement=1e-5 * places, velocity=np.full(places.shape, 0.5))
    values = simulation.triangle_values(simulation.motion.displacement_x)
    assert np.array_equal(values, (1e-5 * places[:, 0])[simulation.mesh.triangles])
    assert not former.any()
    assert simulation.energies["elastic_J_per_m"] > 0 and simulation.energies["kinetic_J_per_m"] > 0
    simulation.advance(steps=20)
    assert simulation.summary()["mechanics"]["energy_error"] < 1e-3
    with pytest.raises(percolith.CaseError, match="the run has begun"):
        simulation.set_motion(velocity=places)
    with pytest.raises(percolith.CaseError, match="writes results"):
        mechanics.simulation(tmp_path / "results").set_motion(velocity=places)


def test_displacements_that_cannot_be_are_refused(mechanics, coupled):
    simulation = mechanics.simulation()
    places = simulation.mesh.vertices
    for wrong, message in [(-2 * places * [1, 0], "over"), (np.nan * places, "not finite"),
                           (np.zeros(3), "array of shape")]:
        with pytest.raises(percolith.CaseError, match=f"displacement.*{message}"):
            simulation.set_motion(displacement=wrong)
    wet = coupled.simulation()
    with pytest.raises(percolith.CaseError, match="model.physics"):
        wet.set_motion(velocity=wet.mesh.vertices)


def test_pressures_in_cracks_are_written(coupled):
    simulation = coupled.simulation()
    simulation.set_crack_pressure(2e6)
    nodes = simulation.flow.crack_nodes
    assert simulation.flow.crack_pressure[nodes] == pytest.approx(2e6, rel=1e-12)
    simulation.advance(steps=3)
    assert abs(simulation.mass_balance["relative_error"]) < 1e-9
    assert np.abs(simulation.motion.displacement_y).max() > 0


def test_pressures_are_written_in_place(coupled):
    simulation = coupled.simulation()
    nodes = simulation.flow.crack_nodes
    with simulation.writing() as fluid:
        assert np.shares_memory(fluid.pressure, simulation.flow.pressure)
        assert fluid.pressure.shape == simulation.flow.pressure.shape
        fluid.pressure[...] = 1e5
        fluid.crack_pressure[nodes] += 2e6
        with pytest.raises(percolith.CaseError, match="being written to"):
            simulation.advance()
    assert simulation.triangle_values(simulation.flow.pressure) == pytest.approx(1e5, rel=1e-12)
    assert simulation.flow.crack_pressure[nodes] == pytest.approx(2e6, rel=1e-12)
    given = coupled.simulation()
    given.set_pressure(1e5)
    given.set_crack_pressure(2e6)
    assert simulation.state_hash == given.state_hash
    simulation.advance(steps=3)
    assert abs(simulation.mass_balance["relative_error"]) < 1e-9


def test_what_a_block_leaves_behind_cannot_be_written_to(strip):
    simulation = strip.simulation()
    simulation.advance(steps=3)
    kept = []
    with simulation.writing() as fluid:
        part = fluid.pressure[0]
        part += 1.0
        inner = part.T
        inner *= 1.0
        kept += [fluid.pressure, fluid.crack_pressure, part, inner,
                 fluid.crack_pressure.reshape(1, -1), fluid.pressure[0][1:].swapaxes(0, 1), fluid.pressure.base]
        own = fluid.pressure + 1.0
        fluid.pressure[0] -= 1.0
    with pytest.raises(KeyError), simulation.writing() as fluid:
        kept.append(fluid.pressure)
        raise KeyError
    before = simulation.state_hash
    for array in kept:
        with pytest.raises(ValueError, match="read-only"):
            array[...] = 7.0
    own[...] = 7.0
    assert type(own) is np.ndarray and type(own.max()) is np.float64
    assert simulation.state_hash == before
    simulation.advance()
    assert abs(simulation.mass_balance["relative_error"]) < 1e-12


@pytest.mark.parametrize("ended", ["closed", "at its end"])
def test_a_run_that_is_over_takes_no_changes(strip, tmp_path, ended):
    simulation = strip.simulation(tmp_path / "results")
    if ended == "closed":
        simulation.advance(steps=2)
        simulation.close()
    else:
        simulation.advance()
    before = simulation.state_hash
    for change in (lambda: simulation.set_pressure(1e5), lambda: simulation.set_crack_pressure(1e5),
                   lambda: simulation.writing().__enter__(),
                   lambda: simulation.set_condition("boundary.left.pressure", 1.0)):
        with pytest.raises(percolith.CaseError, match="the run is over or closed"):
            change()
    assert simulation.state_hash == before


def test_pressures_with_a_unit(strip):
    simulation, other = strip.simulation(), strip.simulation()
    simulation.set_pressure("0.2 MPa")
    simulation.set_crack_pressure("0.2 MPa")
    other.set_pressure(2e5)
    assert simulation.state_hash == other.state_hash


def test_what_is_no_array_of_numbers_is_refused(strip, mechanics):
    simulation = strip.simulation()
    for wrong in ("3 s", [[1.0], [1.0, 2.0]], ["2 MPa"], object()):
        for change in (simulation.set_pressure, simulation.set_crack_pressure):
            with pytest.raises(percolith.CaseError, match="allowed: "):
                change(wrong)
    for wrong in ([1.0, 2.0], None):
        with pytest.raises(percolith.CaseError, match="no number; allowed: "):
            simulation.set_condition("boundary.left.pressure", wrong)
    with pytest.raises(percolith.CaseError, match="displacement: no array of numbers"):
        mechanics.simulation().set_motion(displacement=[[1.0], [1.0, 2.0]])


def test_what_is_not_changed_in_place_keeps_its_bits(strip):
    strip["initial"] = {"water_table": 0.01}
    strip["model.gravity"] = 9.81
    strip["fluid.cavitation_pressure"] = 0
    simulation = strip.simulation()
    simulation.advance(steps=3)
    before = simulation.state_hash
    saturation = simulation.flow.saturation.copy()
    assert saturation.min() < 1
    with simulation.writing():
        pass
    assert simulation.state_hash == before
    with pytest.raises(percolith.CaseError, match="share a pore"), simulation.writing() as fluid:
        fluid.pressure[3, 2, 1] += 1.0
    with pytest.raises(percolith.CaseError, match="cavitation"), simulation.writing() as fluid:
        fluid.pressure[...] = -1.0
    with pytest.raises(KeyError), simulation.writing() as fluid:
        fluid.pressure[...] = 1.0
        raise KeyError
    assert simulation.state_hash == before
    with simulation.writing() as fluid:
        fluid.pressure[fluid.pressure > 5e4] += 10.0
    assert simulation.state_hash != before
    assert np.array_equal(saturation < 1, simulation.flow.saturation < 1)


def test_pressures_that_cannot_be_are_refused(strip, mechanics):
    simulation = strip.simulation()
    before = simulation.flow.pressure.copy()
    triangles = simulation.mesh.triangles
    for wrong, message in [(np.nan, "not a finite number"), (np.zeros(3), "array of shape"),
                           (np.arange(triangles.size).reshape(triangles.shape), "share a pore")]:
        with pytest.raises(percolith.CaseError, match=message):
            simulation.set_pressure(wrong)
    with pytest.raises(percolith.CaseError, match="array of shape"):
        simulation.set_crack_pressure(np.zeros(2))
    assert np.array_equal(before, simulation.flow.pressure)
    with pytest.raises(percolith.CaseError, match="takes no pressures"):
        mechanics.simulation().set_pressure(0.0)


def test_pressures_below_the_cavitation_pressure_are_refused(strip):
    strip["fluid.cavitation_pressure"] = 0
    simulation = strip.simulation()
    with pytest.raises(percolith.CaseError, match="below the cavitation pressure"):
        simulation.set_pressure(-1.0)


def test_warnings_are_warnings_of_python(strip, tmp_path):
    strip["output.interval"] = "1 day"
    strip["time.tolerance"] = 0.1
    with pytest.warns(percolith.CaseWarning):
        coupled = short_case("three_cracks")
        coupled["material.rock.biot_coefficient"] = 0.1
        coupled.simulation(tmp_path / "results").close()


def test_progress_is_told_where_it_is_wanted(strip, tmp_path, capsys):
    strip.run(tmp_path / "quiet")
    assert capsys.readouterr().out == ""
    strip.run(tmp_path / "told", progress=True)
    out = capsys.readouterr().out
    assert "finished at time 0.02 s after 20 steps" in out
    strip.simulation(progress=True).run()
    assert "step" in capsys.readouterr().out
