# SPDX-License-Identifier: BSD-3-Clause
"""Options of a case: read, set, taken out, checked, written."""

import math
from pathlib import Path

import numpy as np
import percolith
import pytest

ROOT = Path(__file__).resolve().parents[2]
STRIP = ROOT / "examples/strip/case.toml"


def test_options_are_read_by_dotted_path_and_by_table(strip):
    assert strip["time.scheme"] == "implicit"
    assert strip["time"]["end"] == "0.02 s"
    assert "time.end" in strip and "time.nothing" not in strip
    assert set(strip["time"]) == {"scheme", "step", "end"}
    assert strip["output.times"] == (0.005, 0.01)


def test_what_is_set_is_what_the_simulator_reads(strip):
    strip["time.end"] = "30 ms"
    strip["probe"]["middle"] = {"point": np.array([0.5, 0.01])}
    strip["output.times"] = np.linspace(0.01, 0.02, 2)
    resolved = strip.resolved()
    assert resolved["time"]["end"] == pytest.approx(0.03)
    assert resolved["probe"]["middle"]["point"] == [0.5, 0.01]
    assert resolved["output"]["times"] == [0.01, 0.02]


def test_what_is_taken_out_is_gone(strip):
    del strip["output.times"]
    assert not strip.resolved()["output"].get("times")
    with pytest.raises(percolith.UnknownNameError):
        del strip["output.times"]


def test_an_option_that_is_not_there_names_those_that_are(strip):
    with pytest.raises(percolith.UnknownNameError, match="^no option time.nd; there are: time.end"):
        strip["time.nd"]
    assert "time.nd" not in strip and strip.get("time.nd", 3) == 3


def test_numbers_keep_their_bits(strip):
    value = math.nextafter(0.02, 1)
    strip["time.end"] = value
    assert strip.resolved()["time"]["end"] == value


def test_a_table_set_later_replaces_what_stood_in_it(strip):
    strip["time.tolerance"] = 1e-3
    strip["time"] = {"scheme": "implicit", "end": 1.0}
    assert "tolerance" not in strip["time"]
    strip["time.end"] = 2.0
    assert strip.resolved()["time"]["end"] == 2.0


def test_a_copy_is_a_case_of_its_own(strip):
    other = strip.copy()
    other["time.end"] = 1.0
    assert strip["time.end"] == "0.02 s"


@pytest.mark.parametrize("value, message", [
    (None, "^error: probe.middle = None: a NoneType is no value"),
    ([1, None], "^error: probe.middle = None: "),
    ({"point": [None]}, "^error: probe.middle.point = None: "),
    ({1: 2}, "^error: probe.middle: 1: names of options are texts"),
])
def test_values_that_no_option_can_have_name_the_option(value, message):
    case = percolith.Case()
    with pytest.raises(percolith.CaseError, match=message):
        case["probe.middle"] = value
    assert "probe" not in case


@pytest.mark.parametrize("value", [None, object(), {1: 2}, 1j])
def test_a_value_that_is_none_is_refused_at_once(strip, value):
    with pytest.raises(percolith.CaseError, match="error: "):
        strip["time.end"] = value


def test_a_case_of_python_values_alone(strip, tmp_path):
    options = {**strip.to_dict(), "mesh": {"file": STRIP.parent / strip["mesh.file"]}}
    case = percolith.Case(options, directory=tmp_path)
    with case.simulation() as one, strip.simulation() as other:
        one.run()
        other.run()
        assert one.state_hash == other.state_hash


def test_mistakes_have_the_messages_of_the_command_line(program, tmp_path):
    file = tmp_path / "case.toml"
    file.write_text(STRIP.read_text().replace("[time]", "[time]\ntolerence = 1"))
    with pytest.raises(percolith.CaseError) as caught:
        percolith.Case.load(file).validate()
    told = program("check", file).stderr.strip()
    assert str(caught.value) == told
    problem = caught.value.problems[0]
    line = 1 + next(n for n, text in enumerate(file.read_text().splitlines()) if "tolerence" in text)
    assert (problem.file, problem.line, problem.key) == (str(file), line, "time.tolerence")
    assert problem.message == told.splitlines()[0]


def test_a_value_that_was_set_is_refused_as_with_set(strip, program):
    strip["time.end"] = "3 MPa"
    with pytest.raises(percolith.CaseError) as caught:
        strip.validate()
    told = program("check", STRIP, "--set", "time.end=3 MPa").stderr
    assert str(caught.value) in told and "--set" not in str(caught.value)
    assert caught.value.problems[0].message == str(caught.value)
    assert caught.value.problems[0].file == ""
    assert caught.value.problems[0].allowed.startswith("a number in s")


def test_a_file_that_is_not_toml(program, tmp_path):
    file = tmp_path / "case.toml"
    file.write_text("format = 1\n[time\n")
    with pytest.raises(percolith.CaseError) as caught:
        percolith.Case.load(file)
    assert str(caught.value) == program("check", file).stderr.strip()


def test_a_file_that_is_not_there(program, tmp_path):
    file = tmp_path / "nothing.toml"
    with pytest.raises(percolith.FileError) as caught:
        percolith.Case.load(file)
    assert "error: " + str(caught.value) == program("check", file).stderr.strip()
    assert isinstance(caught.value, OSError)


def test_a_group_that_the_mesh_lacks_is_located(program, tmp_path):
    mesh = percolith.Case.load(STRIP)["mesh.file"]
    text = STRIP.read_text().replace(f'"{mesh}"', f'"{STRIP.parent / mesh}"')
    file = tmp_path / "case.toml"
    file.write_text(text.replace('"left"', '"nowhere"', 1))
    with pytest.raises(percolith.CaseError) as caught:
        percolith.Case.load(file).check()
    assert str(caught.value) == program("check", file).stderr.strip()
    assert str(file) + ":" in str(caught.value)


def test_a_saved_case_is_the_same_case(strip, tmp_path):
    strip["title"] = 'Quotes " and \\ and tabs\t'
    strip.save(tmp_path / "other.toml")
    again = percolith.Case.load(tmp_path / "other.toml")
    assert again["title"] == strip["title"]
    with strip.simulation() as one, again.simulation() as other:
        one.run()
        other.run()
        assert one.state_hash == other.state_hash


def test_results_tell_where_the_case_comes_from(strip, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    strip["mesh.file"] = strip.file.parent / strip["mesh.file"]
    for made in (percolith.Case(strip.to_dict()), percolith.Case.from_toml(strip.to_toml())):
        run = made.run(force=True)
        assert run.path.name == "case.results"
        assert run.summary["case_file"] == "case built in Python"
        assert ") runs case built in Python on " in (run.path / "run.log").read_text()
        with pytest.raises(percolith.CaseError, match="case built in Python"):
            percolith.Case.from_toml("wrong")
    strip.save("own.toml")
    run = percolith.Case.load("own.toml").run()
    assert run.path.name == "own.results" and run.summary["case_file"] == "own.toml"


def test_check_tells_what_the_model_is(strip):
    report = strip.check()
    assert report.triangles == 172
    assert report.limits[-1].mechanism == "all together"
    assert report.limits[0].step > 0


def test_check_warns_of_the_model(program):
    case = percolith.Case.load(ROOT / "examples/three_cracks/case.toml")
    with pytest.warns(percolith.CaseWarning, match="do not resolve the cohesive length") as told:
        report = case.check()
    assert [f"warning: {text}" for text in report.warnings] == [str(one.message) for one in told]
    assert repr(report).startswith("CheckReport(15202 triangles, 22651 joints, 12 of them broken; ")


def test_warnings_of_options_are_among_those_of_check_and_of_results(strip, tmp_path):
    strip["source.well"] = {"point": [0.5, 0.1], "rate": -10.0}
    with pytest.warns(percolith.CaseWarning) as told:
        report = strip.check()
    assert len(told) == len(report.warnings)
    assert report.warnings[0].startswith("warning: source.well.rate = -10 is -10 m2/s")
    strip["time"] = {"scheme": "explicit", "end": "1 ms"}
    strip["source.well.rate"] = 10.0
    del strip["output.times"]
    with pytest.warns(percolith.CaseWarning):
        with strip.simulation(tmp_path / "run") as simulation:
            simulation.advance(steps=2)
    assert percolith.resume(tmp_path / "run").summary["warnings"] == [
        text.replace("-10", "10") for text in report.warnings]


def test_check_tells_of_mechanics_by_name(mechanics, strip):
    report = mechanics.check()
    assert isinstance(report.mechanics, dict)
    assert report.mechanics["bodies (parts that hang together)"] == 1
    assert 3.0 < report.mechanics["smallest cohesive length over element size"] < 3.1
    limit = report.limits[0]
    assert repr(limit) == (f"StepLimit('contact', {limit.step:g} s at ({limit.place[0]:g}, "
                           f"{limit.place[1]:g}) m)")
    assert strip.check().mechanics == {}


def test_options_are_described_from_their_declarations():
    option = percolith.describe("material.granite.young_modulus")
    assert option.path == "material.*.young_modulus" and option.unit == "Pa"
    assert "Young" in option.help and "Young" in str(option)
    with pytest.raises(percolith.CaseError, match="did you mean material"):
        percolith.describe("material.granite.young_moduls")
    for name in percolith.option_names():
        assert percolith.describe(name).help


def test_quantities_with_units():
    assert percolith.quantity("20 GPa", "Pa") == 20e9
    assert percolith.quantity("3", "s") == 3.0
    with pytest.raises(percolith.CaseError, match='"20 GPa": .*allowed: '):
        percolith.quantity("20 GPa", "s")
    with pytest.raises(percolith.CaseError, match="does not begin with a number"):
        percolith.quantity("much", "s")


def test_the_version_is_that_of_the_program(program):
    assert program("--version").stdout.startswith(f"percolith {percolith.__version__} ")
