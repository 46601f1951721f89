#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace sundrape {

/// What `sundrape check` prints: every resolved value of a case in SI, and the size of what would be run.
/// @throws CaseError  as run_case does, for everything that shows before the first step
[[nodiscard]] std::string check_case(const std::filesystem::path& file, const std::vector<std::string>& sets);

}  // namespace sundrape
