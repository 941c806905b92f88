// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/node.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace percolith::case_file {

namespace {

constexpr std::size_t longest_text = 60;

/// Appends the value in one line; stops adding parts once the text is longer than it may be.
void append(std::string& text, const Node& node) {
  if (const auto* flag = std::get_if<bool>(&node.value)) {
    text += *flag ? "true" : "false";
  } else if (const auto* whole = std::get_if<std::int64_t>(&node.value)) {
    text += std::to_string(*whole);
  } else if (const auto* number = std::get_if<double>(&node.value)) {
    text += fmt::format("{}", *number);
  } else if (const std::string* words = node.text()) {
    text += to_toml(*words);
  } else if (const Array* list = node.array()) {
    text += "[";
    for (std::size_t i = 0; i < list->size() && text.size() <= longest_text; ++i) {
      text += i == 0 ? "" : ", ";
      append(text, (*list)[i]);
    }
    text += "]";
  } else if (const Entries* entries = node.table()) {
    text += "{";
    for (const Entry& entry : entries->list) {
      if (text.size() > longest_text) {
        break;
      }
      text += text.back() == '{' ? " " : ", ";
      text += entry.key + " = ";
      append(text, entry.value);
    }
    text += " }";
  } else {
    text += "a date";
  }
}

bool is_continuation(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

auto position(auto& list, std::string_view key) {
  return std::lower_bound(
      list.begin(), list.end(), key,
      [](const Entry& entry, std::string_view k) { return entry.key.compare(k) < 0; });
}

}  // namespace

Node* Entries::find(std::string_view key) {
  const auto at = position(list, key);
  return at != list.end() && at->key == key ? &at->value : nullptr;
}

const Node* Entries::find(std::string_view key) const {
  const auto at = position(list, key);
  return at != list.end() && at->key == key ? &at->value : nullptr;
}

Node& Entries::set(std::string key, Node value) {
  auto at = position(list, key);
  if (at != list.end() && at->key == key) {
    at->value = std::move(value);
  } else {
    at = list.insert(at, Entry{std::move(key), std::move(value)});
  }
  return at->value;
}

void Entries::erase(std::string_view key) {
  const auto at = position(list, key);
  if (at != list.end() && at->key == key) {
    list.erase(at);
  }
}

std::string to_text(const Node& node) {
  std::string text;
  append(text, node);
  if (text.size() > longest_text) {
    std::size_t end = longest_text;
    while (end > 0 && is_continuation(text[end])) {
      --end;
    }
    text.resize(end);
    text += "...";
  }
  return text;
}

std::string kind_of(const Node& node) {
  static constexpr const char* names[] = {"true or false", "a number", "a number", "a text",
                                          "a date",        "a list",   "a table"};
  return names[node.value.index()];
}

std::string to_toml(double value) {
  std::string text = fmt::format("{}", value);
  if (std::isfinite(value) && text.find_first_of(".e") == std::string::npos) {
    text += ".0";
  }
  std::array<char, 32> scientific{};
  const auto [end, failure] =
      std::to_chars(scientific.begin(), scientific.end(), value, std::chars_format::scientific);
  const auto size = static_cast<std::size_t>(end - scientific.begin());
  return failure == std::errc{} && size < text.size() ? std::string(scientific.data(), size) : text;
}

std::string to_toml(std::string_view text) {
  std::string result = "\"";
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (letter == '"' || letter == '\\') {
      result += '\\';
      result += letter;
    } else if (letter == '\n') {
      result += "\\n";
    } else if (letter == '\t') {
      result += "\\t";
    } else if (code < 0x20U || code == 0x7FU) {
      result += fmt::format("\\u{:04X}", code);
    } else {
      result += letter;
    }
  }
  return result + "\"";
}

}  // namespace percolith::case_file
