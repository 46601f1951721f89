#pragma once
#include <string>

namespace sundrape {

/// "major.minor.patch" of this library.
[[nodiscard]] std::string version();

}  // namespace sundrape
