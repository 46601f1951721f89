#pragma once
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "sundrape/io/case.hpp"
#include "sundrape/io/key_table.hpp"
#include "sundrape/io/units.hpp"

namespace sundrape {

/// What all sections of one reading share.
class ReadingContext {
 public:
  /// @param table  the keys of the kind of file that is read; must outlive the context
  explicit ReadingContext(const std::vector<Section>& table = key_table());
  [[nodiscard]] const Units& units() const { return units_; }
  [[nodiscard]] const std::vector<Section>& table() const { return *table_; }
  /// Null if the key has no constant default.
  [[nodiscard]] const toml::node* default_of(const Key& key) const;

 private:
  const std::vector<Section>* table_;
  Units units_;
  std::map<const Key*, toml::table> defaults_;
};

/// One table of a case, read by the rules of its section in the key table.
///
/// A table that the case leaves out reads as an empty one. Every reader returns the default where the case says
/// nothing; `maybe_number` returns nothing where there is neither. All throw CaseError on a value that its key does not
/// accept, and std::logic_error on a name that the key table does not have.
class CaseSection {
 public:
  CaseSection(const ReadingContext& context, const Section& section, const toml::table* table, SourceLine source);

  /// Every key known, available and accepted, every required one there; likewise in the tables within.
  void check() const;

  [[nodiscard]] bool has(std::string_view name) const;
  [[nodiscard]] double number(std::string_view name) const { return numbers(name).front(); }
  [[nodiscard]] std::optional<double> maybe_number(std::string_view name) const;
  [[nodiscard]] std::vector<double> numbers(std::string_view name) const;
  /// In SI, of a unit that the key table does not say.
  [[nodiscard]] std::optional<double> maybe_quantity(std::string_view name, const std::string& unit) const;
  [[nodiscard]] std::vector<double> series(std::string_view name) const;              // one or more
  [[nodiscard]] std::vector<std::vector<double>> lists(std::string_view name) const;  // one or two
  [[nodiscard]] int integer(std::string_view name) const { return static_cast<int>(integers(name).front()); }
  [[nodiscard]] std::vector<std::int64_t> integers(std::string_view name) const;
  [[nodiscard]] Vector3 vector3(std::string_view name) const;
  [[nodiscard]] Vector3 direction(std::string_view name) const;  // of unit length
  [[nodiscard]] bool boolean(std::string_view name) const;
  [[nodiscard]] std::string text(std::string_view name) const;  // also of a choice, a name, a file
  [[nodiscard]] std::vector<std::string> choices(std::string_view name) const;
  [[nodiscard]] std::vector<std::string> texts(std::string_view name) const;
  [[nodiscard]] std::vector<std::vector<std::string>> text_lists(std::string_view name) const;
  /// The entries of a list as TOML text; nothing if it is a range: a table, which table() reads.
  [[nodiscard]] std::optional<std::vector<std::string>> listed_values(std::string_view name) const;
  [[nodiscard]] double unit(std::string_view name) const;    // what one of it is in SI
  [[nodiscard]] InBox corners(std::string_view name) const;  // low and high, in whichever order given
  [[nodiscard]] Selector selector(std::string_view name) const;
  [[nodiscard]] CaseSection table(std::string_view name) const;
  [[nodiscard]] std::vector<CaseSection> tables(std::string_view name) const;

  /// A continuous number, wherever it stands in this table or those within.
  struct Parameter {
    double value;      // SI
    std::string unit;  // SI
    Range range;
    SourceLine source;
  };
  /// @throws std::invalid_argument  a path that leads to no continuous number
  [[nodiscard]] Parameter parameter(std::span<const std::string> path) const;

  [[nodiscard]] const SourceLine& source() const { return source_; }
  [[nodiscard]] SourceLine source(std::string_view name) const;  // the section's own where the key is left out
  [[noreturn]] void fail(std::string_view name, const std::string& message) const;

 private:
  [[nodiscard]] std::string kind() const;
  [[nodiscard]] const Key& key(std::string_view name) const;
  [[nodiscard]] const toml::node* given(std::string_view name) const;
  [[nodiscard]] const toml::node& value(std::string_view name) const;
  [[nodiscard]] std::string path(std::string_view name) const;
  [[nodiscard]] std::vector<std::string> texts_of(const toml::node& node, const std::string& where) const;
  [[nodiscard]] double scalar(const Key& key, const toml::node& node) const;
  [[nodiscard]] std::vector<double> list(const Key& key, const toml::array& array) const;
  [[nodiscard]] std::vector<double> short_list(const Key& key, const toml::array& array) const;
  [[nodiscard]] Parameter number_at(const Key& key, std::span<const std::string> rest) const;
  void check_known(const toml::key& name, const std::string& kind) const;
  void check_value(const Key& key) const;
  void check_required(const std::string& kind) const;

  const ReadingContext* context_;
  const Section* section_;
  const toml::table* table_;  // null: left out
  SourceLine source_;
};

}  // namespace sundrape
