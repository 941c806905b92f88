// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/option_list.hpp"

#include "percolith/case/describe.hpp"

#include <map>
#include <optional>

namespace percolith::case_file {

namespace {

struct ListedOption {
  std::string path;
  std::string help;
};

/// The visitor that notes the path and the help of every option.
class OptionLister {
public:
  OptionLister(std::string path, std::vector<ListedOption>& options)
      : path_(std::move(path)), options_(options) {}

  template <class Member, class Option>
  void operator()(Member& /*member*/, const Option& option) {
    options_.push_back({join_key(path_, option.name), std::string(option.help)});
  }
  template <class Struct>
  void operator()(Struct& member, const Table& option) {
    list(join_key(path_, option.name), member);
  }
  template <class Struct>
  void operator()(std::optional<Struct>& /*member*/, const Table& option) {
    Struct member;
    list(join_key(path_, option.name), member);
  }
  template <class Struct>
  void operator()(std::map<std::string, Struct>& /*member*/, const NamedTables& option) {
    Struct member;
    list(join_key(path_, option.name) + ".*", member);
  }

private:
  template <class Struct>
  void list(const std::string& path, Struct& member) {
    OptionLister inner(path, options_);
    describe(inner, member);
  }

  std::string path_;
  std::vector<ListedOption>& options_;
};

std::vector<ListedOption> all_options() {
  std::vector<ListedOption> options;
  simulation::Setup setup;
  OptionLister lister({}, options);
  describe(lister, setup);
  return options;
}

}  // namespace

std::vector<std::string> option_paths() {
  std::vector<std::string> paths;
  for (ListedOption& option : all_options()) {
    paths.push_back(std::move(option.path));
  }
  return paths;
}

std::string help_of(const std::string& path) {
  for (ListedOption& option : all_options()) {
    if (option.path == path) {
      return std::move(option.help);
    }
  }
  return {};
}

}  // namespace percolith::case_file
