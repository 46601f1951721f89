#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sundrape/io/key_table.hpp"

namespace sundrape {
namespace {

std::string number_text(const Key& key, const char* noun) {
  const std::string unit = key.unit == "1" ? "" : fmt::format(" [{}]", key.unit);
  if (key.entries == 0) return noun + unit;
  const std::string list =
      fmt::format("list of {} {}", key.entries, key.type == KeyType::integer ? "integers" : "numbers");
  return (key.scalar ? fmt::format("{} or {}", noun, list) : list) + unit;
}

std::string type_text(const Key& key) {
  switch (key.type) {
    case KeyType::text:
      return "string";
    case KeyType::name:
      return "name";
    case KeyType::file:
      return "path";
    case KeyType::choice:
      return "choice";
    case KeyType::choices:
      return "list of choices";
    case KeyType::number:
      return number_text(key, key.unit == "1" ? "number" : "quantity");
    case KeyType::quantity:
      return "number or quantity";
    case KeyType::series:
      return fmt::format("number or list of 1 to {}", key.entries);
    case KeyType::lists:
      return fmt::format("list of 1 to {} numbers, or two", key.entries);
    case KeyType::integer:
      return number_text(key, "integer");
    case KeyType::boolean:
      return "boolean";
    case KeyType::corners:
      return fmt::format("two points [{}]", key.unit);
    case KeyType::direction:
      return "direction";
    case KeyType::unit:
      return fmt::format("unit like {}", key.unit);
    case KeyType::selector:
      return "selector";
    case KeyType::table:
      return "table";
    case KeyType::tables:
      return "tables";
    case KeyType::pieces:
      return "table or tables";
    case KeyType::texts:
      return "list of strings";
    case KeyType::text_lists:
      return "list of lists of strings";
    case KeyType::values:
      return "list or range";
  }
  return {};
}

std::string accepted_text(const Key& key) {
  if (!key.available) return "not available yet";
  if (!key.choices.empty()) {
    std::string text = fmt::format("`{}`", fmt::join(key.choices, "`, `"));
    if (!key.later.empty()) text += fmt::format("; not yet: `{}`", fmt::join(key.later, "`, `"));
    return text;
  }
  return key.range.bounded() ? key.range.text() : "";
}

std::string default_text(const Key& key) {
  if (!key.default_value.empty()) return fmt::format("`{}`", key.default_value);
  if (!key.default_note.empty()) return key.default_note;
  return key.required ? "**required**" : "none";
}

std::string row(const Section& section, const Key& key) {
  const std::string kinds =
      key.kinds.empty() ? "" : fmt::format("(`{}`: {}) ", section.kind_key, fmt::join(key.kinds, ", "));
  return fmt::format("| `{}` | {} | {} | {} | {}{} |\n", key.name, type_text(key), default_text(key),
                     accepted_text(key), kinds, key.doc);
}

}  // namespace

std::string key_table_markdown(const std::vector<Section>& table) {
  std::string text;
  for (const auto& section : table) {
    text += fmt::format("### {}\n\n", section.heading);
    if (!section.doc.empty()) text += section.doc + "\n\n";
    text += "| Key | Type | Default | Accepted | Meaning |\n|---|---|---|---|---|\n";
    for (const auto& key : section.keys) text += row(section, key);
    text += "\n";
  }
  return text;
}

}  // namespace sundrape
