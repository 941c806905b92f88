// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/documents.hpp"

#include "percolith/case/option_list.hpp"
#include "percolith/case/units.hpp"
#include "percolith/core/error.hpp"

#include "modules.hpp"
#include "source.hpp"

namespace nb = nanobind;

namespace percolith::python {
namespace {

std::string resolved(const runner::CaseSource& source) {
  simulation::Setup setup = runner::read_case(source).setup;
  return case_file::resolved_toml(setup);
}

/// A number with a unit as SI.
double quantity(const std::string& text, const std::string& si_unit) {
  const auto refuse = [&](const std::string& reason) {
    throw InputError({{},
                      "",
                      "",
                      "\"" + text + "\": " + reason,
                      "a number with a unit of " +
                          std::string(case_file::dimension_of(si_unit).name) + ", such as \"" +
                          std::string(case_file::dimension_of(si_unit).example) + "\""});
  };
  const auto number = case_file::split_number(text);
  if (!number) {
    refuse("does not begin with a number");
  }
  if (number->unit.empty()) {
    return number->number;
  }
  if (const std::string wrong = case_file::misread_unit(number->unit); !wrong.empty()) {
    refuse(wrong);
  }
  case_file::Units units;
  const auto converted = units.convert(number->number, number->unit, si_unit);
  if (!converted.value) {
    refuse(converted.reason);
  }
  return *converted.value;
}

}  // namespace

void bind_documents(nb::module_& module) {
  using nb::literals::operator""_a;
  module.def(
      "schema", &case_file::schema_json,
      "The JSON Schema of case files: every option with its help, unit, bounds and default.");
  module.def("option_paths", &case_file::option_paths,
             "The dotted paths of all options; `*` stands for a name the user chooses.");
  module.def("quantity", &quantity, "text"_a, "unit"_a,
             "A number with a unit, such as \"20 GPa\", in the SI unit given. Raises CaseError.");
  module.def(
      "resolved",
      [](const std::string& file, const std::optional<std::string>& text,
         const std::vector<std::string>& overrides) {
        return resolved(make_source(file, text, overrides));
      },
      "file"_a, "text"_a = nb::none(), "overrides"_a = std::vector<std::string>(),
      "The complete input of a case as TOML in SI units, defaults included. Raises CaseError.");
  module.def(
      "case_warnings",
      [](const std::string& file, const std::optional<std::string>& text,
         const std::vector<std::string>& overrides) {
        return runner::read_case(make_source(file, text, overrides)).warnings;
      },
      "file"_a, "text"_a = nb::none(), "overrides"_a = std::vector<std::string>(),
      "Warnings about a case as written, each with its place. Raises CaseError.");
}

}  // namespace percolith::python
