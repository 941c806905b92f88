// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/documents.hpp"

#include <fstream>
#include <iterator>

#include "unit/case/mechanics_case.hpp"

namespace percolith::case_file {
namespace {

constexpr double degree = 0.017453292519943295;

/// The case with every option of mechanics.
const simulation::Setup& whole() {
  static const simulation::Setup setup = [] {
    std::ifstream stream("tests/fuzz/corpus_case/all_options_mechanics.toml", std::ios::binary);
    return read({std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()}).setup;
  }();
  return setup;
}

TEST(ReadMechanics, FillsModelAndElasticity) {
  EXPECT_EQ(whole().model.physics, simulation::Physics::mechanics);
  EXPECT_EQ(whole().model.plane, simulation::Plane::stress);
  const material::ElasticRock& rock = whole().material.at("rock").solid;
  EXPECT_DOUBLE_EQ(rock.density, 2700.0);
  EXPECT_EQ(rock.young_modulus, 5e10);
  EXPECT_EQ(rock.poisson_ratio, 0.25);
  EXPECT_FALSE(rock.normal_young_modulus.has_value());
  const material::ElasticRock& shale = whole().material.at("shale").solid;
  EXPECT_EQ(shale.normal_young_modulus, 1.5e10);
  EXPECT_EQ(shale.normal_poisson_ratio, 0.15);
  EXPECT_EQ(shale.normal_shear_modulus, 6e9);
  EXPECT_DOUBLE_EQ(shale.bedding_angle, -40.0 * degree);
}

TEST(ReadMechanics, FillsStrength) {
  const simulation::Material& rock = whole().material.at("rock");
  EXPECT_EQ(rock.joints, simulation::RockJoints::breakable);
  EXPECT_EQ(rock.strength.tensile_strength, 1e7);
  EXPECT_EQ(rock.strength.cohesion, 2e7);
  EXPECT_DOUBLE_EQ(*rock.strength.friction_angle, 35.0 * degree);
  EXPECT_DOUBLE_EQ(*rock.strength.residual_friction_angle, 30.0 * degree);
  EXPECT_EQ(rock.strength.mode_1_energy, 10.0);
  EXPECT_DOUBLE_EQ(rock.strength.mode_2_energy, 100.0);
  EXPECT_EQ(rock.strength.joint_penalty, 1e12);
  EXPECT_EQ(rock.weibull_modulus, 8.0);
  EXPECT_EQ(rock.weibull_seed, 7);
  const simulation::Material& steel = whole().material.at("steel");
  EXPECT_EQ(steel.joints, simulation::RockJoints::elastic);
  EXPECT_EQ(steel.strength.friction_angle, 0.1);
  const simulation::FractureGroup& fault = whole().fracture.at("fault");
  EXPECT_EQ(fault.bond, simulation::Bond::broken);
  EXPECT_DOUBLE_EQ(*fault.strength.residual_friction_angle, 25.0 * degree);
  const simulation::FractureGroup& vein = whole().fracture.at("vein");
  EXPECT_EQ(vein.bond, simulation::Bond::cohesive);
  EXPECT_EQ(vein.strength.tensile_strength, 2e6);
  EXPECT_EQ(vein.strength.cohesion, 4e6);
  EXPECT_DOUBLE_EQ(*vein.strength.friction_angle, 30.0 * degree);
  EXPECT_DOUBLE_EQ(*vein.strength.residual_friction_angle, 28.0 * degree);
  EXPECT_EQ(vein.strength.mode_1_energy, 2.0);
  EXPECT_EQ(vein.strength.mode_2_energy, 20.0);
  EXPECT_EQ(vein.strength.joint_penalty, 5e11);
}

TEST(ReadMechanics, FillsBoundaries) {
  const auto& boundary = whole().boundary;
  EXPECT_TRUE(boundary.at("base").fixed);
  EXPECT_TRUE(boundary.at("left").roller);
  EXPECT_FALSE(boundary.at("left").fixed);
  EXPECT_EQ(boundary.at("left").traction_y, Schedule::constant(0.0));
  const Schedule ramp{{0.0, 1.0}, {0.0, 1e-3}, Interpolation::linear};
  EXPECT_EQ(boundary.at("right").displacement_x, ramp);
  EXPECT_EQ(boundary.at("right").velocity_y, Schedule::constant(1e-3));
  EXPECT_EQ(boundary.at("top").velocity_x, Schedule::constant(0.0));
  EXPECT_EQ(boundary.at("top").displacement_y, Schedule::constant(-1e-3));
  EXPECT_TRUE(boundary.at("far").in_situ);
  EXPECT_TRUE(boundary.at("far").absorbing);
  EXPECT_EQ(boundary.at("far").traction_x, Schedule::constant(1e6));
  const Schedule pressure{{0.0, 1.0}, {0.0, 2e6}, Interpolation::linear};
  EXPECT_EQ(boundary.at("wall").normal_pressure, pressure);
}

TEST(ReadMechanics, FillsBodiesForcesAndExcavations) {
  const simulation::Body& upper = whole().body.at("upper");
  EXPECT_EQ(upper.regions, std::vector<std::string>{"upper"});
  EXPECT_TRUE(upper.rigid);
  EXPECT_EQ(upper.velocity_x, Schedule::constant(0.0));
  EXPECT_EQ(upper.velocity_y, Schedule::constant(-0.05));
  const simulation::Body& cover = whole().body.at("cover");
  EXPECT_FALSE(cover.rigid);
  EXPECT_EQ(cover.initial_velocity_x, 1.0);
  EXPECT_EQ(cover.initial_velocity_y, -2.0);
  const simulation::PointForce& anchor = whole().point_force.at("anchor");
  EXPECT_EQ(anchor.point, (std::array<double, 2>{1.0, 0.5}));
  EXPECT_EQ(anchor.force_x, Schedule::constant(1e4));
  EXPECT_EQ(anchor.force_y->value, (std::vector<double>{0.0, 1.0}));
  const simulation::Excavation& tunnel = whole().excavation.at("tunnel");
  EXPECT_EQ(tunnel.regions, std::vector<std::string>{"shale"});
  EXPECT_EQ(tunnel.start, 1e-3);
  EXPECT_EQ(tunnel.duration, 2e-3);
}

TEST(ReadMechanics, FillsStressDampingContactAndTime) {
  const simulation::InSitu stress{-5e6, -1e7, 1e6, 1.3e4, 2.6e4, 10.0, 100.0};
  EXPECT_EQ(whole().in_situ, stress);
  EXPECT_EQ(whole().damping, (simulation::Damping{100.0, 0.0, 0.5, 0.7}));
  EXPECT_EQ(whole().contact.penalty, 2e12);
  EXPECT_EQ(whole().contact.tangential_penalty, 3e12);
  EXPECT_EQ(whole().time.scheme, simulation::Scheme::explicit_);
  EXPECT_EQ(whole().time.step, 1e-6);
  EXPECT_EQ(whole().time.safety, 0.8);
  EXPECT_EQ(whole().time.stop_ratio, 1e-4);
  EXPECT_EQ(whole().time.mass_scaling_step, 1e-7);
  EXPECT_EQ(read(mechanics_case, {"damping.element_viscosity=3"}).setup.damping.element_viscosity,
            3.0);
}

TEST(ReadMechanics, ReadAgainFromItsResolvedFormItIsTheSame) {
  EXPECT_EQ(read(resolved_toml(whole())).setup, whole());
}

TEST(ReadMechanics, KeepsDefaultsOfWhatIsNotGiven) {
  const simulation::Setup setup = read(mechanics_case).setup;
  EXPECT_EQ(setup.model.plane, simulation::Plane::strain);
  EXPECT_FALSE(setup.in_situ.has_value());
  EXPECT_FALSE(setup.contact.penalty.has_value());
  EXPECT_EQ(setup.damping, simulation::Damping{});
  EXPECT_FALSE(setup.material.at("rock").strength.residual_friction_angle.has_value());
  EXPECT_FALSE(setup.time.stop_ratio.has_value());
}

TEST(ReadMechanics, AnEmptyTableOfInSituStressIsAStressOfZero) {
  EXPECT_EQ(read(mechanics_case + "[in_situ]\n").setup.in_situ, simulation::InSitu{});
}

TEST(ReadMechanics, ItsSchemeIsExplicitAndNeedNotBeNamed) {
  EXPECT_EQ(read(mechanics_case).setup.time.scheme, simulation::Scheme::explicit_);
  EXPECT_EQ(read(mechanics_case, {"time.scheme=explicit"}).setup.time.scheme,
            simulation::Scheme::explicit_);
  EXPECT_EQ(read(minimal_case).setup.time.scheme, simulation::Scheme::implicit);
}

}  // namespace
}  // namespace percolith::case_file
