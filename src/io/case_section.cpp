#include "case_section.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sundrape/io/case_error.hpp"
#include "sundrape/io/nearest_name.hpp"

#include "case_document.hpp"

namespace sundrape {
namespace {

/// A value as the user wrote it, for messages.
std::string echo(const toml::node& node) {
  if (const auto* text = node.as_string()) return fmt::format("'{}'", text->get());
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* number = node.as_integer()) return fmt::format("{}", number->get());
  if (const auto* truth = node.as_boolean()) return truth->get() ? "true" : "false";
  if (node.is_array()) return "a list";
  return node.is_table() ? "a table" : "a date or time";
}

[[noreturn]] void fail_at(const toml::node& node, const SourceLine& section, const std::string& path,
                          const std::string& message) {
  throw CaseError(source_line(node.source(), path, section), message);
}

}  // namespace

ReadingContext::ReadingContext(const std::vector<Section>& table) : table_(&table) {
  for (const auto& section : table)
    for (const auto& key : section.keys)
      if (!key.default_value.empty())
        defaults_.emplace(&key, parse_toml("value = " + key.default_value, "the default of " + key.name));
}

const toml::node* ReadingContext::default_of(const Key& key) const {
  const auto found = defaults_.find(&key);
  return found == defaults_.end() ? nullptr : found->second.get("value");
}

CaseSection::CaseSection(const ReadingContext& context, const Section& section, const toml::table* table,
                         SourceLine source)
    : context_(&context), section_(&section), table_(table), source_(std::move(source)) {}

bool CaseSection::has(std::string_view name) const { return given(name) != nullptr; }

const toml::node* CaseSection::given(std::string_view name) const { return table_ ? table_->get(name) : nullptr; }

std::string CaseSection::kind() const { return section_->kind_key.empty() ? std::string() : text(section_->kind_key); }

const Key& CaseSection::key(std::string_view name) const {
  // The kind key itself belongs to every kind, and asking for its value here would not end.
  const Key* found = section_->find(name, name == section_->kind_key ? std::string() : kind());
  if (found == nullptr) throw std::logic_error(fmt::format("no key '{}' in section '{}'", name, section_->name));
  return *found;
}

const toml::node& CaseSection::value(std::string_view name) const {
  if (const auto* node = given(name)) return *node;
  if (const auto* node = context_->default_of(key(name))) return *node;
  throw CaseError(source_.file, source_.line, path(name), "missing");
}

std::string CaseSection::path(std::string_view name) const {
  return source_.key.empty() ? std::string(name) : fmt::format("{}.{}", source_.key, name);
}

SourceLine CaseSection::source(std::string_view name) const {
  const auto* node = given(name);
  return node ? source_line(node->source(), path(name), source_) : SourceLine{source_.file, source_.line, path(name)};
}

void CaseSection::fail(std::string_view name, const std::string& message) const {
  throw CaseError(source(name), message);
}

double CaseSection::scalar(const Key& key, const toml::node& node) const {
  double number = 0;
  if (node.is_number()) {
    // Not value<double>(): it has nothing to say for integers past 2^53.
    number = node.is_integer() ? static_cast<double>(node.as_integer()->get()) : node.as_floating_point()->get();
    if (!std::isfinite(number))
      fail_at(node, source_, path(key.name), fmt::format("{} is not a finite number", number));
  } else if (node.is_string() && key.unit != "1") {
    try {
      number = context_->units().parse_quantity(node.as_string()->get(), key.unit);
    } catch (const std::invalid_argument& problem) {
      fail_at(node, source_, path(key.name), problem.what());
    }
  } else {
    fail_at(node, source_, path(key.name),
            fmt::format("{} is expected, not {}", context_->units().dimension(key.unit), echo(node)));
  }
  if (!key.range.contains(number))
    fail_at(node, source_, path(key.name),
            fmt::format("{} is outside {}{}", echo(node), key.range.text(), key.unit == "1" ? "" : " " + key.unit));
  return number;
}

std::vector<double> CaseSection::list(const Key& key, const toml::array& array) const {
  if (array.size() != key.entries)
    fail_at(array, source_, path(key.name),
            fmt::format("a list of {} is expected, not of {}", key.entries, array.size()));
  std::vector<double> numbers;
  for (const auto& entry : array) numbers.push_back(scalar(key, entry));
  return numbers;
}

std::vector<double> CaseSection::numbers(std::string_view name) const {
  const Key& k = key(name);
  const toml::node& node = value(name);
  if (node.is_array() && k.entries > 0) return list(k, *node.as_array());
  if (!k.scalar && !node.is_array()) fail(name, fmt::format("a list of {} is expected, not {}", k.entries, echo(node)));
  return {scalar(k, node)};
}

std::optional<double> CaseSection::maybe_number(std::string_view name) const {
  if (!has(name) && context_->default_of(key(name)) == nullptr) return std::nullopt;
  return number(name);
}

std::optional<double> CaseSection::maybe_quantity(std::string_view name, const std::string& unit) const {
  if (!has(name)) return std::nullopt;
  Key of_unit = key(name);
  of_unit.unit = unit;
  return scalar(of_unit, value(name));
}

std::vector<double> CaseSection::short_list(const Key& key, const toml::array& array) const {
  if (array.empty() || array.size() > key.entries)
    fail_at(array, source_, path(key.name),
            fmt::format("a list of 1 to {} numbers is expected, not of {}", key.entries, array.size()));
  std::vector<double> numbers;
  for (const auto& entry : array) numbers.push_back(scalar(key, entry));
  return numbers;
}

std::vector<double> CaseSection::series(std::string_view name) const {
  const Key& k = key(name);
  const toml::node& node = value(name);
  return node.is_array() ? short_list(k, *node.as_array()) : std::vector<double>{scalar(k, node)};
}

std::vector<std::vector<double>> CaseSection::lists(std::string_view name) const {
  const Key& k = key(name);
  const toml::node& node = value(name);
  if (!node.is_array()) fail(name, fmt::format("a list of numbers is expected, not {}", echo(node)));
  const auto& outer = *node.as_array();
  if (outer.empty() || !outer.front().is_array()) return {short_list(k, outer)};
  if (outer.size() != 2) fail(name, fmt::format("[warp list, weft list] is expected, not {} lists", outer.size()));
  std::vector<std::vector<double>> both;
  for (const auto& entry : outer) {
    if (!entry.is_array())
      fail_at(entry, source_, path(name), fmt::format("a list of numbers is expected, not {}", echo(entry)));
    both.push_back(short_list(k, *entry.as_array()));
  }
  return both;
}

std::vector<std::int64_t> CaseSection::integers(std::string_view name) const {
  const toml::node& node = value(name);
  const auto require_whole = [&](const toml::node& entry) {
    if (!entry.is_integer())
      fail_at(entry, source_, path(name), fmt::format("a whole number is expected, not {}", echo(entry)));
  };
  if (const auto* array = node.as_array(); array && key(name).entries > 0)
    for (const auto& entry : *array) require_whole(entry);
  else if (key(name).scalar)
    require_whole(node);
  std::vector<std::int64_t> whole;
  for (const double number : numbers(name)) whole.push_back(static_cast<std::int64_t>(number));
  return whole;
}

Vector3 CaseSection::vector3(std::string_view name) const {
  const auto n = numbers(name);
  return {n.at(0), n.at(1), n.at(2)};
}

Vector3 CaseSection::direction(std::string_view name) const {
  Key three = key(name);
  three.entries = 3;
  const toml::node& node = value(name);
  if (!node.is_array()) fail(name, fmt::format("a list of 3 is expected, not {}", echo(node)));
  const auto n = list(three, *node.as_array());
  const Vector3 v(n[0], n[1], n[2]);
  if (!(v.stableNorm() > 0)) fail(name, "a direction needs a length, but all its components are 0");
  return v.stableNormalized();
}

bool CaseSection::boolean(std::string_view name) const {
  const toml::node& node = value(name);
  if (!node.is_boolean()) fail(name, fmt::format("true or false is expected, not {}", echo(node)));
  return node.as_boolean()->get();
}

std::string CaseSection::text(std::string_view name) const {
  const Key& k = key(name);
  const toml::node& node = value(name);
  if (!node.is_string()) fail(name, fmt::format("a string is expected, not {}", echo(node)));
  const std::string& text = node.as_string()->get();
  if (k.type == KeyType::choice && std::find(k.choices.begin(), k.choices.end(), text) == k.choices.end()) {
    if (std::find(k.later.begin(), k.later.end(), text) != k.later.end())
      fail(name, fmt::format("'{}' is not available in this version; accepted: {}", text, fmt::join(k.choices, ", ")));
    const std::string near = nearest_name(text, k.choices);
    fail(name, fmt::format("'{}' is not one of {}{}", text, fmt::join(k.choices, ", "),
                           near.empty() ? "" : fmt::format(", did you mean '{}'?", near)));
  }
  if (k.type == KeyType::name && (text.empty() || text == "." || text == ".." || text.find('/') != std::string::npos))
    fail(name, fmt::format("'{}' cannot name a group of the result file", text));
  if (k.type == KeyType::file && text.empty()) fail(name, "the file has no name");
  return text;
}

std::vector<std::string> CaseSection::choices(std::string_view name) const {
  const Key& k = key(name);
  const toml::node& node = value(name);
  if (!node.is_array() || node.as_array()->empty())
    fail(name, fmt::format("a list from {} is expected, not {}", fmt::join(k.choices, ", "),
                           node.is_array() ? "an empty one" : echo(node)));
  std::vector<std::string> chosen;
  for (const auto& entry : *node.as_array()) {
    const std::string text = entry.is_string() ? entry.as_string()->get() : std::string();
    if (std::find(k.choices.begin(), k.choices.end(), text) == k.choices.end())
      fail_at(entry, source_, path(name), fmt::format("{} is not one of {}", echo(entry), fmt::join(k.choices, ", ")));
    if (std::find(chosen.begin(), chosen.end(), text) != chosen.end())
      fail_at(entry, source_, path(name), fmt::format("'{}' stands there twice", text));
    chosen.push_back(text);
  }
  return chosen;
}

double CaseSection::unit(std::string_view name) const {
  const std::string unit = text(name);
  if (unit.find_first_not_of(" \t") == std::string::npos) fail(name, "the unit is empty");
  try {
    return context_->units().parse_quantity("1 " + unit, key(name).unit);
  } catch (const std::invalid_argument&) {
    fail(name, fmt::format("'{}' is not the unit of {}", unit, context_->units().dimension(key(name).unit)));
  }
}

CaseSection CaseSection::table(std::string_view name) const {
  const toml::node* node = given(name);
  if (node && !node->is_table()) fail(name, fmt::format("a table is expected, not {}", echo(*node)));
  return {*context_, key_section(key(name).holds, context_->table()), node ? node->as_table() : nullptr, source(name)};
}

std::vector<CaseSection> CaseSection::tables(std::string_view name) const {
  const toml::node* node = given(name);
  if (node == nullptr) return {};
  if (key(name).type == KeyType::pieces && !node->is_array()) return {table(name)};
  if (!node->is_array())
    fail(name, fmt::format("an array of tables is expected: write [[{}]], not [{}]", path(name), path(name)));
  std::vector<CaseSection> all;
  for (const auto& entry : *node->as_array()) {
    const std::string where = fmt::format("{}.{}", path(name), all.size());
    if (!entry.is_table()) fail_at(entry, source_, where, fmt::format("a table is expected, not {}", echo(entry)));
    all.emplace_back(*context_, key_section(key(name).holds, context_->table()), entry.as_table(),
                     source_line(entry.source(), where, source_));
  }
  return all;
}

}  // namespace sundrape
