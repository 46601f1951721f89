#include "sundrape/io/key_table.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "case_keys.hpp"

namespace sundrape {

bool Range::bounded() const { return std::isfinite(low) || std::isfinite(high); }

std::string Range::text() const {
  return fmt::format("{}{:.10g}, {:.10g}{}", low_included ? '[' : '(', low, high, high_included ? ']' : ')');
}

bool Key::belongs_to(std::string_view kind) const {
  return kinds.empty() || std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

const Key* Section::find(std::string_view key, std::string_view kind) const {
  for (const auto& candidate : keys)
    if (candidate.name == key && candidate.belongs_to(kind)) return &candidate;
  return nullptr;
}

std::vector<std::string> Section::names(std::string_view kind) const {
  std::vector<std::string> all;
  for (const auto& key : keys)
    if (key.belongs_to(kind)) all.push_back(key.name);
  return all;
}

const std::vector<Section>& key_table() {
  static const std::vector<Section> table = [] {
    std::vector<Section> all;
    for (const auto& part : {top_keys(), cloth_keys(), material_keys(), shell_keys(), support_keys(), load_keys(),
                             contact_keys(), analysis_keys()})
      all.insert(all.end(), part.begin(), part.end());
    return all;
  }();
  return table;
}

const std::vector<Section>& study_key_table() {
  static const std::vector<Section> table = study_keys();
  return table;
}

const std::vector<Section>& fit_key_table() {
  static const std::vector<Section> table = fit_keys();
  return table;
}

const Section& key_section(std::string_view name, const std::vector<Section>& table) {
  for (const auto& section : table)
    if (section.name == name) return section;
  throw std::invalid_argument(fmt::format("the key table has no section '{}'", name));
}

}  // namespace sundrape
