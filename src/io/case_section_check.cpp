#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sundrape/io/case_error.hpp"
#include "sundrape/io/nearest_name.hpp"

#include "case_document.hpp"
#include "case_section.hpp"

namespace sundrape {
namespace {

/// How one would write the table that has the key, or nothing if no section or several have it.
std::string home_of(std::string_view name, const std::vector<Section>& table) {
  std::string home;
  for (const auto& section : table)
    if (std::any_of(section.keys.begin(), section.keys.end(), [&](const Key& key) { return key.name == name; })) {
      if (!home.empty()) return {};
      home = section.name.empty() ? "the top level" : section.name;
    }
  return home;
}

/// The nearest name that any section has.
std::string nearest_anywhere(std::string_view name, const std::vector<Section>& table) {
  std::vector<std::string> all;
  for (const auto& section : table)
    for (const auto& key : section.keys) all.push_back(key.name);
  return nearest_name(name, all);
}

std::string advice(std::string_view name, const std::vector<std::string>& accepted, const std::vector<Section>& table) {
  if (const auto near = nearest_name(name, accepted); !near.empty()) return fmt::format(", did you mean '{}'?", near);
  const auto elsewhere = nearest_anywhere(name, table);
  const auto home = home_of(elsewhere, table);
  if (elsewhere == name && !home.empty()) return fmt::format(" here; it belongs to {}", home);
  if (!home.empty()) return fmt::format(", did you mean '{}' of {}?", elsewhere, home);
  return fmt::format("; accepted: {}", fmt::join(accepted, ", "));
}

}  // namespace

void CaseSection::check() const {
  if (table_ == nullptr) return;
  if (!section_->kind_key.empty() && !has(section_->kind_key) && key(section_->kind_key).required)
    throw CaseError(source_.file, source_.line, path(section_->kind_key),
                    fmt::format("missing; accepted: {}", fmt::join(key(section_->kind_key).choices, ", ")));
  const std::string chosen = kind();

  // In the order of the file, so that the first of several errors is the first that the reader meets.
  std::vector<const toml::key*> entries;
  for (const auto& [name, node] : *table_) entries.push_back(&name);
  std::stable_sort(entries.begin(), entries.end(),
                   [](const auto* a, const auto* b) { return a->source().begin.line < b->source().begin.line; });
  for (const auto* name : entries) {
    check_known(*name, chosen);
    check_value(key(name->str()));
  }
  check_required(chosen);
}

void CaseSection::check_known(const toml::key& name, const std::string& kind) const {
  const std::string_view written = name.str();
  const Key* known = section_->find(written, kind);
  if (known != nullptr && known->available) return;
  const SourceLine here = source_line(name.source(), path(written), source(written));
  if (known != nullptr) throw CaseError(here, "not available in this version");
  std::vector<std::string> kinds;
  for (const auto& key : section_->keys)
    if (key.name == written) kinds.insert(kinds.end(), key.kinds.begin(), key.kinds.end());
  if (!kinds.empty())
    throw CaseError(here, fmt::format("belongs to {} = {}, not to '{}', which takes: {}", section_->kind_key,
                                      fmt::join(kinds, ", "), kind, fmt::join(section_->names(kind), ", ")));
  throw CaseError(here, "unknown key" + advice(written, section_->names(kind), context_->table()));
}

void CaseSection::check_value(const Key& key) const {
  switch (key.type) {
    case KeyType::text:
    case KeyType::name:
    case KeyType::file:
    case KeyType::choice:
      (void)text(key.name);
      break;
    case KeyType::choices:
      (void)choices(key.name);
      break;
    case KeyType::number:
      (void)numbers(key.name);
      break;
    case KeyType::quantity:
      if (!given(key.name)->is_number() && !given(key.name)->is_string())
        fail(key.name, "a number or a quantity is expected");
      break;
    case KeyType::series:
      (void)series(key.name);
      break;
    case KeyType::lists:
      (void)lists(key.name);
      break;
    case KeyType::integer:
      (void)integers(key.name);
      break;
    case KeyType::boolean:
      (void)boolean(key.name);
      break;
    case KeyType::corners:
      (void)corners(key.name);
      break;
    case KeyType::direction:
      (void)direction(key.name);
      break;
    case KeyType::unit:
      (void)unit(key.name);
      break;
    case KeyType::selector:
      (void)selector(key.name);
      break;
    case KeyType::table:
      table(key.name).check();
      break;
    case KeyType::tables:
    case KeyType::pieces:
      for (const auto& entry : tables(key.name)) entry.check();
      break;
    case KeyType::texts:
      (void)texts(key.name);
      break;
    case KeyType::text_lists:
      (void)text_lists(key.name);
      break;
    case KeyType::values:
      if (!listed_values(key.name)) table(key.name).check();
      break;
  }
}

void CaseSection::check_required(const std::string& kind) const {
  for (const auto& key : section_->keys)
    if (key.required && key.belongs_to(kind) && !has(key.name))
      throw CaseError(source_.file, source_.line, path(key.name),
                      key.type == KeyType::choice ? fmt::format("missing; accepted: {}", fmt::join(key.choices, ", "))
                                                  : fmt::format("missing: {}", key.doc));
}

}  // namespace sundrape
