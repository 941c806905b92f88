// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/applies.hpp"
#include "percolith/case/applies_physics.hpp"
#include "percolith/case/documents.hpp"
#include "percolith/case/node.hpp"
#include "percolith/case/option_list.hpp"
#include "percolith/case/path.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>

#include "unit/case/mechanics_case.hpp"
#include "unit/case/minimal_case.hpp"
#include "unit/case/random_mechanics.hpp"
#include "unit/case/random_setup.hpp"

namespace percolith::case_file {
namespace {

using testing::HasSubstr;

TEST(Resolved, ReadAgainGivesTheSameSetupBitForBit) {
  const bool holds = rc::check("resolved input read again is the same setup", [] {
    const simulation::Setup setup =
        *rc::gen::arbitrary<bool>() ? RandomSetup().make() : RandomMechanics().make();
    const std::string text = resolved_toml(setup);
    simulation::Setup again;
    try {
      again = read(text).setup;
    } catch (const Error& error) {
      RC_FAIL(std::string(error.what()) + "\n" + text);
    }
    RC_ASSERT(again == setup);
    RC_ASSERT(resolved_toml(again) == text);
  });
  EXPECT_TRUE(holds);
}

TEST(Resolved, NumbersKeepAllTheirBits) {
  const bool holds = rc::check("a number written as TOML is read as the same number", [] {
    const double value = *rc::gen::arbitrary<double>();
    RC_ASSERT(std::strtod(to_toml(value).c_str(), nullptr) == value);
  });
  EXPECT_TRUE(holds);
  EXPECT_EQ(to_toml(-0.0), "-0.0");
  EXPECT_EQ(to_toml(1.0), "1.0");
  EXPECT_EQ(to_toml(2.2e9), "2.2e+09");
  EXPECT_EQ(to_toml(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(Resolved, NamesEveryOption) {
  const std::string text = resolved_toml(read(minimal_case).setup);
  const std::string mechanics =
      resolved_toml(read(mechanics_case + "[in_situ]\ngradient_yy = 1\n"
                                          "[body.a]\nregions = [\"rock\"]\nrigid = true\n"
                                          "[point_force.a]\npoint = [0, 0]\nforce_x = 1\n"
                                          "[excavation.a]\nregions = [\"core\"]\n")
                        .setup);
  const std::string coupled = resolved_toml(read(coupled_case).setup);
  for (const std::string& option : option_paths()) {
    const Path path = split_path(option);
    const bool has_table = path[0] != "fracture" && path[0] != "source" && path[0] != "probe";
    if (has_table) {
      const bool in_seepage =
          has_option("seepage", path[0]) && has_option("seepage", path[0] + ".*");
      const bool in_mechanics =
          has_option("mechanics", path[0]) && has_option("mechanics", path[0] + ".*");
      EXPECT_THAT(in_seepage     ? text
                  : in_mechanics ? mechanics
                                 : coupled,
                  testing::ContainsRegex("(^|\n)(# )?" + path.back() + " "))
          << option;
    }
  }
}

TEST(Resolved, TellsWhichTablesHaveNoEffectOrAreAbsent) {
  const std::string seepage = resolved_toml(read(minimal_case).setup);
  for (const std::string table : {"in_situ", "damping", "contact"}) {
    EXPECT_THAT(seepage, HasSubstr("\n# [" + table + "] has no effect: it needs " +
                                   std::string(needs_motion) + "\n"));
  }
  const std::string mechanics = resolved_toml(read(mechanics_case).setup);
  for (const std::string table : {"fluid", "initial"}) {
    EXPECT_THAT(mechanics, HasSubstr("\n# [" + table + "] has no effect: it needs " +
                                     std::string(needs_flow) + "\n"));
  }
  EXPECT_THAT(mechanics, HasSubstr("\n# [in_situ] is not given\n"));
  EXPECT_THAT(mechanics, HasSubstr("\nscheme = \"explicit\"\n"));
}

TEST(Resolved, TellsUnitsAndWhyOptionsAreAbsent) {
  const std::string text = resolved_toml(read(minimal_case).setup);
  EXPECT_THAT(text, HasSubstr("\nend = 3600.0  # s\n"));
  EXPECT_THAT(text, HasSubstr("\npermeability = 2e-13  # m2\n"));
  EXPECT_THAT(text, HasSubstr("\n# biot_modulus is not given: bulk modulus of the fluid over "
                              "porosity\n"));
  EXPECT_THAT(text, HasSubstr("\n# safety has no effect: it needs time.scheme = \"explicit\"\n"));
}

TEST(Resolved, EndsWithDerivedValuesAsComments) {
  const std::vector<DerivedValue> derived{{"version", "0.1.0", ""},
                                          {"material.rock.biot_modulus", "2.2e10", "Pa"},
                                          {"note", "two\nlines = 3", ""}};
  const std::string text = resolved_toml(read(minimal_case).setup, derived);
  EXPECT_THAT(text, testing::EndsWith("\n# Derived values\n# version = 0.1.0\n"
                                      "# material.rock.biot_modulus = 2.2e10 Pa\n"
                                      "# note = two lines = 3\n"));
  EXPECT_EQ(read(text).setup, read(minimal_case).setup);
}

TEST(Resolved, HoldsTheScheduleOfAFileInline) {
  simulation::Setup setup = read(minimal_case).setup;
  setup.boundary["left"].pressure = Schedule{{0.0, 0.1}, {1e5, 2e5}, Interpolation::step};
  EXPECT_THAT(
      resolved_toml(setup),
      HasSubstr("\npressure = { times = [0.0, 0.1], values = [1e+05, 2e+05], interpolation = "
                "\"step\" }  # Pa\n"));
}

TEST(Schema, DescribesEveryOption) {
  const nlohmann::json schema = nlohmann::json::parse(schema_json());
  EXPECT_EQ(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
  for (const std::string& option : option_paths()) {
    const nlohmann::json* at = &schema;
    for (const std::string& part : split_path(option)) {
      const char* const holder = part == "*" ? "additionalProperties" : "properties";
      ASSERT_TRUE(at->contains(holder)) << option;
      at = part == "*" ? &(*at)[holder] : &(*at)[holder][part];
    }
    EXPECT_TRUE(at->contains("description")) << option;
    EXPECT_TRUE(at->contains("type") || at->contains("anyOf") || at->contains("enum")) << option;
  }
}

TEST(Schema, HoldsUnitsBoundsDefaultsAndNeed) {
  const nlohmann::json schema = nlohmann::json::parse(schema_json());
  const nlohmann::json& fluid = schema["properties"]["fluid"]["properties"];
  EXPECT_EQ(fluid["viscosity"]["x-unit"], "Pa s");
  EXPECT_EQ(fluid["viscosity"]["default"], 1e-3);
  EXPECT_EQ(fluid["viscosity"]["anyOf"][0]["exclusiveMinimum"], 0.0);
  EXPECT_EQ(fluid["cavitation_pressure"]["anyOf"][2]["const"], "-inf");
  const nlohmann::json& rock = schema["properties"]["material"]["additionalProperties"];
  EXPECT_EQ(rock["required"], (std::vector<std::string>{"regions"}));
  EXPECT_EQ(rock["properties"]["porosity"]["anyOf"][0]["maximum"], 1.0);
  EXPECT_EQ(schema["required"], (std::vector<std::string>{"format", "mesh", "model"}));
  EXPECT_EQ(schema["properties"]["time"]["properties"]["scheme"]["enum"],
            (std::vector<std::string>{"implicit", "explicit", "steady", "quasi_static"}));
}

TEST(Reference, IsTheCommittedPage) {
  std::ifstream stream("docs/options.md", std::ios::binary);
  const std::string page{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  EXPECT_EQ(page, reference_markdown())
      << "write it again: percolith schema --reference > docs/options.md";
}

TEST(Reference, TellsWhichPhysicsAnOptionBelongsTo) {
  const std::string page = reference_markdown();
  EXPECT_THAT(page, HasSubstr("flows as in a porous rock. *In seepage and coupled only.* |\n"));
  EXPECT_THAT(
      page,
      HasSubstr("Whether the boundary stays where it is. *In mechanics and coupled only.* |\n"));
  EXPECT_THAT(page, HasSubstr("\n## `[damping]`\n\nWhat takes energy out of the motion. *In "
                              "mechanics and coupled only.*\n"));
  EXPECT_THAT(page, HasSubstr("| **required** | Acceleration of gravity along -y: 9.81 for a "
                              "vertical section, 0 for a horizontal plan. |\n"));
  EXPECT_THAT(
      page,
      HasSubstr(
          "`\"steady\"`, `\"quasi_static\"`; in mechanics `\"explicit\"` | `\"implicit\"`; in "
          "mechanics `\"explicit\"` |"));
  EXPECT_EQ(physics_of("material.*.regions").size(), 3U);
}

TEST(Reference, HasARowForEveryOption) {
  const std::string page = reference_markdown();
  for (const std::string& option : option_paths()) {
    EXPECT_THAT(page, HasSubstr("\n| `" + split_path(option).back() + "` | ")) << option;
  }
}

}  // namespace
}  // namespace percolith::case_file
