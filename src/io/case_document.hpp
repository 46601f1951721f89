#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "sundrape/io/case.hpp"

namespace sundrape {

/// Parses a case, puts the settings KEY.PATH=VALUE of the command line into it, and then the values of the fabric that
/// it names.
///
/// Every node and key keeps where it comes from: the file's or the fabric's line, or the setting's own text.
/// @throws CaseError  TOML syntax, a malformed setting or one whose path leads nowhere, no such fabric
[[nodiscard]] toml::table parse_document(std::string_view text, const std::string& file,
                                         const std::vector<std::string>& sets);

/// Where a node or key stands; `fallback` if it was not read from anywhere.
[[nodiscard]] SourceLine source_line(const toml::source_region& region, std::string key, const SourceLine& fallback);

/// Like toml::parse, but what goes wrong is a CaseError.
[[nodiscard]] toml::table parse_toml(std::string_view text, const std::string& file);

}  // namespace sundrape
