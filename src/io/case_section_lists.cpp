#include <sstream>

#include <fmt/format.h>

#include "sundrape/io/case_error.hpp"

#include "case_document.hpp"
#include "case_section.hpp"

namespace sundrape {

std::vector<std::string> CaseSection::texts_of(const toml::node& node, const std::string& where) const {
  if (!node.is_array()) throw CaseError(source_line(node.source(), where, source_), "a list of strings is expected");
  std::vector<std::string> all;
  for (const auto& entry : *node.as_array()) {
    if (!entry.is_string())
      throw CaseError(source_line(entry.source(), fmt::format("{}.{}", where, all.size()), source_),
                      "a string is expected");
    all.push_back(entry.as_string()->get());
  }
  return all;
}

std::vector<std::string> CaseSection::texts(std::string_view name) const {
  return has(name) ? texts_of(*given(name), path(name)) : std::vector<std::string>();
}

std::vector<std::vector<std::string>> CaseSection::text_lists(std::string_view name) const {
  std::vector<std::vector<std::string>> all;
  if (!has(name)) return all;
  if (!given(name)->is_array()) fail(name, "a list of lists of strings is expected");
  for (const auto& entry : *given(name)->as_array())
    all.push_back(texts_of(entry, fmt::format("{}.{}", path(name), all.size())));
  return all;
}

std::optional<std::vector<std::string>> CaseSection::listed_values(std::string_view name) const {
  const toml::node& node = value(name);
  if (node.is_table()) return std::nullopt;
  const auto* list = node.as_array();
  if (list == nullptr) fail(name, "a list of values or a range { from = ..., to = ... } is expected");
  if (list->empty()) fail(name, "the list is empty");
  std::vector<std::string> all;
  for (const auto& entry : *list) {
    if (const auto* number = entry.as_floating_point()) {
      all.push_back(fmt::format("{}", number->get()));  // as short as it was written; TOML++ prints 17 digits
      continue;
    }
    std::ostringstream text;
    text << toml::toml_formatter(entry,
                                 toml::toml_formatter::default_flags & ~toml::format_flags::allow_literal_strings);
    all.push_back(text.str());
  }
  return all;
}

}  // namespace sundrape
