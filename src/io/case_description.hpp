#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sundrape/types.hpp"

namespace sundrape {

/// Collects lines `key = value unit`; units come from the key table, so that they cannot drift from what is read.
class CaseDescription {
 public:
  /// The lines that follow are of this section; `path` is what their keys begin with, `kind` which of the keys apply.
  void enter(std::string section, std::string path, std::string kind = "");

  void number(std::string_view key, double value);
  void maybe_number(std::string_view key, const std::optional<double>& value);  // without one, how it is worked out
  void numbers(std::string_view key, const std::vector<double>& values);
  void vector3(std::string_view key, const Vector3& value) { numbers(key, {value.x(), value.y(), value.z()}); }
  void text(std::string_view key, std::string_view value);  // in quotes
  void verbatim(std::string_view key, std::string value);
  void heading(std::string text);  // a comment line, after a blank one
  void derived(std::string name, double value, std::string_view unit);

  /// All lines, the equals signs of a block below each other.
  [[nodiscard]] std::string print() const;

 private:
  struct Line {
    std::string name;  // empty: a heading
    std::string value;
  };
  [[nodiscard]] std::string unit(std::string_view key) const;

  std::string section_, path_, kind_;
  std::vector<Line> lines_;
};

}  // namespace sundrape
