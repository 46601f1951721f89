#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "sundrape/io/file_error.hpp"
#include "sundrape/io/replace_file.hpp"

namespace sundrape {

/// A file that is there as a whole or not at all.
class OutputFile {
 public:
  /// @throws FileError
  explicit OutputFile(const std::filesystem::path& path)
      : path_(path), replacement_(path), stream_(replacement_.temporary(), std::ios::binary | std::ios::trunc) {
    if (!stream_) throw FileError(fmt::format("{}: cannot be created", path.string()));
  }

  void write(std::string_view bytes) { stream_.write(bytes.data(), static_cast<std::streamsize>(bytes.size())); }
  /// Puts it in its place. @throws FileError  it could not be written, e.g. for lack of space
  void commit() {
    stream_.close();
    if (!stream_) throw FileError(fmt::format("{}: cannot be written: is the disk full?", path_.string()));
    replacement_.commit(ReplaceFile::Durability::process);
  }

 private:
  std::filesystem::path path_;
  ReplaceFile replacement_;
  std::ofstream stream_;
};

/// Appends a number's bytes, in the order that a format asks for.
template <std::endian order, class Number>
requires std::integral<Number> || std::floating_point<Number>
void append_bytes(std::string& bytes, Number number) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if constexpr (order != std::endian::native) std::ranges::reverse(raw);
  bytes.append(raw.data(), raw.size());
}

}  // namespace sundrape
