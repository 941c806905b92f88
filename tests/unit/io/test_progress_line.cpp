// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/observers.hpp"
#include "percolith/io/progress_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace percolith::io {
namespace {

simulation::Progress at(double time, std::int64_t step) {
  simulation::Progress progress;
  progress.time = time;
  progress.end = 100;
  progress.step_size = 0.5;
  progress.step = step;
  progress.iterations = 3;
  progress.limited_by = "tolerance";
  return progress;
}

TEST(FormatDuration, ReadsLikeAClock) {
  EXPECT_EQ(format_duration(4.24), "4.2 s");
  EXPECT_EQ(format_duration(59.97), "1 min 00 s");
  EXPECT_EQ(format_duration(185), "3 min 05 s");
  EXPECT_EQ(format_duration(7800), "2 h 10 min");
  EXPECT_EQ(format_duration(86400 * 5 + 3 * 3600), "5 d 03 h");
  EXPECT_EQ(format_duration(1e300), "very long");
}

TEST(FormatProgress, NamesStepTimeSizeLimitAndRest) {
  EXPECT_EQ(format_progress(at(25.6, 12), 61), "step 12  time 25.6 s of 100 s (25 %)  ETA 1 min 01 "
                                               "s  step size 0.5 s (tolerance)  iterations 3");
}

TEST(FormatProgress, CountsBrokenJointsInMechanics) {
  simulation::Progress mechanics = at(25.6, 12);
  mechanics.iterations = 0;
  mechanics.limited_by = "joints";
  mechanics.broken_joints = 123;
  EXPECT_EQ(format_progress(mechanics, -1),
            "step 12  time 25.6 s of 100 s (25 %)  cracks 123  step size 0.5 s (joints)");
}

TEST(FormatProgress, LeavesOutWhatIsNotKnown) {
  simulation::Progress steady;
  steady.step = 1;
  EXPECT_EQ(format_progress(steady, -1), "step 1");
}

struct Screen {
  std::string text;
  double now = 0.0;
  ProgressLine line(ProgressStyle style, int width = 200) {
    return {style, width, [this](std::string_view part) { text += part; }, [this] { return now; }};
  }
};

TEST(ProgressLine, IsRedrawnAtMostFiveTimesASecond) {
  Screen screen;
  ProgressLine line = screen.line(ProgressStyle::terminal);
  for (int i = 0; i <= 1000; ++i) {
    screen.now = i * 1e-3;
    line.on_progress(at(i * 0.1, i));
  }
  const auto drawn = std::count(screen.text.begin(), screen.text.end(), '\r');
  EXPECT_GE(drawn, 5);
  EXPECT_LE(drawn, 6);
  EXPECT_EQ(screen.text.find('\n'), std::string::npos);
}

TEST(ProgressLine, EstimatesTheRestFromThePaceOfSteps) {
  Screen screen;
  ProgressLine line = screen.line(ProgressStyle::terminal);
  line.on_progress(at(0, 0));
  screen.text.clear();
  screen.now = 1.0;
  line.on_progress(at(50, 10));  // 0.1 s a step, 100 steps of 0.5 s to go
  EXPECT_NE(screen.text.find("ETA 10.0 s"), std::string::npos) << screen.text;
}

TEST(ProgressLine, FitsTheTerminalAndCanBeCleared) {
  Screen screen;
  ProgressLine line = screen.line(ProgressStyle::terminal, 20);
  line.clear();
  EXPECT_EQ(screen.text, "");
  line.on_progress(at(1, 1));
  EXPECT_EQ(screen.text, "\rstep 1  time 1 s of\x1b[K");
  screen.text.clear();
  line.clear();
  EXPECT_EQ(screen.text, "\r\x1b[K");
}

TEST(ProgressLine, WritesALineForEachTenthWhereThereIsNoTerminal) {
  Screen screen;
  ProgressLine line = screen.line(ProgressStyle::plain);
  for (int i = 0; i <= 1000; ++i) {
    line.on_progress(at(i * 0.1, i));
  }
  EXPECT_EQ(std::count(screen.text.begin(), screen.text.end(), '\n'), 10);
  EXPECT_EQ(screen.text.find('\r'), std::string::npos);
  EXPECT_NE(screen.text.find("time 100 s of 100 s (100 %)"), std::string::npos);
}

TEST(ProgressLine, WritesALineEveryTenSecondsOfASlowRun) {
  Screen screen;
  ProgressLine line = screen.line(ProgressStyle::plain);
  for (int i = 1; i <= 35; ++i) {
    screen.now = i;
    line.on_progress(at(i * 0.01, i));
  }
  EXPECT_EQ(std::count(screen.text.begin(), screen.text.end(), '\n'), 3);
}

struct Counter : simulation::Observer {
  int calls = 0;
  void on_progress(const simulation::Progress&) override { ++calls; }
  void on_history(const simulation::HistoryRow&) override { ++calls; }
  void on_frame(const simulation::Frame&) override { ++calls; }
  void on_probes(double, const std::vector<simulation::ProbeSample>&) override { ++calls; }
  void on_events(const std::vector<simulation::BreakEvent>&) override { ++calls; }
  void on_warning(const std::string&) override { ++calls; }
};

TEST(Observers, PassEveryReportToAll) {
  Counter first;
  Counter second;
  Observers both({&first, &second});
  both.on_progress({});
  both.on_history({});
  both.on_frame({});
  both.on_probes(0, {});
  both.on_events({});
  both.on_warning("");
  EXPECT_EQ(first.calls, 6);
  EXPECT_EQ(second.calls, 6);
}

}  // namespace
}  // namespace percolith::io
