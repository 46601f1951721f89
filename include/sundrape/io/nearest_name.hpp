#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace sundrape {

/// The name most like a misspelt one (edit distance with transpositions, at most a third of its letters, or one
/// that begins the other); empty if none is near.
[[nodiscard]] std::string nearest_name(std::string_view written, const std::vector<std::string>& names);

}  // namespace sundrape
