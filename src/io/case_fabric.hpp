#pragma once
#include <filesystem>
#include <string>

#include <toml++/toml.h>

namespace sundrape {

/// Whether the material of a case, or of a piece of cloth, names a fabric of the library.
[[nodiscard]] bool names_fabric(const toml::table& owner);

/// Writes the values of the fabric that `material.fabric` names into the material, so that the case stands on its own;
/// does nothing where there is none.
///
/// A key beside `fabric` replaces the fabric's; one of the alternatives of which a material has one (weight or a
/// density, one modulus or three) replaces the others. `damping` and `net` are merged key by key. Every value keeps
/// where it comes from, for errors.
/// @param path        what the keys of the owner begin with: "" or "cloth.1."
/// @param folder      that of the case file
/// @param overridden  false: the file spells its material out and a setting puts a fabric in its place, of which only
///                    other settings, `damping` and `net` are spared
/// @throws CaseError  no such fabric, or its file is not TOML
void include_fabric(toml::table& owner, const std::string& path, const std::filesystem::path& folder, bool overridden);

}  // namespace sundrape
