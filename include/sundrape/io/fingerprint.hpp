#pragma once
#include <filesystem>
#include <string>

namespace sundrape {

/// Sixteen hexadecimal digits that change with the contents of a file (FNV-1a of 64 bits): tells whether two runs read
/// the same. "missing" where it cannot be read.
[[nodiscard]] std::string fingerprint(const std::filesystem::path& file);

}  // namespace sundrape
