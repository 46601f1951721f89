#include <charconv>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sundrape/io/nearest_name.hpp"

#include "case_section.hpp"

namespace sundrape {
namespace {

using Path = std::span<const std::string>;

[[noreturn]] void refuse(const std::string& why) { throw std::invalid_argument(why); }

/// An index of a list, written as a part of a key.
std::size_t index_of(const std::string& text, std::size_t size, const std::string& list) {
  std::size_t index = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (problem != std::errc() || end != text.data() + text.size() || index >= size)
    refuse(size == 0 ? fmt::format("'{}' has no entry '{}'", list, text)
                     : fmt::format("'{}' is not an index of '{}', 0 to {}", text, list, size - 1));
  return index;
}

}  // namespace

CaseSection::Parameter CaseSection::parameter(Path path) const {
  if (path.empty()) refuse(fmt::format("'{}' is a table; a parameter is one of its numbers", source_.key));
  const auto& name = path.front();
  const Key* known = section_->find(name, kind());
  if (known == nullptr) {
    const auto names = section_->names(kind());
    const auto near = nearest_name(name, names);
    refuse(fmt::format("there is no key '{}'{}", this->path(name),
                       near.empty() ? fmt::format("; accepted: {}", fmt::join(names, ", "))
                                    : fmt::format(", did you mean '{}'?", near)));
  }
  const auto rest = path.subspan(1);
  switch (known->type) {
    case KeyType::table:
      return table(name).parameter(rest);
    case KeyType::tables:
    case KeyType::pieces: {
      const auto all = tables(name);
      const bool listed = has(name) && given(name)->is_array();
      if (!listed && known->type == KeyType::pieces && !all.empty()) return all.front().parameter(rest);
      if (rest.empty()) refuse(fmt::format("'{}' is a list of tables: name one by its index", this->path(name)));
      return all[index_of(rest.front(), all.size(), this->path(name))].parameter(rest.subspan(1));
    }
    case KeyType::number:
    case KeyType::series:
    case KeyType::lists:
      return number_at(*known, rest);
    case KeyType::integer:
      refuse(fmt::format("'{}' is a whole number, which has no derivative", this->path(name)));
    default:
      refuse(fmt::format("'{}' is not a number", this->path(name)));
  }
}

CaseSection::Parameter CaseSection::number_at(const Key& key, Path rest) const {
  const auto* node = given(key.name);
  if (node == nullptr && context_->default_of(key) == nullptr)
    refuse(fmt::format("'{}' is not in the case{}: give it a value", path(key.name),
                       key.default_note.empty() ? "" : fmt::format(" (default: {})", key.default_note)));
  if (node == nullptr || !node->is_array()) {
    if (!rest.empty()) refuse(fmt::format("'{}' is one number, without an entry '{}'", path(key.name), rest.front()));
    return {numbers(key.name).front(), key.unit, key.range, source(key.name)};
  }
  const auto pick = [&](const std::vector<double>& list, Path at) {
    if (at.size() != 1) refuse(fmt::format("'{}' is a list: name one of its numbers by its index", path(key.name)));
    return Parameter{list[index_of(at.front(), list.size(), path(key.name))], key.unit, key.range, source(key.name)};
  };
  if (key.type == KeyType::lists) {
    const auto all = lists(key.name);
    if (all.size() == 1) return pick(all.front(), rest);
    if (rest.empty()) refuse(fmt::format("'{}' has lists of warp and weft: name one by its index", path(key.name)));
    return pick(all[index_of(rest.front(), all.size(), path(key.name))], rest.subspan(1));
  }
  return pick(key.type == KeyType::series ? series(key.name) : numbers(key.name), rest);
}

}  // namespace sundrape
