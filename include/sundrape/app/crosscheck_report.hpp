#pragma once
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "sundrape/app/crosscheck.hpp"

namespace sundrape {

/// What a crosscheck prints: first whether the methods are on one branch, then how far apart they are.
[[nodiscard]] std::string crosscheck_text(const Crosscheck& check);

/// All of it, with the second shape of every pair as it was laid on the first.
/// @param nodes  N
[[nodiscard]] nlohmann::json crosscheck_json(const Crosscheck& check, int nodes);

}  // namespace sundrape
