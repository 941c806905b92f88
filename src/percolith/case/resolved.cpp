// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/applies.hpp"
#include "percolith/case/describe.hpp"
#include "percolith/case/documents.hpp"
#include "percolith/case/node.hpp"

#include <fmt/format.h>

namespace percolith::case_file {

namespace {

using Numbers = std::span<const double>;

std::string list_of(Numbers numbers) {
  std::string text;
  for (const double number : numbers) {
    text += text.empty() ? "" : ", ";
    text += to_toml(number);
  }
  return "[" + text + "]";
}

std::string list_of(const std::vector<std::string>& texts) {
  std::string text;
  for (const std::string& entry : texts) {
    text += text.empty() ? "" : ", ";
    text += to_toml(entry);
  }
  return "[" + text + "]";
}

std::string value_of(const Schedule& schedule) {
  if (schedule == Schedule::constant(schedule.value.front())) {
    return to_toml(schedule.value.front());
  }
  return fmt::format("{{ times = {}, values = {}, interpolation = \"{}\" }}",
                     list_of(schedule.time), list_of(schedule.value),
                     schedule.interpolation == Interpolation::linear ? "linear" : "step");
}

std::string value_of(const Tensor& tensor) {
  if (tensor.xx == tensor.yy && tensor.xy == 0.0) {
    return to_toml(tensor.xx);
  }
  const std::array<double, 3> entries{tensor.xx, tensor.yy, tensor.xy};
  return list_of(entries);
}

std::string value_of(double number) {
  return to_toml(number);
}
std::string value_of(const std::vector<double>& numbers) {
  return list_of(numbers);
}
std::string value_of(const std::array<double, 2>& point) {
  return list_of(point);
}

/// The visitor that writes every option as a line.
class ResolvedWriter {
public:
  ResolvedWriter(std::string path, const simulation::Setup& setup, std::string& text)
      : path_(std::move(path)), setup_(setup), text_(text) {}

  template <class Member>
  void operator()(Member& member, const Quantity& option) {
    write(option.name, value_of(member), option.unit);
  }
  template <class Member>
  void operator()(std::optional<Member>& member, const Quantity& option) {
    if (member) {
      write(option.name, value_of(*member), option.unit);
    } else {
      text_ += fmt::format("# {} is not given: {}\n", option.name, option.absent);
    }
  }
  void operator()(std::string& member, const Text& option) {
    write(option.name, to_toml(member), "1");
  }
  void operator()(std::vector<std::string>& member, const Text& option) {
    if (member.empty() && option.need == Need::optional) {
      text_ += fmt::format("# {} is not given\n", option.name);
    } else {
      write(option.name, list_of(member), "1");
    }
  }
  void operator()(bool& member, const Flag& option) {
    write(option.name, member ? "true" : "false", "1");
  }
  void operator()(int& member, const Count& option) {
    write(option.name, std::to_string(member), "1");
  }
  template <class Enumeration>
  void operator()(Enumeration& member, const Choice<Enumeration>& option) {
    for (const auto& choice : option.names) {
      if (choice.value == member) {
        write(option.name, quoted(choice.name), "1");
      }
    }
  }
  template <class Struct>
  void operator()(Struct& member, const Table& option) {
    write_table(join_key(path_, option.name), member);
  }
  template <class Struct>
  void operator()(std::optional<Struct>& member, const Table& option) {
    const std::string path = join_key(path_, option.name);
    if (member) {
      write_table(path, *member);
    } else if (!write_unused(path)) {
      text_ += fmt::format("\n# [{}] is not given\n", path);
    }
  }
  template <class Struct>
  void operator()(std::map<std::string, Struct>& member, const NamedTables& option) {
    for (auto& [name, value] : member) {
      write_table(join_key(join_key(path_, option.name), name), value);
    }
  }

private:
  template <class Struct>
  void write_table(const std::string& path, Struct& member) {
    if (write_unused(path)) {
      return;
    }
    text_ += fmt::format("\n[{}]\n", path);
    ResolvedWriter inner(path, setup_, text_);
    describe(inner, member);
  }

  /// Says that a table has no effect; false where it has one.
  bool write_unused(const std::string& path) {
    const std::string unused = why_unused(path, setup_);
    if (!unused.empty()) {
      text_ += fmt::format("\n# [{}] has no effect: it needs {}\n", path, unused);
    }
    return !unused.empty();
  }

  void write(std::string_view name, const std::string& value, std::string_view unit) {
    const std::string unused = why_unused(join_key(path_, name), setup_);
    if (!unused.empty()) {
      text_ += fmt::format("# {} has no effect: it needs {}\n", name, unused);
      return;
    }
    text_ += fmt::format("{} = {}", name, value);
    text_ += unit == "1" ? "\n" : fmt::format("  # {}\n", unit);
  }

  std::string path_;
  const simulation::Setup& setup_;
  std::string& text_;
};

/// A comment must not break into the next line.
std::string in_one_line(std::string text) {
  for (char& letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (code < 0x20U || code == 0x7FU) {
      letter = ' ';
    }
  }
  return text;
}

}  // namespace

std::string resolved_toml(const simulation::Setup& setup, std::span<const DerivedValue> derived) {
  std::string text = "# Every option of the case, in SI units. This file can be run again.\n";
  simulation::Setup copy = setup;
  ResolvedWriter writer({}, setup, text);
  describe(writer, copy);
  if (!derived.empty()) {
    text += "\n# Derived values\n";
  }
  for (const DerivedValue& value : derived) {
    text += in_one_line(fmt::format("# {} = {}{}{}", value.name, value.value,
                                    value.unit.empty() ? "" : " ", value.unit)) +
            "\n";
  }
  return text;
}

}  // namespace percolith::case_file
