// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/reader.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace percolith::case_file {

namespace {

/// The entries of a tensor in the order of the file: [kxx, kyy, kxy] or [[kxx, kxy], [kyx, kyy]].
std::vector<const Node*> tensor_entries(const Array& list) {
  std::vector<const Node*> entries;
  for (const Node& entry : list) {
    if (const Array* row = entry.array()) {
      for (const Node& inner : *row) {
        entries.push_back(&inner);
      }
    } else {
      entries.push_back(&entry);
    }
  }
  return entries;
}

bool is_matrix(const Array& list) {
  return list.size() == 2 && list[0].array() != nullptr && list[1].array() != nullptr &&
         list[0].array()->size() == 2 && list[1].array()->size() == 2;
}

bool is_flat(const Array& list) {
  return list.size() == 3 && std::none_of(list.begin(), list.end(), [](const Node& entry) {
           return entry.array() != nullptr;
         });
}

}  // namespace

void Reader::operator()(Tensor& member, const Quantity& option) {
  const Node* node = find(option.name, option.need, option.help);
  if (node == nullptr) {
    return;
  }
  const std::string path = key(option.name);
  if (node->array() == nullptr) {
    if (const auto number = read_number(*node, path, option, context_)) {
      member = {*number, *number, 0.0};
    }
    return;
  }
  const bool matrix = is_matrix(*node->array());
  if (!matrix && !is_flat(*node->array())) {
    refuse(*node, option.name, "expects a symmetric tensor",
           "one value, [kxx, kyy, kxy] or [[kxx, kxy], [kxy, kyy]]");
    return;
  }
  std::vector<double> values;
  for (const Node* entry : tensor_entries(*node->array())) {
    if (const auto number = read_number(*entry, path, option, context_)) {
      values.push_back(*number);
    }
  }
  if (values.size() == 3) {
    member = {values[0], values[1], values[2]};
  } else if (values.size() == 4 && values[1] != values[2]) {
    refuse(*node, option.name,
           fmt::format("the tensor is not symmetric: kxy = {}, kyx = {}", values[1], values[2]),
           "[[kxx, kxy], [kxy, kyy]]");
  } else if (values.size() == 4) {
    member = {values[0], values[3], values[1]};
  }
}

}  // namespace percolith::case_file
