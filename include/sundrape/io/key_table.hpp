#pragma once
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace sundrape {

/// What may stand behind a key of a case file.
enum class KeyType {
  text,        // any string
  name,        // a string that can name a group of a result file: not empty, no '/', not "." or ".."
  file,        // a path, relative to the case file
  choice,      // one of the key's `choices`
  choices,     // a list of them, none twice
  number,      // a number or a quantity of the key's `unit`
  series,      // a number, or a list of one to `entries` of them, of the key's `unit`
  lists,       // one to `entries` plain numbers, or two such lists, of warp and weft
  quantity,    // a number or a quantity of a unit that another key says
  integer,     // a whole number
  boolean,     // true or false
  corners,     // two points, [[x, y, z], [x, y, z]], of the key's `unit`
  direction,   // three plain numbers, not all zero
  unit,        // a unit of the dimension of `unit`
  selector,    // a way to pick nodes: a set's name or a table as in the section `selector`
  table,       // a table with the keys of the section `holds`
  tables,      // an array of such tables
  pieces,      // one such table, or an array of them
  texts,       // a list of strings
  text_lists,  // a list of such lists
  values,      // a list of anything, or a table with the keys of the section `holds`
};

/// Accepted numbers, prints as "[0, 0.5)".
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_included = false, high_included = false;

  [[nodiscard]] bool contains(double x) const {
    return (low_included ? x >= low : x > low) && (high_included ? x <= high : x < high);
  }
  [[nodiscard]] bool bounded() const;
  [[nodiscard]] std::string text() const;
};

/// One input key: everything that reading, checking, printing and documenting it needs.
struct Key {
  std::string name = {};
  KeyType type = KeyType::number;
  std::string unit = "1";   // SI unit of numbers and of unit names; "1": a plain number
  bool scalar = true;       // a single number is accepted
  std::size_t entries = 0;  // a list of so many numbers is accepted; 0: no list
  Range range = {};
  std::vector<std::string> choices = {};
  std::vector<std::string> later = {};  // choices that are known, but not available in this version
  std::string holds = {};               // section of a table's keys
  std::string default_value = {};       // as TOML; empty: none
  std::string default_note = {};        // how it is worked out where it is not a constant
  bool required = false;                // in a section that is there
  bool available = true;                // false: known, but not in this version
  std::vector<std::string> kinds = {};  // values of the section's kind key that it belongs to; empty: all
  std::string doc = {};

  [[nodiscard]] bool belongs_to(std::string_view kind) const;
};

/// The keys of one table of the case file.
struct Section {
  std::string name = {};      // "material.net"
  std::string heading = {};   // as one writes it, for the reference: "[material] net = { ... }"
  std::string kind_key = {};  // the choice that decides which of the keys belong; empty: all do
  std::string doc = {};
  std::vector<Key> keys = {};

  /// The key of that name that belongs to `kind`, or null.
  [[nodiscard]] const Key* find(std::string_view key, std::string_view kind) const;
  /// Names of the keys that belong to `kind`, in the table's order.
  [[nodiscard]] std::vector<std::string> names(std::string_view kind) const;
};

/// Every key that a case file may have; the first section is the file's top level.
[[nodiscard]] const std::vector<Section>& key_table();

/// Every key that a study file may have; the first section is the file's top level.
[[nodiscard]] const std::vector<Section>& study_key_table();

/// Every key that a fit file may have; the first section is the file's top level.
[[nodiscard]] const std::vector<Section>& fit_key_table();

/// @throws std::invalid_argument  no such section
[[nodiscard]] const Section& key_section(std::string_view name, const std::vector<Section>& table = key_table());

/// A table as the reference part of its page in docs/.
[[nodiscard]] std::string key_table_markdown(const std::vector<Section>& table = key_table());

}  // namespace sundrape
