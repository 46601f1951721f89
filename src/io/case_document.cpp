#include "case_document.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "sundrape/io/case_error.hpp"

#include "case_fabric.hpp"

namespace sundrape {
namespace {

std::optional<std::size_t> index_of(std::string_view text) {
  std::size_t index = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return index;
}

/// One KEY.PATH=VALUE of the command line.
class Setting {
 public:
  explicit Setting(const std::string& text) : origin_("--set " + text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0) fail("", "KEY.PATH=VALUE is expected");
    key_ = text.substr(0, equals);
    value_ = text.substr(equals + 1);
    for (std::size_t begin = 0; begin <= key_.size();) {
      const auto end = std::min(key_.find('.', begin), key_.size());
      std::string part = key_.substr(begin, end - begin);
      if (part.size() > 2 && part.front() == '"' && part.back() == '"') part = part.substr(1, part.size() - 2);
      if (part.empty()) fail(key_, "a part of the key is empty");
      path_.push_back(std::move(part));
      begin = end + 1;
    }
  }

  void apply(toml::table& root) const {
    toml::node* here = &root;
    for (std::size_t depth = 0; depth < path_.size(); ++depth) {
      if (auto* table = here->as_table())
        here = step_into(*table, depth);
      else if (auto* array = here->as_array())
        here = step_into(*array, depth);
      else
        fail(key_, fmt::format("'{}' is neither a table nor an array", path_[depth - 1]));
    }
  }

 private:
  [[nodiscard]] bool is_last(std::size_t depth) const { return depth + 1 == path_.size(); }

  toml::node* step_into(toml::table& table, std::size_t depth) const {
    const std::string& name = path_[depth];
    if (!is_last(depth) && table.contains(name)) return table.get(name);
    if (!is_last(depth) && index_of(path_[depth + 1])) fail(key_, fmt::format("the case has no [[{}]]", name));
    toml::table holder = is_last(depth) ? value() : parsed("{}");
    toml::node& node = *holder.get("value");
    const toml::source_region source = node.source();
    table.erase(name);
    // Only a move keeps the node's source.
    node.visit([&](auto& value) { table.insert_or_assign(toml::key(name, source), std::move(value)); });
    return table.get(name);
  }

  toml::node* step_into(toml::array& array, std::size_t depth) const {
    const auto index = index_of(path_[depth]);
    if (!index || *index >= array.size())
      fail(key_, array.empty() ? fmt::format("there is no entry '{}'", path_[depth])
                               : fmt::format("'{}' is not an index from 0 to {}", path_[depth], array.size() - 1));
    if (is_last(depth)) {
      toml::table holder = value();
      const auto at = array.cbegin() + static_cast<std::ptrdiff_t>(*index);
      holder.get("value")->visit([&](auto& value) { array.replace(at, std::move(value)); });
    }
    return array.get(*index);
  }

  /// A table that holds the node under the key "value".
  [[nodiscard]] toml::table parsed(std::string_view value) const {
    return toml::parse(fmt::format("value = {}", value), origin_);
  }

  /// The setting's value: TOML if it is TOML, else a string that lacks its quotes.
  [[nodiscard]] toml::table value() const {
    try {
      toml::table holder = parsed(value_);
      if (holder.size() == 1) return holder;
    } catch (const toml::parse_error&) {
      // a bare word or quantity, which comes next
    }
    std::string quoted;
    for (const char c : value_) {
      if (c == '"' || c == '\\') quoted += '\\';
      quoted += c == '\n' ? ' ' : c;
    }
    return parse_toml("value = \"" + quoted + "\"", origin_);
  }

  [[noreturn]] void fail(const std::string& key, const std::string& message) const {
    throw CaseError(origin_, 0, key, message);
  }

  std::string origin_;
  std::string key_;
  std::string value_;
  std::vector<std::string> path_;
};

/// A [[cloth]] of one piece is the same as [cloth].
void unwrap_single_cloth(toml::table& root) {
  auto* pieces = root.get_as<toml::array>("cloth");
  if (pieces == nullptr || pieces->size() != 1 || !pieces->front().is_table()) return;
  toml::table piece = std::move(*pieces->front().as_table());
  root.insert_or_assign("cloth", std::move(piece));
}

/// A table that may have a material: the case, or one of its pieces of cloth.
struct OwnerOfMaterial {
  toml::table* table;
  std::string path;  // what its keys begin with
};

std::vector<OwnerOfMaterial> owners_of_materials(toml::table& root) {
  std::vector<OwnerOfMaterial> owners{{&root, ""}};
  if (auto* piece = root.get_as<toml::table>("cloth")) owners.push_back({piece, "cloth."});
  if (auto* pieces = root.get_as<toml::array>("cloth"))
    for (int k = 0; auto& piece : *pieces) {
      if (piece.is_table()) owners.push_back({piece.as_table(), "cloth." + std::to_string(k) + "."});
      ++k;
    }
  return owners;
}

}  // namespace

toml::table parse_toml(std::string_view text, const std::string& file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    const bool from_set = file.starts_with("--set ");
    throw CaseError(file, from_set ? 0 : static_cast<int>(error.source().begin.line), "",
                    std::string(error.description()));
  }
}

toml::table parse_document(std::string_view text, const std::string& file, const std::vector<std::string>& sets) {
  toml::table root = parse_toml(text, file);
  unwrap_single_cloth(root);
  std::vector<bool> had_fabric;
  for (const auto& owner : owners_of_materials(root)) had_fabric.push_back(names_fabric(*owner.table));
  for (const auto& set : sets) Setting(set).apply(root);
  const auto folder = std::filesystem::path(file).parent_path();
  const auto owners = owners_of_materials(root);
  had_fabric.resize(owners.size(), false);  // a setting may have put a piece where none was
  for (std::size_t k = 0; k < owners.size(); ++k)
    include_fabric(*owners[k].table, owners[k].path, folder, had_fabric[k]);
  return root;
}

SourceLine source_line(const toml::source_region& region, std::string key, const SourceLine& fallback) {
  if (!region.path) return {fallback.file, fallback.line, std::move(key)};
  const bool from_set = region.path->starts_with("--set ");
  return {*region.path, from_set ? 0 : static_cast<int>(region.begin.line), std::move(key)};
}

}  // namespace sundrape
