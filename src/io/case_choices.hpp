#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "sundrape/io/case.hpp"

namespace sundrape::choices {

/// What a case file calls the values of an enumeration, in its order: the one list for keys, reader and description.
template <class Enum, std::size_t n>
struct Choices {
  std::array<const char*, n> names;

  [[nodiscard]] std::vector<std::string> list() const { return {names.begin(), names.end()}; }
  [[nodiscard]] const char* name(Enum value) const { return names.at(static_cast<std::size_t>(value)); }
  /// @param text  one of the names
  [[nodiscard]] Enum value(std::string_view text) const {
    return static_cast<Enum>(std::find(names.begin(), names.end(), text) - names.begin());
  }
};

inline constexpr Choices<Model, 2> model{{"particle", "shell"}};
inline constexpr Choices<Analysis, 3> analysis{{"dynamics", "relaxation", "arc-length"}};
inline constexpr Choices<PathControlKind, 2> path_control{{"arc-length", "load"}};
inline constexpr Choices<BifurcationKind, 3> at_bifurcation{{"pass", "switch", "stop"}};
inline constexpr Choices<IntegratorKind, 4> integrator{{"cvode", "ida", "rk4", "dirk"}};
inline constexpr Choices<ShellMembrane, 4> membrane{{"centre", "bilinear", "edge-tied", "mixed"}};
inline constexpr Choices<ShellBending, 2> bending{{"geodesic", "bilinear"}};
inline constexpr Choices<ShellDirector, 3> director{{"auto", "inertia", "massless"}};

}  // namespace sundrape::choices
