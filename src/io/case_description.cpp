#include "case_description.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sundrape/io/key_table.hpp"

namespace sundrape {
namespace {

std::string shortest(double value) { return fmt::format("{:.10g}", value); }

const Key& find_key(const std::string& section, const std::string& kind, std::string_view key) {
  const Key* found = key_section(section).find(key, kind);
  if (found == nullptr) throw std::logic_error(fmt::format("no key '{}' in section '{}'", key, section));
  return *found;
}

}  // namespace

void CaseDescription::enter(std::string section, std::string path, std::string kind) {
  section_ = std::move(section);
  path_ = std::move(path);
  kind_ = std::move(kind);
}

std::string CaseDescription::unit(std::string_view key) const {
  const std::string& unit = find_key(section_, kind_, key).unit;
  return unit == "1" ? std::string() : " " + unit;
}

void CaseDescription::number(std::string_view key, double value) { verbatim(key, shortest(value) + unit(key)); }

void CaseDescription::maybe_number(std::string_view key, const std::optional<double>& value) {
  if (value)
    number(key, *value);
  else
    verbatim(key, fmt::format("({})", find_key(section_, kind_, key).default_note));
}

void CaseDescription::numbers(std::string_view key, const std::vector<double>& values) {
  std::vector<std::string> printed;
  printed.reserve(values.size());
  for (const double value : values) printed.push_back(shortest(value));
  verbatim(key, fmt::format("[{}]{}", fmt::join(printed, ", "), unit(key)));
}

void CaseDescription::text(std::string_view key, std::string_view value) {
  verbatim(key, fmt::format("\"{}\"", value));
}

void CaseDescription::verbatim(std::string_view key, std::string value) {
  (void)find_key(section_, kind_, key);  // a name that the table lacks is a slip
  lines_.push_back({path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key), std::move(value)});
}

void CaseDescription::heading(std::string text) { lines_.push_back({"", std::move(text)}); }

void CaseDescription::derived(std::string name, double value, std::string_view unit) {
  lines_.push_back({std::move(name), fmt::format("{} {}", shortest(value), unit)});
}

std::string CaseDescription::print() const {
  std::size_t width = 0;
  for (const auto& line : lines_) width = std::max(width, line.name.size());
  std::string text;
  for (const auto& line : lines_)
    text += line.name.empty() ? fmt::format("\n# {}\n", line.value)
                              : fmt::format("{:<{}} = {}\n", line.name, width, line.value);
  return text;
}

}  // namespace sundrape
