#pragma once
#include <filesystem>
#include <string>

namespace sundrape {

/// A whole text file. @throws std::system_error  it is missing, a folder, or cannot be read
[[nodiscard]] std::string read_text(const std::filesystem::path& file);

}  // namespace sundrape
