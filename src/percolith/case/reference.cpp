// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/applies.hpp"
#include "percolith/case/describe.hpp"
#include "percolith/case/documents.hpp"
#include "percolith/case/node.hpp"
#include "percolith/case/schedule_table.hpp"

#include <fmt/format.h>

namespace percolith::case_file {

namespace {

constexpr std::string_view introduction =
    R"(# Options of a case file

All options that a case file may hold, written by the program from their declarations. How to write a
case is told in [case-file.md](case-file.md). A *quantity* is a number in the SI unit shown, or a text
with any unit of the same dimension, such as `"55 GPa"`. A *quantity over time* is a quantity that
stays the same, or a [table](#values-over-time). `NAME` is a name you choose, of letters, digits, `_`
and `-`.
)";

constexpr std::string_view table_head = "\n| option | kind | allowed | default | meaning |\n"
                                        "|---|---|---|---|---|\n";

/// The visitor that writes a row for each option, and a section for each table after its rows.
class ReferenceWriter {
public:
  ReferenceWriter(std::string path, std::string& rows, std::string& sections)
      : path_(std::move(path)), rows_(rows), sections_(sections) {}

  void operator()(double& member, const Quantity& option) {
    number(option, "quantity",
           option.absent.empty() ? to_toml(member) : std::string(option.absent));
  }
  void operator()(std::optional<double>& /*member*/, const Quantity& option) {
    number(option, "quantity", option.absent);
  }
  void operator()(std::vector<double>& /*member*/, const Quantity& option) {
    number(option, "list of quantities", "none");
  }
  void operator()(PendingList& /*member*/, const Quantity& option) {
    number(option, "list of quantities", "none");
  }
  void operator()(std::array<double, 2>& /*member*/, const Quantity& option) {
    number(option, "point [x, y]", option.absent);
  }
  void operator()(std::optional<std::array<double, 2>>& /*member*/, const Quantity& option) {
    number(option, "point [x, y]", option.absent);
  }
  void operator()(Tensor& /*member*/, const Quantity& option) {
    row(option.name, fmt::format("quantity or tensor, {}", option.unit), "positive definite",
        initial(option.need, option.absent), option.help);
  }
  void operator()(std::optional<Schedule>& /*member*/, const Quantity& option) {
    number(option, "quantity over time", option.absent);
  }
  void operator()(std::string& member, const Text& option) {
    row(option.name, "text", "", initial(option.need, member.empty() ? "none" : member),
        option.help);
  }
  void operator()(std::vector<std::string>& /*member*/, const Text& option) {
    row(option.name, "list of texts", "at least one", initial(option.need, "none"), option.help);
  }
  void operator()(bool& member, const Flag& option) {
    row(option.name, "flag", "`true`, `false`", member ? "`true`" : "`false`", option.help);
  }
  void operator()(int& member, const Count& option) {
    row(option.name, "whole number",
        option.low == option.high ? std::to_string(option.low)
                                  : fmt::format("{} to {}", option.low, option.high),
        initial(option.need, std::to_string(member)), option.help);
  }
  template <class Enumeration>
  void operator()(Enumeration& member, const Choice<Enumeration>& option) {
    std::string names;
    std::string chosen;
    for (const auto& choice : option.names) {
      names += fmt::format("{}`\"{}\"`", names.empty() ? "" : ", ", choice.name);
      if (choice.value == member) {
        chosen = fmt::format("`\"{}\"`", choice.name);
      }
    }
    if (!option.in_mechanics.empty()) {
      const std::string only = fmt::format("; in mechanics `\"{}\"`", option.in_mechanics);
      names += only;
      chosen += only;
    }
    row(option.name, "choice", names, chosen, option.help);
  }
  template <class Struct>
  void operator()(Struct& member, const Table& option) {
    section(join_key(path_, option.name), option.help, member);
  }
  template <class Struct>
  void operator()(std::optional<Struct>& /*member*/, const Table& option) {
    Struct member;
    section(join_key(path_, option.name), option.help, member);
  }
  template <class Struct>
  void operator()(std::map<std::string, Struct>& /*member*/, const NamedTables& option) {
    Struct member;
    section(join_key(join_key(path_, option.name), "NAME"), option.help, member);
  }

private:
  template <class Struct>
  void section(const std::string& path, std::string_view help, Struct& member) {
    std::string rows;
    ReferenceWriter inner(path, rows, sections_);
    describe(inner, member);
    sections_ +=
        fmt::format("\n## `[{}]`\n\n{}{}\n{}{}", path, help, physics_note(path), table_head, rows);
  }

  /// The physics that an option or a table belongs to, where it does not belong to all. The two
  /// halves of coupled physics are told by their names alone.
  static std::string physics_note(const std::string& path) {
    const std::size_t name = path.find("NAME");
    const std::string pattern =
        name == std::string::npos
            ? path
            : fmt::format("{}*{}", path.substr(0, name), path.substr(name + 4));
    const std::vector<std::string_view> physics = physics_of(pattern);
    return physics.size() == 3 ? "" : fmt::format(" *In {} only.*", fmt::join(physics, " and "));
  }

  static std::string initial(Need need, std::string_view text) {
    return need == Need::required ? "**required**" : std::string(text);
  }

  void number(const Quantity& option, std::string_view kind, std::string_view text) {
    const std::string unit = option.unit == "1" ? "" : fmt::format(", {}", option.unit);
    row(option.name, fmt::format("{}{}", kind, unit), to_text(option.bounds, option.unit),
        initial(option.need, text), option.help);
  }

  void row(std::string_view name, std::string_view kind, std::string_view allowed,
           std::string_view text, std::string_view help) {
    rows_ += fmt::format("| `{}` | {} | {} | {} | {}{} |\n", name, kind, allowed, text, help,
                         physics_note(join_key(path_, name)));
  }

  std::string path_;
  std::string& rows_;
  std::string& sections_;
};

std::string schedule_section() {
  ScheduleTable form;
  form.quantity = {"values", "SI unit of the option", finite, Need::optional, {}};
  std::string rows;
  std::string sections;
  ReferenceWriter writer({}, rows, sections);
  describe(writer, form);
  return fmt::format("\n## Values over time\n\nIn place of a constant, an option of kind *quantity "
                     "over time* takes a table of `times` and `values`, or one that names the "
                     "columns of a CSV file.\n{}{}",
                     table_head, rows);
}

}  // namespace

std::string reference_markdown() {
  std::string rows;
  std::string sections;
  simulation::Setup setup;
  ReferenceWriter writer({}, rows, sections);
  describe(writer, setup);
  return fmt::format("{}\n## Top of the file\n{}{}{}{}", introduction, table_head, rows, sections,
                     schedule_section());
}

}  // namespace percolith::case_file
