// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/physics.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "unit/case/mechanics_case.hpp"

namespace percolith::case_file {
namespace {

std::string without(std::string text, const std::string& part) {
  return text.replace(text.find(part), part.size(), "");
}

std::string missing(const std::string& place, const std::string& option,
                    const std::string& physics) {
  return place + ": error: model.physics: required but missing: " + option + " is an option of " +
         physics +
         ", and without it a case is one of seepage; allowed: \"seepage\" (flow through a rock at "
         "rest), \"mechanics\" (a dry rock that deforms and breaks) or \"coupled\" (both)";
}

TEST(FindPhysics, ThatIsMissingIsTheOneMessageOfACaseThatIsNotOfSeepage) {
  const std::string both = "\"mechanics\" or \"coupled\"";
  EXPECT_EQ(error_of(without(mechanics_case, "physics = \"mechanics\"\n")),
            missing("case.toml:6:2", "material.rock.density (line 11)", both));
  EXPECT_EQ(error_of(without(coupled_case, "physics = \"coupled\"\n")),
            missing("case.toml:6:2", "material.rock.density (line 11)", both));
  EXPECT_EQ(error_set({"new_cracks.exchange=1e-9"}),
            missing("case.toml:6:2", "new_cracks.exchange", "\"coupled\""));
}

TEST(FindPhysics, WhatIsWrongWithoutRegardToPhysicsIsToldBesideIt) {
  std::string text = without(mechanics_case, "physics = \"mechanics\"\n");
  text = text.replace(text.find("50 GPa"), 6, "50 Gpa");
  const std::string message = error_of(text);
  EXPECT_NE(message.find("unknown unit \"Gpa\""), std::string::npos) << message;
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << message;
}

TEST(FindPhysics, IsSeepageWhereNothingElseIsWritten) {
  EXPECT_EQ(error_set({}), "");
}

TEST(FindPhysics, ThatIsMisspeltHasNoConsequences) {
  std::string text = coupled_case;
  text.replace(text.find("coupled"), 7, "couple");
  EXPECT_EQ(error_of(text), "case.toml:7:11: error: model.physics = \"couple\": no such choice; "
                            "allowed: \"seepage\", \"mechanics\", \"coupled\"");
}

}  // namespace
}  // namespace percolith::case_file
