#include "sundrape/io/case_parameter.hpp"

#include <ranges>

#include <fmt/format.h>

#include "sundrape/io/case_error.hpp"
#include "sundrape/io/case_reader.hpp"

#include "case_document.hpp"
#include "case_parts.hpp"

namespace sundrape {
namespace {

/// Parts of a dotted key; a part may stand in quotes.
std::vector<std::string> parts_of(const std::string& key) {
  std::vector<std::string> parts;
  for (const auto part : std::views::split(key, '.')) {
    std::string text(part.begin(), part.end());
    if (text.size() > 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    parts.push_back(std::move(text));
  }
  return parts;
}

}  // namespace

ParameterCase find_parameter(const CaseSection& top, const std::string& key, const SourceLine& asked) {
  try {
    const auto found = top.parameter(parts_of(key));
    return {.key = key, .value = found.value, .unit = found.unit, .range = found.range, .source = asked};
  } catch (const std::invalid_argument& problem) {
    throw CaseError(asked, fmt::format("'{}': {}", key, problem.what()));
  }
}

ParameterCase find_parameter(const Case& resolved, const std::string& key, const SourceLine& asked) {
  const toml::table root = parse_toml(resolved.text, resolved.file.string());
  const ReadingContext context;
  return find_parameter(CaseSection(context, key_section(""), &root, {resolved.file.string(), 1, ""}), key, asked);
}

std::string parameter_setting(const std::string& key, double value) { return fmt::format("{}={:.17g}", key, value); }

Case with_parameter(const Case& resolved, const ParameterCase& parameter, double value) {
  return parse_case(resolved.text, resolved.file, {parameter_setting(parameter.key, value)});
}

}  // namespace sundrape
