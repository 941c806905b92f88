// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/archive.hpp"
#include "percolith/core/error.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace percolith {
namespace {

enum class Colour : std::uint8_t { red, green };

struct Piece {
  double size = 0.0;
  std::array<std::int32_t, 2> ends{};
  void describe_state(StateArchive& archive) {
    archive("size", size);
    archive("ends", ends);
  }
  friend bool operator==(const Piece&, const Piece&) = default;
};

struct Whole {
  std::vector<double> field;
  std::vector<Piece> pieces;
  std::array<std::vector<double>, 2> points;
  std::optional<double> limit;
  std::map<std::string, double> rates;
  std::vector<std::pair<std::string, double>> row;
  std::vector<std::string> words;
  std::string name;
  Colour colour = Colour::red;
  bool yes = false;
  CompensatedSum sum;
  Point place;
  void describe_state(StateArchive& archive) {
    archive("field", field);
    archive.of_any_size("pieces", pieces);
    archive("points", points);
    archive("limit", limit);
    archive("rates", rates);
    archive.of_any_size("row", row);
    archive.of_any_size("words", words);
    archive("name", name);
    archive("colour", colour);
    archive("yes", yes);
    archive("sum", sum);
    archive("place", place);
  }
};

Whole full() {
  Whole whole{{0.1, -0.0, std::numeric_limits<double>::quiet_NaN()},
              {{1.5, {1, 2}}, {2.5, {3, 4}}},
              {{{1.0}, {2.0, 3.0}}},
              7.0,
              {{"inlet", 1.0}, {"outlet", -1.0}},
              {{"energy", 3.0}},
              {"a", "", "bc"},
              "box",
              Colour::green,
              true,
              {1.0, 1e-17},
              {4.0, 5.0}};
  return whole;
}

/// As it is built: the sizes that the model gives are there, nothing else.
Whole built() {
  Whole whole;
  whole.field.resize(3);
  whole.points = {std::vector<double>(1), std::vector<double>(2)};
  whole.rates = {{"other", 2.0}};
  return whole;
}

std::string written(Whole whole) {
  std::string bytes;
  StateWriter writer([&](std::string_view part) { bytes += part; });
  writer("whole", whole);
  return bytes;
}

std::string refusal(std::string_view bytes, Whole whole) {
  try {
    StateReader reader(bytes, "file");
    reader("whole", whole);
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Archive, GivesBackTheSameBits) {
  const std::string bytes = written(full());
  Whole whole = built();
  StateReader reader(bytes, "file");
  reader("whole", whole);
  EXPECT_TRUE(reader.rest().empty());
  EXPECT_EQ(written(whole), bytes);
  EXPECT_EQ(whole.pieces, full().pieces);
  EXPECT_EQ(whole.limit, 7.0);
  EXPECT_EQ(whole.rates, full().rates);
  EXPECT_EQ(whole.words, full().words);
  EXPECT_EQ(whole.name, "box");
  EXPECT_EQ(whole.colour, Colour::green);
  EXPECT_TRUE(whole.yes);
  EXPECT_EQ(whole.sum.carry, 1e-17);
  EXPECT_EQ(whole.place.y, 5.0);
}

TEST(Archive, ForgetsWhatIsAbsent) {
  Whole absent = full();
  absent.limit.reset();
  const std::string bytes = written(absent);
  Whole whole = built();
  whole.limit = 3.0;
  StateReader reader(bytes, "file");
  reader("whole", whole);
  EXPECT_FALSE(whole.limit.has_value());
}

TEST(Archive, RefusesBytesThatEndTooEarlyWhereverThatIs) {
  const std::string bytes = written(full());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_NE(refusal(std::string_view(bytes).substr(0, size), built()), "no error") << size;
  }
  EXPECT_EQ(refusal(std::string_view(bytes).substr(0, bytes.size() - 1), built()),
            "file: whole.place.y: the file ends too early");
}

TEST(Archive, RefusesArraysOfAnotherSizeThanTheModelHas) {
  Whole other = built();
  other.field.resize(4);
  EXPECT_EQ(refusal(written(full()), other),
            "file: whole.field: 3 values stand there, the model has 4");
}

TEST(Archive, RefusesOtherValuesInTheirPlace) {
  std::string bytes = written(full());
  bytes.replace(bytes.find("limit"), 5, "timil");
  EXPECT_EQ(refusal(bytes, built()), "file: whole.limit: another value stands in its place");
}

TEST(Archive, MakesNoRoomForWhatCannotBeThere) {
  std::string bytes = written(full());
  const std::size_t count = bytes.find("pieces") + 6;
  bytes.replace(count, 8, 8, '\x7f');
  EXPECT_EQ(
      refusal(bytes, built()),
      "file: whole.pieces: 9187201950435737471 elements do not fit into the rest of the file");
}

}  // namespace
}  // namespace percolith
