// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/compensated.hpp"
#include "percolith/core/vec2.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

// The state of a run as bytes. A struct is described once, by a function
//   void describe_state(StateArchive& archive, Struct& value)
// next to it (or a member `describe_state(StateArchive&)` where its members are private) that names
// every member which later steps depend on. Writing and reading both walk through it.
namespace percolith {

/// What a description is handed: either takes the values it names, or gives them. Names stand in
/// the bytes, so that a description that has changed is noticed where it changed; within the
/// elements of an array they are left out.
class StateArchive {
public:
  virtual ~StateArchive() = default;

  /// True where values are overwritten by those of the archive.
  [[nodiscard]] virtual bool reads() const = 0;

  /// A value. An array keeps its size: what is read must have the size that the model has. Texts
  /// and maps have the size they were written with. A reading archive throws FileError where the
  /// bytes hold something else.
  template <class T>
  void operator()(std::string_view name, T& value) {
    begin(name);
    walk(value);
    end();
  }

  /// An array that is read with the size it was written with.
  template <class T>
  void of_any_size(std::string_view name, std::vector<T>& values) {
    begin(name);
    const std::uint64_t size = size_of(values.size());
    if (reads()) {
      values.resize(size);
    }
    walk_elements(values.data(), values.size());
    end();
  }

protected:
  /// Takes or gives `size` bytes.
  virtual void bytes(void* data, std::size_t size) = 0;
  virtual void begin(std::string_view name) = 0;
  virtual void end() = 0;
  /// Takes the number of elements or gives the one that was written.
  virtual std::uint64_t size_of(std::uint64_t present) = 0;
  /// The same for an array whose size must be the present one.
  virtual void require_size(std::uint64_t present) = 0;
  /// Elements of an array have no names.
  virtual void begin_elements() = 0;
  virtual void end_elements() = 0;

private:
  template <class T>
  static constexpr bool is_plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

  template <class T>
  void walk_elements(T* first, std::size_t count) {
    if constexpr (is_plain<T>) {
      bytes(first, count * sizeof(T));
    } else {
      begin_elements();
      for (std::size_t i = 0; i < count; ++i) {
        walk(first[i]);
      }
      end_elements();
    }
  }

  template <class T>
  void walk(T& value) {
    if constexpr (is_plain<T>) {
      bytes(&value, sizeof(T));
    } else if constexpr (requires { value.describe_state(*this); }) {
      value.describe_state(*this);
    } else {
      describe_state(*this, value);
    }
  }
  void walk(std::string& text) {
    text.resize(size_of(text.size()));
    bytes(text.data(), text.size());
  }
  template <class T>
  void walk(std::vector<T>& values) {
    require_size(values.size());
    walk_elements(values.data(), values.size());
  }
  template <class T, std::size_t N>
  void walk(std::array<T, N>& values) {
    walk_elements(values.data(), N);
  }
  template <class T>
  void walk(std::optional<T>& value) {
    if (size_of(value.has_value() ? 1 : 0) == 0) {
      value.reset();
      return;
    }
    if (!value) {
      value.emplace();
    }
    walk(*value);
  }
  template <class First, class Second>
  void walk(std::pair<First, Second>& value) {
    walk(value.first);
    walk(value.second);
  }
  template <class Key, class Value>
  void walk(std::map<Key, Value>& values) {
    std::vector<std::pair<Key, Value>> list;
    if (!reads()) {
      list.assign(values.begin(), values.end());
    }
    list.resize(size_of(list.size()));
    walk_elements(list.data(), list.size());
    if (reads()) {
      values = {list.begin(), list.end()};
    }
  }
};

inline void describe_state(StateArchive& archive, CompensatedSum& sum) {
  archive("value", sum.value);
  archive("carry", sum.carry);
}

inline void describe_state(StateArchive& archive, Point& point) {
  archive("x", point.x);
  archive("y", point.y);
}

/// Writes a state; nothing is changed by it.
class StateWriter : public StateArchive {
public:
  using Sink = std::function<void(std::string_view)>;
  /// `sink` takes the bytes in order; what it throws passes through.
  explicit StateWriter(Sink sink) : sink_(std::move(sink)) {}
  [[nodiscard]] bool reads() const override { return false; }

protected:
  void bytes(void* data, std::size_t size) override;
  void begin(std::string_view name) override;
  void end() override {}
  std::uint64_t size_of(std::uint64_t present) override;
  void require_size(std::uint64_t present) override { size_of(present); }
  void begin_elements() override { ++depth_; }
  void end_elements() override { --depth_; }

private:
  Sink sink_;
  int depth_ = 0;  // of arrays
};

/// Reads a state back.
class StateReader : public StateArchive {
public:
  /// `bytes` must outlive the reader; `origin` names the file in messages.
  StateReader(std::string_view bytes, std::string origin)
      : rest_(bytes), origin_(std::move(origin)) {}
  [[nodiscard]] bool reads() const override { return true; }
  /// What has not been read yet.
  [[nodiscard]] std::string_view rest() const { return rest_; }

protected:
  void bytes(void* data, std::size_t size) override;
  void begin(std::string_view name) override;
  void end() override { path_.pop_back(); }
  std::uint64_t size_of(std::uint64_t present) override;
  void require_size(std::uint64_t present) override;
  void begin_elements() override { ++depth_; }
  void end_elements() override { --depth_; }

private:
  [[noreturn]] void fail(const std::string& reason) const;
  std::uint64_t next_size();

  std::string_view rest_;
  std::string origin_;
  std::vector<std::string> path_;  // of the value that is read
  int depth_ = 0;                  // of arrays
};

}  // namespace percolith
