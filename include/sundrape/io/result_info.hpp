#pragma once
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "sundrape/io/result_reader.hpp"

namespace sundrape {

/// What is in a result: case, mesh, frames, energies at the last frame, statistics, warnings.
[[nodiscard]] nlohmann::json info_json(const ResultReader& result);
/// The same for reading.
[[nodiscard]] std::string info_text(const ResultReader& result);

}  // namespace sundrape
