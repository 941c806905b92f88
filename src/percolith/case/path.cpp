// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/path.hpp"

#include "percolith/case/option.hpp"

#include <algorithm>

namespace percolith::case_file {

Path split_path(std::string_view text) {
  Path path;
  std::size_t first = 0;
  for (std::size_t dot = text.find('.'); dot != std::string_view::npos;
       dot = text.find('.', first)) {
    path.emplace_back(text.substr(first, dot - first));
    first = dot + 1;
  }
  path.emplace_back(text.substr(first));
  return path;
}

bool is_plain_name(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
}

bool is_plain_path(const Path& path) {
  return std::all_of(path.begin(), path.end(), is_plain_name);
}

std::string trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) {
    return {};
  }
  return std::string(text.substr(first, text.find_last_not_of(blank) - first + 1));
}

const Node* find_at(const Node& root, const Path& path) {
  const Node* node = &root;
  for (const std::string& name : path) {
    if (node == nullptr || node->table() == nullptr) {
      return nullptr;
    }
    node = node->table()->find(name);
  }
  return node;
}

std::string first_non_table(const Node& root, const Path& path) {
  const Node* node = &root;
  std::string dotted;
  for (const std::string& name : path) {
    if (node->table() == nullptr) {
      return dotted;
    }
    dotted = join_key(dotted, name);
    node = node->table()->find(name);
    if (node == nullptr) {
      break;
    }
  }
  return {};
}

void set_at(Node& root, const Path& path, Node value) {
  Node* node = &root;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    Node* inner = node->table()->find(path[i]);
    if (inner == nullptr) {
      inner = &node->table()->set(path[i], Node{Entries{}, value.location, value.key_location});
    }
    node = inner;
  }
  node->table()->set(path.back(), std::move(value));
}

void erase_at(Node& root, const Path& path) {
  Node* node = &root;
  for (std::size_t i = 0; i + 1 < path.size() && node != nullptr; ++i) {
    node = node->table() != nullptr ? node->table()->find(path[i]) : nullptr;
  }
  if (node != nullptr && node->table() != nullptr) {
    node->table()->erase(path.back());
  }
}

}  // namespace percolith::case_file
