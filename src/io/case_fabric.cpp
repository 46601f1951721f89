#include "case_fabric.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sundrape/io/case_error.hpp"
#include "sundrape/io/nearest_name.hpp"

#include "case_document.hpp"
#include "fabric_library.hpp"
#include "read_text.hpp"

namespace sundrape {
namespace {

using Names = std::vector<std::string_view>;

/// Ways to say the same thing, of which a material has one.
const std::array<std::vector<Names>, 2> alternatives{
    std::vector<Names>{{"weight"}, {"density_area"}, {"density"}},
    std::vector<Names>{{"youngs_modulus"}, {"warp_modulus", "weft_modulus", "shear_modulus"}}};

constexpr std::array merged_tables{"damping", "net", "scale"};

bool is_merged(std::string_view key) {
  return std::find(merged_tables.begin(), merged_tables.end(), key) != merged_tables.end();
}

/// Whether a table that stands beside a fabric refines the fabric's own: damping and the net always, bending where it
/// brings no law or numbers of its own, as `bending.form` alone does.
bool refines(std::string_view key, const toml::table& given) {
  if (key == "bending") return !given.contains("law") && !given.contains("rigidity") && !given.contains("coefficients");
  return is_merged(key);
}

/// Whether the table has a key that says otherwise what `key` would say.
bool has_alternative(const toml::table& material, std::string_view key) {
  for (const auto& ways : alternatives)
    for (const auto& way : ways) {
      if (std::find(way.begin(), way.end(), key) == way.end()) continue;
      for (const auto& other : ways)
        if (&other != &way &&
            std::any_of(other.begin(), other.end(), [&](const auto name) { return material.contains(name); }))
          return true;
    }
  return false;
}

/// Whether a setting of the command line has a part in the value.
bool is_set(const toml::node& node) {
  if (const auto* table = node.as_table())
    return std::any_of(table->begin(), table->end(), [](const auto& entry) { return is_set(entry.second); });
  if (const auto* list = node.as_array(); list != nullptr && std::any_of(list->begin(), list->end(), is_set))
    return true;
  const auto& source = node.source();
  return source.path && source.path->starts_with("--set ");
}

/// @param key  what the case calls it
toml::table read_fabric(const toml::node& name, const std::string& key, const std::filesystem::path& folder) {
  const FabricLibrary library(folder);
  const std::string written = name.as_string()->get();
  const SourceLine here = source_line(name.source(), key, {});
  const auto file = library.find(written);
  if (!file && written.ends_with(".toml"))
    throw CaseError(here, fmt::format("'{}' is not there (sought beside the case file)", written));
  if (!file) {
    const auto names = library.names();
    const auto near = nearest_name(written, names);
    throw CaseError(here,
                    fmt::format("there is no fabric '{}'; {}available: {}", written,
                                near.empty() ? "" : fmt::format("did you mean '{}'? ", near), fmt::join(names, ", ")));
  }
  const auto text = [&] {
    try {
      return read_text(*file);
    } catch (const std::system_error&) {
      throw CaseError(here, fmt::format("{} cannot be read", file->string()));
    }
  }();
  toml::table fabric = parse_toml(text, file->string());
  if (const auto* again = fabric.get("fabric"))
    throw CaseError(source_line(again->source(), "fabric", here), "a fabric cannot name another one");
  return fabric;
}

/// Moves what `from` has and `to` lacks. Only a move keeps the nodes' sources.
void move_missing(toml::table& from, toml::table& to, bool top) {
  const toml::table given = to;  // alternatives are those to what stood there before
  for (auto&& [key, node] : from) {
    auto* inner = node.as_table();
    auto* there = to.get(key.str());
    if (top && inner != nullptr && there != nullptr && there->is_table() && refines(key.str(), *there->as_table()))
      move_missing(*inner, *there->as_table(), false);
    else if (there == nullptr && !(top && has_alternative(given, key.str())))
      node.visit([&, &name = key](auto& value) { to.insert_or_assign(name, std::move(value)); });
  }
}

}  // namespace

bool names_fabric(const toml::table& owner) {
  const auto* material = owner.get_as<toml::table>("material");
  return material != nullptr && material->contains("fabric");
}

void include_fabric(toml::table& owner, const std::string& path, const std::filesystem::path& folder, bool overridden) {
  auto* material = owner.get_as<toml::table>("material");
  const auto* name = material ? material->get("fabric") : nullptr;
  if (name == nullptr || !name->is_string()) return;  // a fabric that is no name is for the checks to refuse
  toml::table fabric = read_fabric(*name, path + "material.fabric", folder);
  if (!fabric.contains("title")) fabric.insert("title", name->as_string()->get());
  material->erase("fabric");
  if (!overridden)
    for (auto entry = material->begin(); entry != material->end();)
      entry = is_merged(entry->first.str()) || is_set(entry->second) ? ++entry : material->erase(entry);
  move_missing(fabric, *material, true);
}

}  // namespace sundrape
