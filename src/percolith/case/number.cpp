// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/number.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace percolith::case_file {

namespace {

struct Raw {
  double number = 0.0;
  std::string unit;
};

/// The number and its unit as written, before any conversion.
std::optional<Raw> raw_number(const Node& node, const std::string& key, const Quantity& quantity,
                              Context& context, std::string_view unit) {
  const std::string default_unit(unit.empty() ? quantity.unit : unit);
  if (const auto* number = std::get_if<double>(&node.value)) {
    return Raw{*number, default_unit};
  }
  if (const auto* whole = std::get_if<std::int64_t>(&node.value)) {
    return Raw{static_cast<double>(*whole), default_unit};
  }
  const std::string* text = node.text();
  if (text == nullptr) {
    report(context, node, key, fmt::format("expects a number, found {}", kind_of(node)),
           allowed_number(quantity));
    return std::nullopt;
  }
  const std::optional<NumberWithUnit> split = split_number(*text);
  if (!split) {
    report(context, node, key, "not a number with a unit", allowed_number(quantity));
    return std::nullopt;
  }
  const bool needs_unit = quantity.unit != "1" && !std::isinf(split->number);
  if (split->unit.empty() && needs_unit) {
    report(context, node, key, "missing unit", allowed_number(quantity));
    return std::nullopt;
  }
  return Raw{split->number,
             split->unit.empty() ? std::string(quantity.unit) : std::string(split->unit)};
}

/// What is wrong with a number out of its bounds. Angles without a unit are mostly meant in
/// degrees, shares of five and more in percent.
std::string out_of_range(const Node& node, const Quantity& quantity, double number,
                         std::string_view unit) {
  constexpr double many = 5.0;
  const bool is_plain = node.text() == nullptr && unit.empty();
  const bool is_share =
      quantity.unit == "1" && quantity.bounds.low == 0.0 && quantity.bounds.high == 1.0;
  if (is_share && is_plain && number >= many && quantity.bounds.contains(number / 100.0)) {
    return fmt::format("out of range: it is a share of one; did you mean \"{:g} %\"", number);
  }
  if (quantity.unit != "rad" || !is_plain ||
      !quantity.bounds.contains(number * std::numbers::pi / 180.0)) {
    return "out of range";
  }
  return fmt::format("out of range: a number without a unit is in radians; degrees are written "
                     "\"{:g} deg\"",
                     number);
}

}  // namespace

void report(Context& context, const Node& node, const std::string& key, std::string reason,
            std::string allowed) {
  context.problems.add({node.location, key, to_text(node), std::move(reason), std::move(allowed)});
}

std::string allowed_number(const Quantity& quantity) {
  const Dimension dimension = dimension_of(quantity.unit, quantity.dimension);
  if (quantity.unit == "1") {
    return "a number, or a text such as \"10 %\"";
  }
  return fmt::format("a number in {}, or a text with a unit of {} such as \"{}\"", quantity.unit,
                     dimension.name, dimension.example);
}

std::optional<double> read_number(const Node& node, const std::string& key,
                                  const Quantity& quantity, Context& context,
                                  std::string_view unit) {
  const std::optional<Raw> raw = raw_number(node, key, quantity, context, unit);
  if (!raw) {
    return std::nullopt;
  }
  if (std::isnan(raw->number)) {
    report(context, node, key, "not a number", to_text(quantity.bounds, quantity.unit));
    return std::nullopt;
  }
  const Units::Converted converted =
      context.units.convert(raw->number, raw->unit, quantity.unit, quantity.dimension);
  if (!converted.value) {
    report(context, node, key, converted.reason, allowed_number(quantity));
    return std::nullopt;
  }
  if (!quantity.bounds.contains(*converted.value)) {
    report(context, node, key, out_of_range(node, quantity, raw->number, unit),
           to_text(quantity.bounds, quantity.unit));
    return std::nullopt;
  }
  return converted.value;
}

}  // namespace percolith::case_file
