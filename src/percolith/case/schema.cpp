// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/describe.hpp"
#include "percolith/case/documents.hpp"
#include "percolith/case/schedule_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace percolith::case_file {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* number_pattern = R"(^\s*[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?)";
constexpr const char* name_pattern = "^[A-Za-z0-9_-]+$";

Json json_of(double value) {
  if (std::isinf(value)) {
    return value > 0 ? "inf" : "-inf";
  }
  return value;
}

/// A plain number within the bounds.
Json plain_number(const Bounds& bounds) {
  Json schema{{"type", "number"}};
  if (std::isfinite(bounds.low)) {
    schema[bounds.low_included ? "minimum" : "exclusiveMinimum"] = bounds.low;
  }
  if (std::isfinite(bounds.high)) {
    schema[bounds.high_included ? "maximum" : "exclusiveMaximum"] = bounds.high;
  }
  return schema;
}

/// A number, or a text with its unit; the bounds of a text are for the reader to judge.
Json number_schema(const Quantity& option) {
  const bool plain = option.unit == "1";
  Json any = Json::array();
  any.push_back(plain_number(option.bounds));
  any.push_back(
      {{"type", "string"},
       {"pattern", std::string(number_pattern) + (plain ? R"(\s*\S*)" : R"(\s*[^\s0-9])")}});
  if (option.bounds.high_included && std::isinf(option.bounds.high)) {
    any.push_back({{"enum", {"inf", "+inf"}}});
  }
  if (option.bounds.low_included && std::isinf(option.bounds.low)) {
    any.push_back({{"const", "-inf"}});
  }
  return Json{{"anyOf", std::move(any)}};
}

Json list_of(Json items, int minimum, int maximum) {
  Json schema{{"type", "array"}, {"items", std::move(items)}};
  if (minimum > 0) {
    schema["minItems"] = minimum;
  }
  if (maximum > 0) {
    schema["maxItems"] = maximum;
  }
  return schema;
}

Json empty_table() {
  return Json{{"type", "object"}, {"properties", Json::object()}, {"additionalProperties", false}};
}

/// The visitor that writes the schema of a table.
class SchemaWriter {
public:
  explicit SchemaWriter(Json& table) : table_(table) {}

  void operator()(double& member, const Quantity& option) {
    add(option, number_schema(option), option.absent.empty() ? json_of(member) : Json());
  }
  void operator()(std::optional<double>& /*member*/, const Quantity& option) {
    add(option, number_schema(option), nullptr);
  }
  void operator()(std::vector<double>& /*member*/, const Quantity& option) {
    add(option, list_of(number_schema(option), 0, 0), Json::array());
  }
  void operator()(PendingList& /*member*/, const Quantity& option) {
    add(option, list_of(number_schema(option), 1, 0), nullptr);
  }
  void operator()(std::array<double, 2>& /*member*/, const Quantity& option) {
    add(option, list_of(number_schema(option), 2, 2), nullptr);
  }
  void operator()(std::optional<std::array<double, 2>>& /*member*/, const Quantity& option) {
    add(option, list_of(number_schema(option), 2, 2), nullptr);
  }
  void operator()(Tensor& /*member*/, const Quantity& option) {
    Json any = Json::array();
    any.push_back(number_schema({option.name, option.unit, positive, option.need, {}}));
    any.push_back(list_of(number_schema(option), 3, 3));
    any.push_back(list_of(list_of(number_schema(option), 2, 2), 2, 2));
    add(option, Json{{"anyOf", std::move(any)}}, nullptr);
  }
  void operator()(std::optional<Schedule>& /*member*/, const Quantity& option) {
    ScheduleTable form;
    form.quantity = option;
    Json over_time = empty_table();
    SchemaWriter inner(over_time);
    describe(inner, form);
    Json any = Json::array();
    any.push_back(number_schema(option));
    any.push_back(std::move(over_time));
    add(option, Json{{"anyOf", std::move(any)}}, nullptr);
  }
  void operator()(std::string& member, const Text& option) {
    put(option.name, option.need, option.help, {{"type", "string"}}, member);
  }
  void operator()(std::vector<std::string>& /*member*/, const Text& option) {
    put(option.name, option.need, option.help,
        list_of({{"type", "string"}, {"minLength", 1}}, 1, 0), nullptr);
  }
  void operator()(bool& member, const Flag& option) {
    put(option.name, Need::optional, option.help, {{"type", "boolean"}}, member);
  }
  void operator()(int& member, const Count& option) {
    put(option.name, option.need, option.help,
        {{"type", "integer"}, {"minimum", option.low}, {"maximum", option.high}}, member);
  }
  template <class Enumeration>
  void operator()(Enumeration& member, const Choice<Enumeration>& option) {
    Json names = Json::array();
    Json initial;
    for (const auto& choice : option.names) {
      names.push_back(choice.name);
      if (choice.value == member) {
        initial = choice.name;
      }
    }
    put(option.name, Need::optional, option.help, {{"enum", std::move(names)}}, std::move(initial));
  }
  template <class Struct>
  void operator()(Struct& member, const Table& option) {
    Json inner = table_of(member);
    const Need need = inner.contains("required") ? Need::required : Need::optional;
    put(option.name, need, option.help, inner, nullptr);
  }
  template <class Struct>
  void operator()(std::optional<Struct>& /*member*/, const Table& option) {
    Struct member;
    put(option.name, Need::optional, option.help, table_of(member), nullptr);
  }
  template <class Struct>
  void operator()(std::map<std::string, Struct>& /*member*/, const NamedTables& option) {
    Struct member;
    put(option.name, Need::optional, option.help,
        {{"type", "object"},
         {"propertyNames", {{"pattern", name_pattern}}},
         {"additionalProperties", table_of(member)}},
        nullptr);
  }

private:
  template <class Struct>
  static Json table_of(Struct& member) {
    Json table = empty_table();
    SchemaWriter inner(table);
    describe(inner, member);
    return table;
  }

  void add(const Quantity& option, Json schema, Json initial) {
    schema["x-unit"] = option.unit;
    schema["x-allowed"] = to_text(option.bounds, option.unit);
    std::string help(option.help);
    if (!option.absent.empty()) {
      help += fmt::format(" When absent: {}.", option.absent);
    }
    put(option.name, option.need, help, schema, std::move(initial));
  }

  void put(std::string_view name, Need need, std::string_view help, const Json& schema,
           Json initial) {
    Json property{{"description", help}};
    property.update(schema);
    if (need == Need::required) {
      table_["required"].push_back(name);
    } else if (!initial.is_null()) {
      property["default"] = std::move(initial);
    }
    table_["properties"][std::string(name)] = std::move(property);
  }

  Json& table_;
};

}  // namespace

std::string schema_json() {
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
              {"title", "Percolith case file"}};
  schema.update(empty_table());
  simulation::Setup setup;
  SchemaWriter writer(schema);
  describe(writer, setup);
  return schema.dump(2) + "\n";
}

}  // namespace percolith::case_file
