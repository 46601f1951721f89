#pragma once
#include "sundrape/io/key_table.hpp"

namespace sundrape {

/// The pieces that key_table() is made of.
[[nodiscard]] std::vector<Section> top_keys();
[[nodiscard]] std::vector<Section> cloth_keys();
[[nodiscard]] std::vector<Section> material_keys();
[[nodiscard]] std::vector<Section> shell_keys();
[[nodiscard]] std::vector<Section> scene_keys();
[[nodiscard]] std::vector<Section> analysis_keys();

/// All of study_key_table().
[[nodiscard]] std::vector<Section> study_keys();

namespace keys {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline Range positive() { return {.low = 0}; }
inline Range not_negative() { return {.low = 0, .low_included = true}; }
inline Range from_to(double low, double high) {
  return {.low = low, .high = high, .low_included = true, .high_included = true};
}
inline Range above_to(double low, double high) { return {.low = low, .high = high, .high_included = true}; }

/// A point, a force, ...: three numbers of one unit.
inline Key vector3(std::string name, std::string unit, std::string doc) {
  return {.name = std::move(name), .unit = std::move(unit), .scalar = false, .entries = 3, .doc = std::move(doc)};
}

/// A mesh from a file, of kind "mesh", and its unit.
inline Key mesh_file(std::string doc) {
  return {.name = "file", .type = KeyType::file, .required = true, .kinds = {"mesh"}, .doc = std::move(doc)};
}
inline Key mesh_units() {
  return {.name = "units",
          .type = KeyType::unit,
          .unit = "m",
          .default_value = "\"m\"",
          .kinds = {"mesh"},
          .doc = "Unit of the file's coordinates."};
}

}  // namespace keys
}  // namespace sundrape
