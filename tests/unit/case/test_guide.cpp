// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/documents.hpp"

#include <iterator>

#include "unit/case/minimal_case.hpp"
#include "unit/case/temporary_folder.hpp"

namespace percolith::case_file {
namespace {

/// The guide to case files in parts: its sections on mechanics, on coupled cases and on slow
/// injection, and the rest.
struct Guide {
  std::string mechanics;
  std::string coupling;
  std::string slow_injection;
  std::string rest;
};

/// Takes the section of that title out of a text.
std::string take_section(std::string& text, const std::string& title) {
  const std::size_t begin = text.find("\n## " + title + "\n");
  const std::size_t end = text.find("\n## ", begin + 1);
  std::string section = text.substr(begin, end - begin);
  text.erase(begin, end - begin);
  return section;
}

Guide guide() {
  std::ifstream stream("docs/case-file.md", std::ios::binary);
  Guide parts;
  parts.rest.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  parts.mechanics = take_section(parts.rest, "Mechanics");
  parts.coupling = take_section(parts.rest, "Coupled cases");
  const std::size_t slow = parts.coupling.find("\n### Slow injection\n");
  parts.slow_injection = parts.coupling.substr(slow);
  parts.coupling.erase(slow);
  return parts;
}

/// The blocks of that language in a text.
std::vector<std::string> blocks_of(const std::string& language,
                                   const std::string& text = guide().rest) {
  const std::string opening = "```" + language + "\n";
  std::vector<std::string> blocks;
  for (std::size_t at = text.find(opening); at != std::string::npos; at = text.find(opening, at)) {
    at += opening.size();
    blocks.push_back(text.substr(at, text.find("```", at) - at));
  }
  return blocks;
}

void replace(std::string& text, const std::string& part, const std::string& other) {
  ASSERT_NE(text.find(part), std::string::npos) << part;
  text.replace(text.find(part), part.size(), other);
}

TEST(Guide, ItsFirstCaseIsValid) {
  const simulation::Setup setup = read(blocks_of("toml").at(0)).setup;
  EXPECT_EQ(setup.time.end, 60.0);
  EXPECT_EQ(setup.output.times, (std::vector<double>{1.0, 10.0}));
}

TEST(Guide, ItsFirstCaseBecomesSteadyAsItSays) {
  EXPECT_EQ(error_of(blocks_of("toml").at(0), {"time.scheme=steady", "time.end=", "output.times="}),
            "");
}

TEST(Guide, ItsOtherExamplesMakeAValidCaseTogether) {
  const TemporaryFolder folder;
  folder.write("pump.csv", "minutes,rate\n0,1\n5,2\n");
  const std::vector<std::string> blocks = blocks_of("toml");
  std::string text = "format = 1\n";
  for (std::size_t i = 1; i < blocks.size(); ++i) {
    text += blocks[i];
  }
  const simulation::Setup setup = read_case_text(text, folder.path() / "case.toml").setup;
  EXPECT_EQ(setup.source.at("test").rate->time, (std::vector<double>{0.0, 300.0}));
  EXPECT_EQ(read(resolved_toml(setup)).setup, setup);
}

TEST(Guide, ItsExamplesOfMechanicsMakeAValidCaseTogether) {
  std::string text;
  for (const std::string& block : blocks_of("toml", guide().mechanics)) {
    text += block;
  }
  const simulation::Setup setup = read(text).setup;
  EXPECT_EQ(setup.model.physics, simulation::Physics::mechanics);
  EXPECT_TRUE(setup.body.at("plate").rigid);
  EXPECT_EQ(setup.in_situ->gradient_yy, 26e3);
  EXPECT_EQ(setup.time.end, 0.05);
  EXPECT_EQ(read(resolved_toml(setup)).setup, setup);
}

TEST(Guide, ItsCoupledCaseIsValidAloneAndWithItsOtherExamples) {
  std::string text;
  for (const std::string& block : blocks_of("toml", guide().coupling)) {
    text += block;
    EXPECT_EQ(error_of(text), "");
  }
  const simulation::Setup setup = read(text).setup;
  EXPECT_EQ(setup.model.physics, simulation::Physics::coupled);
  ASSERT_TRUE(setup.new_cracks);
  EXPECT_TRUE(setup.boundary.at("well").pressurised);
  EXPECT_DOUBLE_EQ(setup.source.at("well").rate->value.back(), -4e-3);
  EXPECT_DOUBLE_EQ(setup.excavation.at("gallery").pressure, 1e5);
  EXPECT_EQ(read(resolved_toml(setup)).setup, setup);
}

TEST(Guide, ItsCoupledCaseBecomesSlowAsItSays) {
  std::string text = blocks_of("toml", guide().coupling).at(0);
  // Which it says must go.
  replace(text, "[damping]\nlocal = 0.1\n\n", "");
  const std::size_t time = text.find("[time]\n");
  ASSERT_EQ(text.substr(time), "[time]\nend = \"10 ms\"\n");
  text.replace(time, std::string::npos, blocks_of("toml", guide().slow_injection).at(0));
  EXPECT_EQ(error_of(text), "");
  EXPECT_EQ(read(text).setup.time.scheme, simulation::Scheme::quasi_static);
}

TEST(Guide, ItsErrorsAreThoseOfTheProgram) {
  std::string text = blocks_of("toml").at(0);
  replace(text, "file = ", "fiel = ");
  replace(text, "\"200 mdarcy\"", "\"200\"");
  replace(text, "porosity = 0.1", "porosity = 1.1");
  try {
    (void)read_case_text(text, "strip.toml");
    FAIL() << "a case full of errors was read";
  } catch (const InputErrors& errors) {
    EXPECT_EQ(std::string(errors.what()) + "\n", blocks_of("text").at(0));
  }
}

}  // namespace
}  // namespace percolith::case_file
