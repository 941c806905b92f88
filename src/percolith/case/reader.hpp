// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/number.hpp"
#include "percolith/case/option.hpp"
#include "percolith/case/schedule_table.hpp"
#include "percolith/core/tensor2.hpp"
#include "percolith/time/schedule.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace percolith::case_file {

/// The visitor that fills a struct from a TOML table. What is wrong goes to the context; the
/// members concerned keep their defaults.
class Reader {
public:
  /// Reads from `table`, whose dotted path is `path`.
  Reader(const Node& table, std::string path, Context& context)
      : table_(table), path_(std::move(path)), context_(context) {}

  void operator()(double& member, const Quantity& option);
  void operator()(std::optional<double>& member, const Quantity& option);
  void operator()(std::vector<double>& member, const Quantity& option);
  void operator()(std::array<double, 2>& member, const Quantity& option);
  void operator()(std::optional<std::array<double, 2>>& member, const Quantity& option);
  void operator()(Tensor& member, const Quantity& option);
  void operator()(std::optional<Schedule>& member, const Quantity& option);
  void operator()(PendingList& member, const Quantity& option);
  void operator()(std::string& member, const Text& option);
  void operator()(std::vector<std::string>& member, const Text& option);
  void operator()(bool& member, const Flag& option);
  void operator()(int& member, const Count& option);
  template <class Enumeration>
  void operator()(Enumeration& member, const Choice<Enumeration>& option);
  template <class Struct>
  void operator()(Struct& member, const Table& option);
  template <class Struct>
  void operator()(std::optional<Struct>& member, const Table& option);
  template <class Struct>
  void operator()(std::map<std::string, Struct>& member, const NamedTables& option);

  /// Reports every key that no option has asked for.
  void finish();

private:
  /// The value of an option, or null where it is not given; a missing required one is reported.
  const Node* find(std::string_view name, Need need, std::string_view help);
  /// The table of that name, or null; anything else of that name is reported.
  const Node* find_table(const Node& holder, std::string_view name, const std::string& key);
  void refuse(const Node& node, std::string_view name, std::string reason, std::string allowed);
  void refuse_choice(const Node& node, std::string_view name,
                     const std::vector<std::string_view>& names);
  /// True where the user may give a table this name; reports it otherwise.
  bool check_name(const Entry& entry, const std::string& key);
  std::optional<std::array<double, 2>> read_point(const Quantity& option);
  std::optional<std::string> read_text(const Node& node, std::string_view name);
  [[nodiscard]] std::string key(std::string_view name) const { return join_key(path_, name); }

  const Node& table_;
  std::string path_;
  Context& context_;
  std::vector<std::string_view> known_;
};

/// Reads a schedule: a number, a table of times and values, or a table that names a CSV file.
[[nodiscard]] std::optional<Schedule> read_schedule(const Node& node, const std::string& key,
                                                    const Quantity& option, Context& context);

template <class Enumeration>
void Reader::operator()(Enumeration& member, const Choice<Enumeration>& option) {
  const Node* node = find(option.name, Need::optional, option.help);
  if (node == nullptr) {
    return;
  }
  const bool one_only =
      context_.physics != "seepage" && !context_.physics.empty() && !option.in_mechanics.empty();
  std::vector<std::string_view> names;
  for (const auto& choice : option.names) {
    if (node->text() != nullptr && *node->text() == choice.name) {
      member = choice.value;
      return;
    }
    if (!one_only || choice.name == option.in_mechanics) {
      names.push_back(choice.name);
    }
  }
  refuse_choice(*node, option.name, names);
}

template <class Struct>
void Reader::operator()(Struct& member, const Table& option) {
  known_.push_back(option.name);
  const Node* node = find_table(table_, option.name, key(option.name));
  Node absent{Entries{}, {}, {}};
  absent.key_location = {table_.key_location.file, 0, 0};
  if (node == nullptr && table_.table()->find(option.name) != nullptr) {
    return;
  }
  Reader inner(node != nullptr ? *node : absent, key(option.name), context_);
  describe(inner, member);
  inner.finish();
}

template <class Struct>
void Reader::operator()(std::optional<Struct>& member, const Table& option) {
  known_.push_back(option.name);
  const Node* node = find_table(table_, option.name, key(option.name));
  if (node != nullptr) {
    Reader inner(*node, key(option.name), context_);
    describe(inner, member.emplace());
    inner.finish();
  }
}

template <class Struct>
void Reader::operator()(std::map<std::string, Struct>& member, const NamedTables& option) {
  known_.push_back(option.name);
  const Node* holder = find_table(table_, option.name, key(option.name));
  if (holder == nullptr) {
    return;
  }
  for (const Entry& entry : holder->table()->list) {
    const std::string path = join_key(key(option.name), entry.key);
    if (!check_name(entry, path)) {
      continue;
    }
    const Node* node = find_table(*holder, entry.key, path);
    if (node != nullptr) {
      Reader inner(*node, path, context_);
      describe(inner, member[entry.key]);
      inner.finish();
    }
  }
}

}  // namespace percolith::case_file
