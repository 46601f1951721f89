#pragma once
#include <fmt/format.h>

#include "sundrape/io/key_table.hpp"

namespace sundrape {

/// The pieces that key_table() is made of.
[[nodiscard]] std::vector<Section> top_keys();
[[nodiscard]] std::vector<Section> cloth_keys();
[[nodiscard]] std::vector<Section> material_keys();
[[nodiscard]] std::vector<Section> shell_keys();
[[nodiscard]] std::vector<Section> support_keys();
[[nodiscard]] std::vector<Section> load_keys();
[[nodiscard]] std::vector<Section> contact_keys();
[[nodiscard]] std::vector<Section> analysis_keys();

/// All of study_key_table().
[[nodiscard]] std::vector<Section> study_keys();

/// All of fit_key_table().
[[nodiscard]] std::vector<Section> fit_keys();

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

inline Key with_default(Key key, std::string value) {
  key.default_value = std::move(value);
  return key;
}

inline Key required(Key key) {
  key.required = true;
  return key;
}

inline Key only_for(std::vector<std::string> kinds, Key key) {
  key.kinds = std::move(kinds);
  return key;
}

inline Key nodes(std::vector<std::string> kinds = {}) {
  return {
      .name = "nodes", .type = KeyType::selector, .required = true, .kinds = std::move(kinds), .doc = "Which nodes."};
}

inline Key length(std::string name, std::string doc) {
  return {.name = std::move(name), .unit = "m", .range = positive(), .required = true, .doc = std::move(doc)};
}

inline Key stages(const std::string& what) {
  return {.name = "stages",
          .type = KeyType::series,
          .entries = 20,
          .default_value = "1",
          .doc = fmt::format("How much of {} there is at the end of each stage of `analysis = \"arc-length\"`, as a "
                             "share; after the last one it stays. Other analyses take the last.",
                             what)};
}

/// Where a body is carried to, and when: of a gripper, or of an obstacle.
[[nodiscard]] std::vector<Key> path_keys();

}  // namespace keys
}  // namespace sundrape
