#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "sundrape/export/writers.hpp"

namespace sundrape {

/// What the command line asks of an export.
struct ExportOptions {
  std::filesystem::path result, output;  // the output's ending says the format
  std::string frames;                    // as select_frames reads it; empty: all
  bool obstacles = true;
};

/// Endings that exports know, as ".glb".
[[nodiscard]] std::vector<std::string> export_formats();

/// Writes a result in the format of another program; the files that it wrote.
/// @throws std::invalid_argument  an ending without a format, or a range that picks no frames
/// @throws FileError
WrittenFiles export_result(const ExportOptions& options);

}  // namespace sundrape
