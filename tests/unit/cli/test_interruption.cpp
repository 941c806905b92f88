// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/cli/interruption.hpp"

#include <gtest/gtest.h>

#include <csignal>

namespace percolith::cli {
namespace {

TEST(Interruption, OnlyAsksTheFirstTime) {
  Interruption interruption;
  interruption.begin();
  EXPECT_EQ(interruption.signal(), 0);
  std::raise(SIGTERM);
  EXPECT_EQ(interruption.signal(), SIGTERM);
}

TEST(InterruptionDeathTest, EndsTheProgramTheSecondTime) {
  EXPECT_EXIT(
      {
        Interruption interruption;
        interruption.begin();
        std::raise(SIGINT);
        std::raise(SIGINT);
      },
      testing::ExitedWithCode(130), "");
}

TEST(InterruptionDeathTest, EndsTheProgramBeforeTheRunBegins) {
  EXPECT_EXIT(
      {
        const Interruption interruption;
        std::raise(SIGTERM);
      },
      testing::ExitedWithCode(143), "");
}

TEST(Interruption, MakesWritesToClosedPipesFail) {
  const Interruption interruption;
  std::raise(SIGPIPE);
  std::raise(SIGXFSZ);
}

}  // namespace
}  // namespace percolith::cli
