// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/reader.hpp"

#include "percolith/case/path.hpp"
#include "percolith/case/unknown_key.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace percolith::case_file {

const Node* Reader::find(std::string_view name, Need need, std::string_view help) {
  known_.push_back(name);
  const Node* node = table_.table()->find(name);
  if (node != nullptr) {
    context_.locations.add(key(name), {node->location, to_text(*node)});
  } else if (need == Need::required) {
    context_.problems.add_missing(
        {table_.key_location, key(name), {}, fmt::format("required but missing: {}", help), {}});
  }
  return node;
}

const Node* Reader::find_table(const Node& holder, std::string_view name, const std::string& path) {
  const Node* node = holder.table()->find(name);
  if (node == nullptr) {
    return nullptr;
  }
  context_.locations.add(path, {node->key_location, {}});
  if (node->table() == nullptr) {
    report(context_, *node, path, fmt::format("expects a table, found {}", kind_of(*node)),
           fmt::format("[{}] with its options below", path));
    return nullptr;
  }
  return node;
}

void Reader::refuse(const Node& node, std::string_view name, std::string reason,
                    std::string allowed) {
  report(context_, node, key(name), std::move(reason), std::move(allowed));
}

void Reader::refuse_choice(const Node& node, std::string_view name,
                           const std::vector<std::string_view>& names) {
  refuse(node, name,
         node.text() == nullptr ? "expects a text, found " + kind_of(node)
                                : std::string("no such choice"),
         listed(names));
}

bool Reader::check_name(const Entry& entry, const std::string& path) {
  const bool good = is_plain_name(entry.key);
  if (!good) {
    context_.problems.add({entry.value.key_location,
                           path,
                           {},
                           "not a usable name",
                           "letters A to Z and a to z, digits, _ and -"});
  }
  return good;
}

void Reader::finish() {
  for (const Entry& entry : table_.table()->list) {
    if (std::find(known_.begin(), known_.end(), entry.key) == known_.end()) {
      context_.problems.add(unknown_key(entry, path_, known_, context_.physics));
    }
  }
}

void Reader::operator()(double& member, const Quantity& option) {
  if (const Node* node = find(option.name, option.need, option.help)) {
    member = read_number(*node, key(option.name), option, context_).value_or(member);
  }
}

void Reader::operator()(std::optional<double>& member, const Quantity& option) {
  if (const Node* node = find(option.name, option.need, option.help)) {
    member = read_number(*node, key(option.name), option, context_);
  }
}

void Reader::operator()(std::vector<double>& member, const Quantity& option) {
  const Node* node = find(option.name, option.need, option.help);
  if (node == nullptr) {
    return;
  }
  if (node->array() == nullptr) {
    refuse(*node, option.name, "expects a list of numbers, found " + kind_of(*node),
           "[...], each " + allowed_number(option));
    return;
  }
  for (const Node& entry : *node->array()) {
    if (const auto number = read_number(entry, key(option.name), option, context_)) {
      member.push_back(*number);
    }
  }
}

std::optional<std::array<double, 2>> Reader::read_point(const Quantity& option) {
  const Node* node = find(option.name, option.need, option.help);
  if (node == nullptr) {
    return std::nullopt;
  }
  if (node->array() == nullptr || node->array()->size() != 2) {
    refuse(*node, option.name, "expects a point", "[x, y], each " + allowed_number(option));
    return std::nullopt;
  }
  const auto x = read_number((*node->array())[0], key(option.name), option, context_);
  const auto y = read_number((*node->array())[1], key(option.name), option, context_);
  if (!x || !y) {
    return std::nullopt;
  }
  return std::array<double, 2>{*x, *y};
}

void Reader::operator()(std::array<double, 2>& member, const Quantity& option) {
  member = read_point(option).value_or(member);
}

void Reader::operator()(std::optional<std::array<double, 2>>& member, const Quantity& option) {
  member = read_point(option);
}

void Reader::operator()(std::optional<Schedule>& member, const Quantity& option) {
  if (const Node* node = find(option.name, option.need, option.help)) {
    member = read_schedule(*node, key(option.name), option, context_);
  }
}

void Reader::operator()(PendingList& member, const Quantity& option) {
  member.node = find(option.name, option.need, option.help);
}

std::optional<std::string> Reader::read_text(const Node& node, std::string_view name) {
  if (node.text() == nullptr) {
    refuse(node, name, "expects a text, found " + kind_of(node), "a text in quotes");
    return std::nullopt;
  }
  return *node.text();
}

void Reader::operator()(std::string& member, const Text& option) {
  if (const Node* node = find(option.name, option.need, option.help)) {
    member = read_text(*node, option.name).value_or(member);
  }
}

void Reader::operator()(std::vector<std::string>& member, const Text& option) {
  const Node* node = find(option.name, option.need, option.help);
  if (node == nullptr) {
    return;
  }
  if (node->array() == nullptr) {
    refuse(*node, option.name, "expects a list of texts, found " + kind_of(*node),
           "[\"...\", ...]");
    return;
  }
  for (const Node& entry : *node->array()) {
    if (const auto text = read_text(entry, option.name)) {
      member.push_back(*text);
    }
  }
}

void Reader::operator()(bool& member, const Flag& option) {
  const Node* node = find(option.name, Need::optional, option.help);
  if (node == nullptr) {
    return;
  }
  if (const bool* flag = std::get_if<bool>(&node->value)) {
    member = *flag;
  } else {
    refuse(*node, option.name, "expects true or false, found " + kind_of(*node), "true, false");
  }
}

void Reader::operator()(int& member, const Count& option) {
  const Node* node = find(option.name, option.need, option.help);
  if (node == nullptr) {
    return;
  }
  const std::string allowed =
      option.low == option.high
          ? std::to_string(option.low)
          : fmt::format("a whole number from {} to {}", option.low, option.high);
  const auto* whole = std::get_if<std::int64_t>(&node->value);
  if (whole == nullptr) {
    refuse(*node, option.name, "expects a whole number, found " + kind_of(*node), allowed);
  } else if (*whole < option.low || *whole > option.high) {
    refuse(*node, option.name, "out of range", allowed);
  } else {
    member = static_cast<int>(*whole);
  }
}

}  // namespace percolith::case_file
