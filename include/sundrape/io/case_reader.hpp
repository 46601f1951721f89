#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sundrape/io/case.hpp"
#include "sundrape/io/case_error.hpp"

namespace sundrape {

/// Reads a case file: units resolved to SI, defaults filled in, everything checked that needs no mesh.
///
/// @param sets  settings "key.path=value" that replace or add to what the file says; a value that is not TOML is taken
/// as a
///              string ("material.thickness=0.6 mm"), entries of arrays go by index ("load.0.acceleration=[0, 0, -1]")
/// @throws CaseError          the first thing that is wrong with the case
/// @throws std::system_error  the file cannot be read
[[nodiscard]] Case read_case(const std::filesystem::path& file, const std::vector<std::string>& sets = {});

/// Like read_case from text that is at hand already, e.g. that of a result; `file` is what messages call it and where
/// relative paths count from.
[[nodiscard]] Case parse_case(std::string_view text, const std::filesystem::path& file,
                              const std::vector<std::string>& sets = {});

/// What `sundrape check` prints: every resolved key with its SI value and unit, and what follows from them.
[[nodiscard]] std::string describe(const Case& resolved);

}  // namespace sundrape
