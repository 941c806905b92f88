// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace percolith::test {

/// Reads arrays out of the text of a `.vtu` file, from the format's description alone.
class VtuDecoder {
public:
  explicit VtuDecoder(std::string text) : text_(std::move(text)) {
    const std::string mark = "<AppendedData encoding=\"raw\">";
    xml_end_ = text_.find(mark);
    start_ = text_.find('_', xml_end_ + mark.size()) + 1;
  }

  /// Value of `attribute` in the first element that begins with `element`.
  [[nodiscard]] std::string attribute(const std::string& element, const std::string& name) const {
    const std::size_t begin = text_.find(element);
    if (begin >= xml_end_) {
      throw std::runtime_error("no element " + element);
    }
    const std::size_t end = text_.find('>', begin);
    const std::string key = " " + name + "=\"";
    const std::size_t value = text_.find(key, begin) + key.size();
    if (value - key.size() > end) {
      throw std::runtime_error("no attribute " + name);
    }
    return text_.substr(value, text_.find('"', value) - value);
  }

  /// True where an array of this name stands between `<section>` and `</section>`.
  [[nodiscard]] bool has(const std::string& section, const std::string& name) const {
    const std::size_t begin = text_.find("<" + section + ">");
    const std::size_t at = text_.find(" Name=\"" + name + "\"", begin);
    return at < text_.find("</" + section + ">", begin);
  }

  /// Values of the array `name`, which must be of `type`.
  template <class T>
  [[nodiscard]] std::vector<T> array(const std::string& type, const std::string& name) const {
    const std::string element = "<DataArray type=\"" + type + "\" Name=\"" + name + "\"";
    std::size_t at = start_ + std::stoull(attribute(element, "offset"));
    const std::uint64_t blocks = number(at);
    const std::uint64_t block_size = number(at + 8);
    const std::uint64_t last_size = number(at + 16);
    std::size_t block_at = at + 24 + 8 * blocks;
    std::string bytes;
    for (std::uint64_t i = 0; i < blocks; ++i) {
      const std::uint64_t compressed = number(at + 24 + 8 * i);
      const bool partial = i + 1 == blocks && last_size > 0;
      bytes += inflate(block_at, compressed, partial ? last_size : block_size);
      block_at += compressed;
    }
    std::vector<T> values(bytes.size() / sizeof(T));
    if (!values.empty()) {
      std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    }
    return values;
  }

private:
  [[nodiscard]] std::uint64_t number(std::size_t at) const {
    std::uint64_t value = 0;
    std::memcpy(&value, text_.data() + at, sizeof value);
    return value;
  }
  [[nodiscard]] std::string inflate(std::size_t at, std::uint64_t compressed,
                                    std::uint64_t size) const {
    std::string block(size, '\0');
    uLongf got = size;
    const int status = uncompress(reinterpret_cast<Bytef*>(block.data()), &got,
                                  reinterpret_cast<const Bytef*>(text_.data() + at), compressed);
    if (status != Z_OK || got != size) {
      throw std::runtime_error("damaged block");
    }
    return block;
  }

  std::string text_;
  std::size_t xml_end_ = 0;
  std::size_t start_ = 0;
};

}  // namespace percolith::test
