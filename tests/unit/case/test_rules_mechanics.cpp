// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/applies_physics.hpp"

#include <gmock/gmock.h>

#include "unit/case/mechanics_case.hpp"

namespace percolith::case_file {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

using Settings = std::vector<std::string>;

const std::string fault = "fracture.fault={groups=[\"f\"]}";
const std::string vein = "fracture.vein={groups=[\"v\"], bond=\"cohesive\", tensile_strength=1e6, "
                         "cohesion=2e6, friction_angle=0.5, mode_1_energy=1, mode_2_energy=10}";

/// What is wrong with `value` for `option`; the rest of the message is the same each time.
std::string out_of_range(const std::string& option, const std::string& value,
                         const std::string& allowed) {
  return "--set: error: " + option + " = " + value + ": out of range; allowed: " + allowed;
}

std::string no_effect(const std::string& setting, const std::string& needed) {
  return "--set: error: " + setting + ": has no effect here: it needs " + needed;
}

TEST(RulesOfMechanics, TheSmallCaseIsSound) {
  EXPECT_EQ(mechanics_error({}), "");
  EXPECT_EQ(mechanics_error({fault, vein}), "");
}

TEST(RulesOfMechanics, Physics) {
  EXPECT_EQ(mechanics_error({"model.physics=mechanic"}),
            "--set: error: model.physics = \"mechanic\": no such choice; allowed: \"seepage\", "
            "\"mechanics\", \"coupled\"");
  EXPECT_EQ(mechanics_error({"model.plane=stresses"}),
            "--set: error: model.plane = \"stresses\": no such choice; allowed: \"strain\", "
            "\"stress\"");
}

TEST(RulesOfMechanics, OptionsOfSeepageHaveNoEffect) {
  const std::string needed(needs_flow);
  for (const std::string setting :
       {"model.head_datum = 1", "model.joint_factor = 3", "material.rock.permeability = 1e-15",
        "material.rock.porosity = 0.1", "material.rock.biot_modulus = 10",
        "fracture.fault.initial_aperture = 0.001", "fracture.fault.minimum_aperture = 0.001",
        "fracture.fault.maximum_aperture = 0.001", "fracture.fault.transmissivity = 1e-12",
        "fracture.fault.exchange = 1e-06", "boundary.base.pressure = 1", "boundary.base.head = 1",
        "boundary.base.flux = 1", "boundary.base.seepage_face = 1"}) {
    EXPECT_EQ(mechanics_error({fault, setting}), no_effect(setting, needed));
  }
  for (const std::string setting :
       {"time.initial_step = 1", "time.maximum_step = 1", "time.tolerance = 0.1"}) {
    EXPECT_EQ(mechanics_error({setting}), no_effect(setting, needed));
  }
  EXPECT_EQ(mechanics_error({"model.pore_joints=finite"}),
            no_effect("model.pore_joints = \"finite\"", needed));
  EXPECT_EQ(mechanics_error({"model.saturation_weight=mean"}),
            no_effect("model.saturation_weight = \"mean\"", needed));
  EXPECT_EQ(mechanics_error({"boundary.base.on=matrix"}),
            no_effect("boundary.base.on = \"matrix\"", needed));
}

TEST(RulesOfMechanics, TablesOfSeepageHaveNoEffect) {
  const std::string needed(needs_flow);
  EXPECT_EQ(mechanics_error({"fluid.density=900"}), no_effect("fluid", needed));
  EXPECT_EQ(mechanics_error({"initial.pressure=0"}), no_effect("initial", needed));
  EXPECT_EQ(mechanics_error({"source.well={point=[0, 0], rate=1}"}),
            no_effect("source.well", needed));
}

/// As error_set, for a case that says that it is one of seepage.
std::string seepage_error(Settings overrides) {
  overrides.insert(overrides.begin(), "model.physics=seepage");
  return error_set(overrides);
}

TEST(RulesOfMechanics, ItsOptionsHaveNoEffectInSeepage) {
  const std::string needed(needs_motion);
  const std::string exchange = "fracture.fault={groups=[\"f\"], initial_aperture=1e-4, exchange=1}";
  for (const std::string option : {"material.rock.density",
                                   "material.rock.young_modulus",
                                   "material.rock.poisson_ratio",
                                   "material.rock.normal_young_modulus",
                                   "material.rock.normal_poisson_ratio",
                                   "material.rock.normal_shear_modulus",
                                   "material.rock.bedding_angle",
                                   "material.rock.tensile_strength",
                                   "material.rock.cohesion",
                                   "material.rock.friction_angle",
                                   "material.rock.residual_friction_angle",
                                   "material.rock.mode_1_energy",
                                   "material.rock.mode_2_energy",
                                   "material.rock.joint_penalty",
                                   "material.rock.weibull_modulus",
                                   "fracture.fault.tensile_strength",
                                   "fracture.fault.cohesion",
                                   "fracture.fault.friction_angle",
                                   "fracture.fault.residual_friction_angle",
                                   "fracture.fault.mode_1_energy",
                                   "fracture.fault.mode_2_energy",
                                   "fracture.fault.joint_penalty",
                                   "boundary.left.displacement_x",
                                   "boundary.left.displacement_y",
                                   "boundary.left.velocity_x",
                                   "boundary.left.velocity_y",
                                   "boundary.left.traction_x",
                                   "boundary.left.traction_y",
                                   "boundary.left.normal_pressure",
                                   "time.mass_scaling_step"}) {
    EXPECT_EQ(seepage_error({exchange, option + " = 0.1"}), no_effect(option + " = 0.1", needed));
  }
  for (const std::string option : {"boundary.left.fixed", "boundary.left.roller",
                                   "boundary.left.in_situ", "boundary.left.absorbing"}) {
    EXPECT_EQ(seepage_error({option + " = true"}), no_effect(option + " = true", needed));
  }
  EXPECT_EQ(seepage_error({"model.plane=stress"}), no_effect("model.plane = \"stress\"", needed));
  EXPECT_EQ(seepage_error({"material.rock.joints=elastic"}),
            no_effect("material.rock.joints = \"elastic\"", needed));
  EXPECT_EQ(seepage_error({"material.rock.weibull_seed=2"}),
            no_effect("material.rock.weibull_seed = 2", needed));
  EXPECT_EQ(seepage_error({exchange, "fracture.fault.bond=broken"}),
            no_effect("fracture.fault.bond = \"broken\"", needed));
}

TEST(RulesOfMechanics, ItsTablesHaveNoEffectInSeepage) {
  const std::string needed(needs_motion);
  EXPECT_EQ(seepage_error({"body.a={regions=[\"rock\"], rigid=true}"}),
            no_effect("body.a", needed));
  EXPECT_EQ(seepage_error({"point_force.a={point=[0, 0], force_x=1}"}),
            no_effect("point_force.a", needed));
  EXPECT_EQ(seepage_error({"in_situ.datum=1"}), no_effect("in_situ", needed));
  EXPECT_EQ(seepage_error({"excavation.a={regions=[\"rock\"]}"}),
            no_effect("excavation.a", needed));
  EXPECT_EQ(seepage_error({"damping.local=0.5"}), no_effect("damping", needed));
  EXPECT_EQ(seepage_error({"contact.penalty=1e9"}), no_effect("contact", needed));
}

TEST(RulesOfMechanics, TheRockIsRequired) {
  EXPECT_EQ(mechanics_error({"material.rock.density="}),
            "case.toml:10:11: error: material.rock.density: required but missing: Mass per volume "
            "of the rock with its pores.");
  EXPECT_EQ(mechanics_error({"material.rock.young_modulus="}),
            "case.toml:10:11: error: material.rock.young_modulus: required but missing: Young's "
            "modulus; of layered rock that along the layers.");
  EXPECT_EQ(mechanics_error({"material.rock.poisson_ratio="}),
            "case.toml:10:11: error: material.rock.poisson_ratio: required but missing: Poisson's "
            "ratio, below 0.5; of layered rock that within the layers, below 1.");
}

TEST(RulesOfMechanics, StrengthIsRequiredWhereJointsMayBreak) {
  const Settings options{"tensile_strength", "cohesion", "friction_angle", "mode_1_energy",
                         "mode_2_energy"};
  for (const std::string& option : options) {
    EXPECT_THAT(
        mechanics_error({"material.rock." + option + "="}),
        StartsWith("case.toml:10:11: error: material.rock." + option + ": required but missing: "));
    EXPECT_THAT(mechanics_error({vein, "fracture.vein." + option + "="}),
                StartsWith("--set: error: fracture.vein." + option + ": required but missing: "));
  }
}

TEST(RulesOfMechanics, AnElasticRockHasNoStrength) {
  Settings settings{"material.rock.joints=elastic"};
  for (const std::string option :
       {"tensile_strength", "cohesion", "mode_1_energy", "mode_2_energy"}) {
    settings.push_back("material.rock." + option + "=");
  }
  EXPECT_EQ(mechanics_error(settings), "");
  for (const std::string option :
       {"tensile_strength", "cohesion", "residual_friction_angle", "mode_1_energy", "mode_2_energy",
        "joint_penalty", "weibull_modulus"}) {
    Settings more = settings;
    more.push_back("material.rock." + option + " = 0.1");
    EXPECT_EQ(mechanics_error(more),
              no_effect("material.rock." + option + " = 0.1", "joints = \"breakable\""));
  }
}

TEST(RulesOfMechanics, AnElasticBodyNeedsItsFriction) {
  const Settings steel{"material.steel={regions=[\"platen\"], density=7850, young_modulus=2e11, "
                       "poisson_ratio=0.3, joints=\"elastic\"}"};
  EXPECT_EQ(mechanics_error(steel), "");
  Settings body = steel;
  body.push_back("body.platen={regions=[\"platen\"], rigid=true, velocity_y=-1}");
  EXPECT_EQ(mechanics_error(body),
            "--set: error: material.steel.friction_angle: required but missing: Friction angle of "
            "the joints, such as \"30 deg\".");
  body.push_back("material.steel.friction_angle=0");
  EXPECT_EQ(mechanics_error(body), "");
}

TEST(RulesOfMechanics, ABrokenFractureHasOnlyFriction) {
  EXPECT_EQ(mechanics_error({fault, "fracture.fault.residual_friction_angle=0"}), "");
  EXPECT_EQ(mechanics_error({fault, "fracture.fault.friction_angle=0.1"}), "");
  for (const std::string option :
       {"tensile_strength", "cohesion", "mode_1_energy", "mode_2_energy", "joint_penalty"}) {
    EXPECT_EQ(mechanics_error({fault, "fracture.fault." + option + " = 0.1"}),
              no_effect("fracture.fault." + option + " = 0.1", "bond = \"cohesive\""));
  }
}

TEST(RulesOfMechanics, StrengthAndEnergyAreZeroTogether) {
  EXPECT_EQ(mechanics_error({"material.rock.cohesion=0", "material.rock.mode_2_energy=0"}), "");
  EXPECT_EQ(
      mechanics_error({vein, "fracture.vein.tensile_strength=0", "fracture.vein.mode_1_energy=0"}),
      "");
  EXPECT_EQ(mechanics_error({"material.rock.mode_2_energy=0"}),
            "--set: error: material.rock.mode_2_energy = 0: out of range where cohesion is above "
            "zero; allowed: above 0 J/m2");
  EXPECT_THAT(mechanics_error({"material.rock.tensile_strength=0"}),
              HasSubstr("material.rock.mode_1_energy = 10: has no effect where tensile_strength "
                        "is zero; allowed: 0 J/m2"));
}

TEST(RulesOfMechanics, BoundsOfTheRock) {
  const std::string rock = "material.rock.";
  const std::string angle = "0 <= value < 1.5707963267948966 rad";
  for (const std::string option : {"tensile_strength", "cohesion"}) {
    EXPECT_EQ(mechanics_error({rock + option + "=-1"}),
              out_of_range(rock + option, "-1", "a finite number >= 0 Pa"));
  }
  for (const std::string option : {"mode_1_energy", "mode_2_energy"}) {
    EXPECT_EQ(mechanics_error({rock + option + "=inf"}),
              out_of_range(rock + option, "inf", "a finite number >= 0 J/m2"));
  }
  for (const std::string value : {"0", "-1", "inf"}) {
    const auto expect = [&](const std::string& option, const std::string& allowed) {
      EXPECT_EQ(mechanics_error({rock + option + "=" + value}),
                out_of_range(rock + option, value, allowed));
    };
    expect("density", "a finite number > 0 kg/m3");
    expect("young_modulus", "a finite number > 0 Pa");
    expect("normal_young_modulus", "a finite number > 0 Pa");
    expect("joint_penalty", "a finite number > 0 Pa");
    expect("weibull_modulus", "a finite number > 0");
  }
  for (const std::string option : {"friction_angle", "residual_friction_angle"}) {
    EXPECT_EQ(mechanics_error({rock + option + "=30"}),
              "--set: error: " + rock + option +
                  " = 30: out of range: a number without a unit is in radians; degrees are written "
                  "\"30 deg\"; allowed: " +
                  angle);
    EXPECT_EQ(mechanics_error({rock + option + "=120"}), out_of_range(rock + option, "120", angle));
    EXPECT_EQ(mechanics_error({rock + option + "=90 deg"}),
              out_of_range(rock + option, "\"90 deg\"", angle));
    EXPECT_EQ(mechanics_error({rock + option + "=-0.1"}),
              out_of_range(rock + option, "-0.1", angle));
    EXPECT_EQ(mechanics_error({rock + option + "=0"}), "");
    EXPECT_EQ(mechanics_error({rock + option + "=89 deg"}), "");
  }
  EXPECT_EQ(mechanics_error({rock + "weibull_modulus=5", rock + "weibull_seed=-1"}),
            out_of_range(rock + "weibull_seed", "-1", "a whole number from 0 to 2147483647"));
  EXPECT_EQ(mechanics_error({rock + "weibull_seed=2"}),
            no_effect(rock + "weibull_seed = 2", "weibull_modulus"));
  EXPECT_EQ(mechanics_error({rock + "weibull_modulus=5", rock + "weibull_seed=2"}), "");
}

TEST(RulesOfMechanics, UnitsOfTheRock) {
  EXPECT_EQ(mechanics_error({"material.rock.friction_angle=30 m"}),
            "--set: error: material.rock.friction_angle = \"30 m\": the unit \"m\" is not one of "
            "angle; allowed: a number in rad, or a text with a unit of angle such as \"30 deg\"");
  EXPECT_EQ(mechanics_error({"material.rock.mode_1_energy=30 J"}),
            "--set: error: material.rock.mode_1_energy = \"30 J\": the unit \"J\" is not one of "
            "fracture energy; allowed: a number in J/m2, or a text with a unit of fracture energy "
            "such as \"10 J/m2\"");
}

TEST(RulesOfMechanics, PoissonRatio) {
  const std::string option = "material.rock.poisson_ratio";
  for (const std::string value : {"0.5", "0.7"}) {
    EXPECT_EQ(mechanics_error({option + "=" + value}),
              out_of_range(option, value, "-1 < value < 0.5"));
  }
  for (const std::string value : {"-1", "1"}) {
    EXPECT_EQ(mechanics_error({option + "=" + value}),
              out_of_range(option, value, "-1 < value < 1"));
  }
  EXPECT_EQ(mechanics_error({option + "=0.49"}), "");
  EXPECT_EQ(mechanics_error({option + "=-0.99"}), "");
}

TEST(RulesOfMechanics, LayeredRock) {
  const std::string rock = "material.rock.";
  const std::string layered = rock + "normal_young_modulus=25 GPa";
  EXPECT_EQ(mechanics_error({layered, rock + "normal_poisson_ratio=0.2",
                             rock + "normal_shear_modulus=1e10", rock + "bedding_angle=-30 deg"}),
            "");
  EXPECT_EQ(mechanics_error({layered, rock + "poisson_ratio=0.6"}), "");
  for (const std::string option :
       {"normal_poisson_ratio", "normal_shear_modulus", "bedding_angle"}) {
    EXPECT_EQ(mechanics_error({rock + option + " = 0.1"}),
              no_effect(rock + option + " = 0.1", "normal_young_modulus"));
  }
  EXPECT_EQ(mechanics_error({layered, rock + "normal_shear_modulus=0"}),
            out_of_range(rock + "normal_shear_modulus", "0", "a finite number > 0 Pa"));
}

TEST(RulesOfMechanics, LayersStoreEnergy) {
  const std::string rock = "material.rock.";
  const std::string allowed = "; allowed: moduli and Poisson's ratios with 1 - nu - 2 nu_n^2 E/E_n "
                              "> 0";
  const std::string layered = rock + "normal_young_modulus=25 GPa";
  // The bound of nu_n is sqrt(0.75 * 0.5/2) = 0.4330.
  EXPECT_EQ(mechanics_error({layered, rock + "normal_poisson_ratio=0.433"}), "");
  EXPECT_EQ(mechanics_error({layered, rock + "normal_poisson_ratio=0.44"}),
            "--set: error: material.rock.normal_poisson_ratio = 0.44: the elastic energy could be "
            "negative: 1 - nu - 2 nu_n^2 E/E_n is -0.0244" +
                allowed);
  EXPECT_EQ(mechanics_error({layered, rock + "normal_poisson_ratio=-0.44"}),
            "--set: error: material.rock.normal_poisson_ratio = -0.44: the elastic energy could be "
            "negative: 1 - nu - 2 nu_n^2 E/E_n is -0.0244" +
                allowed);
  EXPECT_EQ(mechanics_error({rock + "normal_young_modulus=400 GPa"}),
            "--set: error: material.rock.normal_young_modulus = \"400 GPa\": the elastic energy "
            "could be negative: 1 - nu - 2 nu_n^2 E/E_n is -0.25" +
                allowed);
}

TEST(RulesOfMechanics, OptionsOfBodies) {
  const std::string body = "body.a.regions=[\"rock\"]";
  EXPECT_EQ(mechanics_error({body, "body.a.rigid=true", "body.a.velocity_x=1"}), "");
  EXPECT_EQ(mechanics_error({body, "body.a.rigid=true"}), "");
  EXPECT_EQ(mechanics_error({body, "body.a.initial_velocity_y=1"}), "");
  for (const std::string option : {"body.a.velocity_x", "body.a.velocity_y"}) {
    EXPECT_EQ(mechanics_error({body, option + " = 1"}), no_effect(option + " = 1", "rigid = true"));
  }
  for (const std::string option : {"body.a.initial_velocity_x", "body.a.initial_velocity_y"}) {
    EXPECT_EQ(mechanics_error({body, "body.a.rigid=true", option + " = 1"}),
              no_effect(option + " = 1", "rigid = false"));
  }
  EXPECT_EQ(mechanics_error({body}),
            "--set: error: body.a: has no effect: it is neither rigid nor has an initial velocity; "
            "allowed: rigid = true, initial_velocity_x or initial_velocity_y");
}

TEST(RulesOfMechanics, RegionsOfBodies) {
  EXPECT_EQ(mechanics_error({"body.a.rigid=true"}),
            "--set: error: body.a.regions: required but missing: Physical surfaces of the mesh "
            "that are this body.");
  EXPECT_EQ(mechanics_error({"body.a={regions=[], rigid=true}"}),
            "--set: error: body.a.regions = []: names no physical group of the mesh; allowed: at "
            "least one name");
  EXPECT_EQ(mechanics_error({"body.a={regions=[\"rock\"], rigid=true}",
                             "body.b={regions=[\"rock\"], rigid=true}"}),
            "--set: error: body.b.regions = [\"rock\"]: \"rock\" already belongs to "
            "body.a.regions; allowed: each name once");
}

TEST(RulesOfMechanics, PointForces) {
  EXPECT_EQ(mechanics_error({"point_force.a={point=[0, 1], force_y=\"-5 kN/m\"}"}), "");
  EXPECT_EQ(mechanics_error({"point_force.a={point=[0, 1]}"}),
            "--set: error: point_force.a: the force is missing; allowed: force_x, force_y or both");
  EXPECT_EQ(mechanics_error({"point_force.a={force_x=1}"}),
            "--set: error: point_force.a.point: required but missing: Place [x, y]; the vertex "
            "nearest to it takes the force.");
  EXPECT_EQ(mechanics_error({"point_force.a={point=[0], force_x=1}"}),
            "--set: error: point_force.a.point = [0]: expects a point; allowed: [x, y], each a "
            "number in m, or a text with a unit of length such as \"5 cm\"");
  EXPECT_THAT(mechanics_error({"point_force.a={point=[0, 0], force_x=\"1 kN\"}"}),
              HasSubstr("the unit \"kN\" is not one of force per metre of thickness"));
}

TEST(RulesOfMechanics, InSituStress) {
  EXPECT_EQ(mechanics_error({"in_situ.stress_yy=-1 MPa"}), "");
  EXPECT_EQ(mechanics_error({"in_situ.datum = 5"}), no_effect("in_situ.datum = 5", "a gradient"));
  EXPECT_EQ(mechanics_error({"in_situ.datum=5", "in_situ.gradient_xy=1"}), "");
  EXPECT_EQ(mechanics_error({"in_situ=5"}),
            "--set: error: in_situ = 5: expects a table, found a number; allowed: [in_situ] with "
            "its options below");
  EXPECT_THAT(mechanics_error({"in_situ.stress_yx=5"}),
              StartsWith("--set: error: in_situ.stress_yx: unknown option; the nearest valid name "
                         "is \"stress_xx\""));
  EXPECT_EQ(
      mechanics_error({"in_situ.stress_zz=-5 MPa", "in_situ.gradient_zz=1", "in_situ.datum=5"}),
      "");
  EXPECT_EQ(mechanics_error({"in_situ.stress_zz = 5", "model.plane=stress"}),
            no_effect("in_situ.stress_zz = 5", "model.plane = \"strain\""));
  EXPECT_THAT(mechanics_error({"in_situ.gradient_yy=5 kPa"}),
              HasSubstr("the unit \"kPa\" is not one of stress per length"));
}

TEST(RulesOfMechanics, Excavations) {
  EXPECT_EQ(mechanics_error({"excavation.a={regions=[\"r\"], start=\"9 ms\", duration=1}"}), "");
  EXPECT_EQ(mechanics_error({"excavation.a={start=0}"}),
            "--set: error: excavation.a.regions: required but missing: Physical surfaces of the "
            "mesh that are taken out.");
  EXPECT_EQ(mechanics_error({"excavation.a={regions=[\"r\"]}", "excavation.b={regions=[\"r\"]}"}),
            "--set: error: excavation.b.regions = [\"r\"]: \"r\" already belongs to "
            "excavation.a.regions; allowed: each name once");
  EXPECT_EQ(
      mechanics_error({"excavation.a={regions=[\"r\"], start=\"11 ms\"}"}),
      "--set: error: excavation.a.start = \"11 ms\": 0.011 s is not before the end of the run; "
      "allowed: below 0.01 s");
  for (const std::string option : {"excavation.a.start", "excavation.a.duration"}) {
    EXPECT_EQ(mechanics_error({"excavation.a.regions=[\"r\"]", option + "=-1"}),
              out_of_range(option, "-1", "a finite number >= 0 s"));
  }
}

TEST(RulesOfMechanics, Damping) {
  EXPECT_EQ(mechanics_error({"damping.nodal_viscosity=-1"}),
            out_of_range("damping.nodal_viscosity", "-1", "a finite number >= 0 kg/(m s)"));
  EXPECT_EQ(mechanics_error({"damping.element_viscosity=-1"}),
            out_of_range("damping.element_viscosity", "-1", "a finite number >= 0 Pa s"));
  EXPECT_EQ(mechanics_error({"damping.viscosity_ratio=-1"}),
            out_of_range("damping.viscosity_ratio", "-1", "a finite number >= 0"));
  for (const std::string value : {"1", "-0.1"}) {
    EXPECT_EQ(mechanics_error({"damping.local=" + value}),
              out_of_range("damping.local", value, "0 <= value < 1"));
  }
  EXPECT_EQ(mechanics_error({"damping.local=0.8", "damping.nodal_viscosity=1 kg/(m s)"}), "");
  EXPECT_EQ(mechanics_error({"damping.element_viscosity=1", "damping.viscosity_ratio=2"}),
            "--set: error: damping.viscosity_ratio = 2: contradicts \"element_viscosity\", which "
            "is given too; allowed: only one of \"element_viscosity\", \"viscosity_ratio\"");
  EXPECT_EQ(mechanics_error({"damping.element_viscosity=0", "damping.viscosity_ratio=2"}), "");
}

TEST(RulesOfMechanics, Contact) {
  EXPECT_EQ(mechanics_error({"contact.penalty=0"}),
            out_of_range("contact.penalty", "0", "a finite number > 0 Pa"));
  EXPECT_EQ(mechanics_error({"contact.tangential_penalty=0"}),
            out_of_range("contact.tangential_penalty", "0", "a finite number > 0 Pa/m"));
  EXPECT_EQ(mechanics_error({"contact.penalty=1 GPa", "contact.tangential_penalty=1 GPa/m"}), "");
}

TEST(RulesOfMechanics, Time) {
  EXPECT_EQ(mechanics_error({"time.scheme=implicit"}),
            "--set: error: time.scheme = \"implicit\": the motion of rock is advanced explicitly; "
            "allowed: "
            "\"explicit\", or none");
  EXPECT_EQ(
      mechanics_error({"time.scheme=steady"}),
      "--set: error: time.scheme = \"steady\": the motion of rock is advanced explicitly; allowed: "
      "\"explicit\", or none");
  EXPECT_EQ(mechanics_error({"time.end="}),
            "case.toml:25:2: error: time.end: required but missing: the time at which the run "
            "ends; allowed: a finite number > 0 s");
  for (const std::string value : {"0", "1"}) {
    EXPECT_EQ(mechanics_error({"time.stop_ratio=" + value}),
              out_of_range("time.stop_ratio", value, "0 < value < 1"));
  }
  EXPECT_EQ(mechanics_error({"time.mass_scaling_step=0"}),
            out_of_range("time.mass_scaling_step", "0", "a finite number > 0 s"));
  EXPECT_EQ(mechanics_error({"time.step=1 us", "time.safety=0.5", "time.stop_ratio=1e-3",
                             "time.mass_scaling_step=1 us"}),
            "");
}

}  // namespace
}  // namespace percolith::case_file
