// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include "unit/case/minimal_case.hpp"

namespace percolith::case_file {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const std::string whole_case = R"(format = 1
title = "All options"

[mesh]
file = "section.geo"
element_size = "50 cm"

[model]
gravity = 9.81
head_datum = 1000
pore_joints = "finite"
joint_factor = 200
saturation_weight = "mean"

[fluid]
density = "1.1 g/cm3"
viscosity = "2 cP"
bulk_modulus = "2 GPa"
cavitation_pressure = "-inf"

[material.rock]
regions = ["rock", "cover"]
permeability = ["10 mdarcy", 1e-14, 0]
porosity = "10 %"
biot_modulus = "20 GPa"

[fracture.fault]
groups = ["fault_1"]
initial_aperture = "0.1 mm"
minimum_aperture = "0.01 mm"
maximum_aperture = "1 mm"
exchange = "inf"

[fracture.vein]
groups = ["vein_1"]
initial_aperture = "0.1 mm"
transmissivity = 1e-12
exchange = "inf"

[boundary.left]
groups = ["left"]
head = 20
on = "matrix"

[boundary.right]
groups = ["right"]
pressure = { times = [0, 1, 2], values = [0, 1, 3], time_unit = "hour", value_unit = "MPa", interpolation = "step" }

[boundary.top]
groups = ["top"]
flux = "1 mm/day"

[source.well]
point = [1, "50 cm"]
into = "crack"
pressure = 1e6

[source.injection]
fractures = ["fault"]
rate = 1e-2

[initial]
water_table = 3.5
saturation = 1
crack_pressure = "1 bar"

[time]
scheme = "implicit"
end = "3 hour"
initial_step = "1 min"
maximum_step = 600
tolerance = 1e-4

[output]
times = ["1 hour", 7200]
interval = 1800
fields = false
history_interval = 60

[probe.middle]
point = [0.5, 0.1]

[probe.axis]
from = [0, 0.1]
to = [1, 0.1]
points = 11
in = "crack"
)";

TEST(ReadCase, FillsEveryMember) {
  const simulation::Setup setup = read(whole_case).setup;
  EXPECT_EQ(setup.title, "All options");
  EXPECT_EQ(setup.mesh.file, "section.geo");
  EXPECT_EQ(setup.mesh.element_size, 0.5);
  EXPECT_EQ(setup.model.gravity, 9.81);
  EXPECT_EQ(setup.model.head_datum, 1000.0);
  EXPECT_EQ(setup.model.pore_joints, simulation::PoreJoints::finite);
  EXPECT_EQ(setup.model.joint_factor, 200.0);
  EXPECT_EQ(setup.model.saturation_weight, simulation::SaturationWeight::mean);
  EXPECT_DOUBLE_EQ(setup.fluid.density, 1100.0);
  EXPECT_DOUBLE_EQ(setup.fluid.viscosity, 2e-3);
  EXPECT_EQ(setup.fluid.bulk_modulus, 2e9);
  EXPECT_EQ(setup.fluid.cavitation_pressure, -infinity);
  const simulation::Material& rock = setup.material.at("rock");
  EXPECT_EQ(rock.regions, (std::vector<std::string>{"rock", "cover"}));
  EXPECT_DOUBLE_EQ(rock.rock.permeability.xx, 9.869233e-15);
  EXPECT_EQ(rock.rock.permeability.yy, 1e-14);
  EXPECT_EQ(rock.rock.permeability.xy, 0.0);
  EXPECT_DOUBLE_EQ(rock.rock.porosity, 0.1);
  EXPECT_EQ(rock.rock.biot_modulus, 2e10);
  const material::Fracture& fault = setup.fracture.at("fault").fracture;
  EXPECT_EQ(setup.fracture.at("fault").groups, std::vector<std::string>{"fault_1"});
  EXPECT_DOUBLE_EQ(fault.initial_aperture, 1e-4);
  EXPECT_DOUBLE_EQ(fault.minimum_aperture, 1e-5);
  EXPECT_DOUBLE_EQ(fault.maximum_aperture, 1e-3);
  EXPECT_EQ(fault.transmissivity, std::nullopt);
  EXPECT_EQ(setup.fracture.at("vein").fracture.transmissivity, 1e-12);
  EXPECT_EQ(fault.exchange, infinity);
}

TEST(ReadCase, FillsConditions) {
  const simulation::Setup setup = read(whole_case).setup;
  EXPECT_EQ(setup.boundary.at("left").head, Schedule::constant(20.0));
  EXPECT_EQ(setup.boundary.at("left").on, simulation::Domain::matrix);
  const Schedule steps{{0.0, 3600.0, 7200.0}, {0.0, 1e6, 3e6}, Interpolation::step};
  EXPECT_EQ(setup.boundary.at("right").pressure, steps);
  EXPECT_DOUBLE_EQ(setup.boundary.at("top").flux->value.front(), 1e-3 / 86400.0);
  const simulation::Source& well = setup.source.at("well");
  EXPECT_EQ(well.point, (std::array<double, 2>{1.0, 0.5}));
  EXPECT_EQ(well.into, simulation::Domain::crack);
  EXPECT_EQ(well.pressure, Schedule::constant(1e6));
  EXPECT_EQ(setup.source.at("injection").fractures, std::vector<std::string>{"fault"});
  EXPECT_EQ(setup.source.at("injection").rate, Schedule::constant(1e-2));
  EXPECT_EQ(setup.initial.water_table, 3.5);
  EXPECT_EQ(setup.initial.saturation, 1.0);
  EXPECT_EQ(setup.initial.crack_pressure, 1e5);
  EXPECT_FALSE(setup.initial.crack_saturation.has_value());
}

TEST(ReadCase, FillsRunAndOutput) {
  const simulation::Setup setup = read(whole_case).setup;
  EXPECT_EQ(setup.time.scheme, simulation::Scheme::implicit);
  EXPECT_EQ(setup.time.end, 10800.0);
  EXPECT_EQ(setup.time.initial_step, 60.0);
  EXPECT_EQ(setup.time.maximum_step, 600.0);
  EXPECT_EQ(setup.time.tolerance, 1e-4);
  EXPECT_EQ(setup.output.times, (std::vector<double>{3600.0, 7200.0}));
  EXPECT_EQ(setup.output.interval, 1800.0);
  EXPECT_FALSE(setup.output.fields);
  EXPECT_EQ(setup.output.history_interval, 60.0);
  EXPECT_EQ(setup.probe.at("middle").point, (std::array<double, 2>{0.5, 0.1}));
  EXPECT_EQ(setup.probe.at("axis").from, (std::array<double, 2>{0.0, 0.1}));
  EXPECT_EQ(setup.probe.at("axis").to, (std::array<double, 2>{1.0, 0.1}));
  EXPECT_EQ(setup.probe.at("axis").points, 11);
  EXPECT_EQ(setup.probe.at("axis").in, simulation::Domain::crack);
}

TEST(ReadCase, KeepsDefaultsOfWhatIsNotGiven) {
  const simulation::Setup setup = read(minimal_case).setup;
  const simulation::Setup defaults;
  EXPECT_EQ(setup.fluid, defaults.fluid);
  EXPECT_EQ(setup.time.tolerance, defaults.time.tolerance);
  EXPECT_EQ(setup.model.pore_joints, defaults.model.pore_joints);
  EXPECT_FALSE(setup.material.at("rock").rock.biot_modulus.has_value());
  EXPECT_TRUE(setup.fracture.empty());
}

TEST(ReadCase, TakesATensorAsAMatrix) {
  const Case result = read(minimal_case, {"material.rock.permeability=[[3e-14, 1e-14], [1e-14, "
                                          "2e-14]]"});
  EXPECT_EQ(result.setup.material.at("rock").rock.permeability, (Tensor{3e-14, 2e-14, 1e-14}));
}

}  // namespace
}  // namespace percolith::case_file
