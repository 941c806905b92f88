# SPDX-License-Identifier: BSD-3-Clause
"""Any array of the field files can be drawn."""

import numpy as np
import pytest
from percolith import RunDirectory, RunDirectoryError, plot
from percolith.mechanics_fields import label_of, other_fields, range_of_values, values_of
from percolith.pictures import check_field, fields_of
from percolith.run_directory import Frame
from percolith.units import format_value, power_scale, pressure_scale, scale_of, without_unit
from percolith.vtu import Grid
from synthetic_coupled_run import write_coupled_run
from synthetic_run import write_mechanics_run


@pytest.fixture(scope="module")
def tunnel(run_example):
    """A real run of mechanics, with every array that such a run leaves."""
    return run_example("brazilian", time__end="20 us", output__interval="20 us").results


def test_all_arrays_are_fields(tunnel):
    arrays = tunnel.frame().matrix.point_data.keys() | tunnel.frame().matrix.cell_data.keys()
    assert {"stress_xx", "stress_zz", "strain_xy", "region"} <= set(fields_of(tunnel))
    for array in arrays - {"principal_direction", "fragment"}:
        assert check_field(tunnel, array) == without_unit(array)
    assert tunnel.fields == fields_of(tunnel)


def test_what_the_colours_show_is_what_the_file_has(tunnel):
    axes = tunnel.plot("stress_yy_Pa", cracks="none")
    rock = axes.collections[-1]  # after the rigid bodies
    frame = tunnel.frame()
    stress = frame.matrix.cell_data["stress_yy_Pa"]
    scale = scale_of("stress_yy_Pa", np.percentile(stress, [1, 99]))
    assert np.allclose(rock.get_array(), stress / scale.factor)
    assert axes.figure.axes[1].get_ylabel() == scale.label("Stress yy")


def test_strain_has_a_power_of_ten_for_a_unit(tunnel):
    axes = tunnel.plot("strain_xx")
    assert "Strain xx ($10^{" in axes.figure.axes[1].get_ylabel()


def test_regions_have_their_names(tmp_path):
    run = RunDirectory(write_coupled_run(tmp_path / "run", frames=2))
    axes = run.plot("region", cracks="none")
    assert [text.get_text() for text in axes.figure.legends[0].get_texts()] == ["plate"]


def test_stress_is_effective_where_there_is_fluid(tmp_path):
    coupled = RunDirectory(write_coupled_run(tmp_path / "run", frames=2)).frame()
    assert label_of(coupled, "principal_stress_1").startswith("Effective principal stress 1")
    dry = RunDirectory(write_mechanics_run(tmp_path / "dry")).frame()
    assert label_of(dry, "principal_stress_1").startswith("Principal stress 1")
    assert label_of(coupled, "displacement") == "Displacement"


def test_arrays_of_a_later_version_are_drawn_too():
    points = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])
    matrix = Grid(points, np.array([[0, 1, 2]]), {"heat_flux_m_per_s": np.array([[3.0, 4.0]] * 3)},
                  {"mean_stress_Pa": np.array([2e6])})
    frame = Frame(0.0, matrix, None)
    assert other_fields(matrix) == {"heat_flux": "heat_flux_m_per_s",
                                    "mean_stress": "mean_stress_Pa"}
    assert values_of(frame, "heat_flux") == pytest.approx(5.0)
    assert label_of(frame, "mean_stress") == "Mean stress"
    assert range_of_values("mean_stress", values_of(frame, "mean_stress"),
                           "mean_stress_Pa").scale.unit == "MPa"


def test_a_field_that_there_is_not(tunnel, capsys):
    assert plot.main([str(tunnel.path), "--field", "stres_xx"]) == 2
    message = capsys.readouterr().err
    assert "no stres_xx in this run; there are: displacement, " in message
    assert message.endswith("; did you mean stress_xx?\n")
    with pytest.raises(RunDirectoryError, match=r"no stres_xx_Pa in .*; did you mean stress_xx\?$"):
        tunnel.plot("stres_xx_Pa")
    with pytest.raises(RunDirectoryError, match="no pressure in this run"):
        tunnel.plot("pressure")


def test_units_come_from_names():
    assert without_unit("flux_m2_per_s") == "flux" and without_unit("strain_xx") == "strain_xx"
    assert without_unit("darcy_flux_m_per_s") == "darcy_flux"
    assert scale_of("break_time_s", [3e-3]).unit == "ms"
    assert scale_of("aperture_m", [3e-5, np.nan]).unit == "µm"
    assert scale_of("damage", [0.5]).label("Damage") == "Damage"
    assert format_value(3.2e-6, power_scale([3.2e-6], "m/s")) == "3.2 × $10^{\N{MINUS SIGN}6}$ m/s"
    assert format_value(2.5e6, pressure_scale([2.5e6])) == "2.5 MPa"


def test_head_is_a_field_of_runs_with_gravity_alone(run_example, coupled):
    assert "head" in run_example("double_fracture").results.fields
    assert "head" not in coupled.fields and "pressure" in coupled.fields
    with pytest.raises(RunDirectoryError, match="no head in this run; .*; head needs model.gravity"):
        coupled.plot("head")
