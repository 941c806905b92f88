// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/csv.hpp"
#include "percolith/case/reader.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace percolith::case_file {

namespace {

constexpr const char* increasing_times =
    "times that strictly increase; for a jump, interpolation = \"step\"";

/// Reports what is wrong with the table as a whole.
std::nullopt_t refuse(const Node& node, const std::string& key, Context& context,
                      std::string reason, std::string allowed) {
  report(context, node, key, std::move(reason), std::move(allowed));
  return std::nullopt;
}

/// The numbers of a list; nothing where one of them is wrong.
std::optional<std::vector<double>> read_list(const PendingList& list, const std::string& key,
                                             const Quantity& option, const std::string& unit,
                                             Context& context) {
  if (list.node->array() == nullptr) {
    return refuse(*list.node, key, context,
                  "expects a list of numbers, found " + kind_of(*list.node),
                  "[...], each " + allowed_number(option));
  }
  std::vector<double> numbers;
  for (const Node& entry : *list.node->array()) {
    if (const auto number = read_number(entry, key, option, context, unit)) {
      numbers.push_back(*number);
    }
  }
  if (numbers.size() != list.node->array()->size()) {
    return std::nullopt;
  }
  return numbers;
}

/// The column that `name` names or, in a table of two columns, the one at `position`.
std::optional<std::size_t> find_column(const CsvTable& table, const std::string& name,
                                       std::size_t position) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), name);
  if (found != table.columns.end()) {
    return static_cast<std::size_t>(found - table.columns.begin());
  }
  if (name.empty() && table.columns.size() == 2) {
    return position;
  }
  return std::nullopt;
}

/// Reads one column of a CSV file; cells are numbers, or numbers with a unit.
class ColumnReader {
public:
  ColumnReader(const CsvTable& table, std::string file, std::string key, Context& context)
      : table_(table), file_(std::move(file)), key_(std::move(key)), context_(context) {}

  std::optional<std::vector<double>> read(std::size_t column, const Quantity& option,
                                          const std::string& unit) {
    std::vector<double> numbers;
    for (const CsvTable::Row& row : table_.rows) {
      const Node cell = node_of(row.cells[column], row.line);
      const auto number = read_number(cell, key_, option, context_, unit);
      if (!number) {
        return std::nullopt;
      }
      numbers.push_back(*number);
    }
    return numbers;
  }

  /// A cell as the case file would hold it: a plain number is a number, not a text.
  [[nodiscard]] Node node_of(const std::string& text, int line) const {
    Node node;
    node.location = {file_, line, 0};
    node.key_location = node.location;
    const auto split = split_number(text);
    if (split && split->unit.empty()) {
      node.value = split->number;
    } else {
      node.value = text;
    }
    return node;
  }

private:
  const CsvTable& table_;
  std::string file_;
  std::string key_;
  Context& context_;
};

/// The first entry whose time is not later than that of the one before; the size where none is.
std::size_t first_disorder(const std::vector<double>& times) {
  const auto at = std::adjacent_find(times.begin(), times.end(),
                                     [](double before, double after) { return !(before < after); });
  return at == times.end() ? times.size() : static_cast<std::size_t>(at - times.begin()) + 1;
}

std::optional<Schedule> read_inline(const Node& node, const std::string& key,
                                    const ScheduleTable& table, Context& context) {
  Quantity times_option{"times", "s", finite, Need::optional, {}};
  const auto times = read_list(table.times, key + ".times", times_option, table.time_unit, context);
  const auto values =
      read_list(table.values, key + ".values", table.quantity, table.value_unit, context);
  if (!times || !values) {
    return std::nullopt;
  }
  if (times->empty() || times->size() != values->size()) {
    return refuse(node, key, context,
                  fmt::format("{} times and {} values", times->size(), values->size()),
                  "as many values as times, at least one");
  }
  const std::size_t disorder = first_disorder(*times);
  if (disorder < times->size()) {
    return refuse((*table.times.node->array())[disorder], key + ".times", context,
                  "times do not increase", increasing_times);
  }
  return Schedule{*times, *values, table.interpolation};
}

/// Reports that the option `name` names no column, or that it is not given where it must be.
void refuse_column(const Node& node, const std::string& key, const std::string& name,
                   const std::string& file, const CsvTable& table, Context& context) {
  const Node* column = node.table()->find(name);
  report(context, column != nullptr ? *column : node, join_key(key, name),
         column != nullptr ? file + " has no such column"
                           : file + " does not have two columns, so the one to use must be named",
         listed({table.columns.begin(), table.columns.end()}));
}

std::optional<Schedule> read_file(const Node& node, const std::string& key,
                                  const ScheduleTable& table, Context& context) {
  const std::filesystem::path path = context.directory / table.file;
  CsvTable csv;
  try {
    csv = read_csv(path);
  } catch (const InputError& error) {
    InputProblem problem = error.problem();
    problem.key = key + ".file";
    if (problem.location.line == 0) {
      problem.reason = fmt::format("{}: {}", path.string(), problem.reason);
      problem.location = node.table()->find("file")->location;
      problem.value = to_toml(table.file);
    }
    context.problems.add(std::move(problem));
    return std::nullopt;
  }
  const auto time_column = find_column(csv, table.time_column, 0);
  const auto value_column = find_column(csv, table.value_column, 1);
  if (!time_column || !value_column) {
    refuse_column(node, key, time_column ? "value_column" : "time_column", path.string(), csv,
                  context);
    return std::nullopt;
  }
  ColumnReader reader(csv, path.string(), key, context);
  const auto times =
      reader.read(*time_column, {"times", "s", finite, Need::optional, {}}, table.time_unit);
  const auto values = reader.read(*value_column, table.quantity, table.value_unit);
  if (!times || !values) {
    return std::nullopt;
  }
  const std::size_t disorder = first_disorder(*times);
  if (disorder < times->size()) {
    const CsvTable::Row& row = csv.rows[disorder];
    return refuse(reader.node_of(row.cells[*time_column], row.line), key, context,
                  "times do not increase", increasing_times);
  }
  return Schedule{*times, *values, table.interpolation};
}

/// Whether the table is one of the two forms, and no mixture.
bool check_form(const Node& node, const std::string& key, const ScheduleTable& table,
                Context& context) {
  const bool lists = table.times.node != nullptr || table.values.node != nullptr;
  const bool both_lists = table.times.node != nullptr && table.values.node != nullptr;
  const bool file = !table.file.empty();
  const bool columns = !table.time_column.empty() || !table.value_column.empty();
  if (file ? lists : (!both_lists || columns)) {
    report(context, node, key, "expects a table of times and values, or of a CSV file",
           "{ times = [...], values = [...] } or { file = \"...\", time_column = \"...\", "
           "value_column = \"...\" }");
    return false;
  }
  return true;
}

/// Reports a unit that cannot be that of the quantity, once, instead of at every entry.
bool check_unit(const Node& node, const std::string& key, const std::string& name,
                const std::string& unit, const Quantity& quantity, Context& context) {
  if (unit.empty()) {
    return true;
  }
  const Units::Converted converted =
      context.units.convert(1.0, unit, quantity.unit, quantity.dimension);
  if (!converted.value) {
    const Dimension dimension = dimension_of(quantity.unit, quantity.dimension);
    report(context, *node.table()->find(name), join_key(key, name), converted.reason,
           fmt::format("a unit of {}, such as that of \"{}\"", dimension.name, dimension.example));
  }
  return converted.value.has_value();
}

}  // namespace

std::optional<Schedule> read_schedule(const Node& node, const std::string& key,
                                      const Quantity& option, Context& context) {
  if (node.array() != nullptr) {
    return refuse(node, key, context, "expects a number or a table, found a list",
                  allowed_number(option) + ", or { times = [...], values = [...] }");
  }
  if (node.table() == nullptr) {
    const auto number = read_number(node, key, option, context);
    return number ? std::optional(Schedule::constant(*number)) : std::nullopt;
  }
  constexpr Quantity times{"times", "s", finite, Need::optional, {}};
  ScheduleTable table;
  table.quantity = option;
  Reader reader(node, key, context);
  describe(reader, table);
  reader.finish();
  if (context.problems.touch(key) || !check_form(node, key, table, context) ||
      !check_unit(node, key, "time_unit", table.time_unit, times, context) ||
      !check_unit(node, key, "value_unit", table.value_unit, option, context)) {
    return std::nullopt;
  }
  return table.file.empty() ? read_inline(node, key, table, context)
                            : read_file(node, key, table, context);
}

}  // namespace percolith::case_file
