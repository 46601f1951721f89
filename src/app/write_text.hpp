#pragma once
#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>

#include "sundrape/io/file_error.hpp"

namespace sundrape {

/// A text file anew. @throws FileError  it cannot be written
inline void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file);
  out << text;
  if (!out.flush()) throw FileError(fmt::format("{}: cannot be written", file.string()));
}

}  // namespace sundrape
