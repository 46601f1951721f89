#pragma once
#include <memory>
#include <string>
#include <string_view>

struct ut_system;

namespace sundrape {

/// Physical quantities as people write them, turned into SI numbers (UDUNITS-2 behind one handle).
///
/// Knows every unit of UDUNITS-2 ("cm", "gf/mm^2", "ozf/in^2", "1/s", "gf*cm^2/cm") and, besides, "deg" and "dyn".
class Units {
 public:
  /// Loads the units database. @throws std::runtime_error  if there is none
  Units();

  /// The value of `text` in `si_unit`, e.g. ("0.02665 gf/cm^2", "N/m^2") -> 2.613... A number without a unit is SI
  /// already.
  /// @throws std::invalid_argument  no number, not finite, an unknown unit, or another dimension than that of
  /// `si_unit`;
  ///                                the message quotes the text and says what is expected
  [[nodiscard]] double parse_quantity(std::string_view text, std::string_view si_unit) const;

  /// What one of a unit is in SI: 0.01 for "cm".
  /// @throws std::invalid_argument  an unknown unit
  [[nodiscard]] double in_si(std::string_view unit) const;

  /// What a quantity in this unit is, with its article: "a length" for "m", "a force per area" for "N/m^2".
  [[nodiscard]] std::string dimension(std::string_view si_unit) const;

 private:
  struct FreeSystem {
    void operator()(ut_system* system) const;
  };
  std::unique_ptr<ut_system, FreeSystem> system_;
};

}  // namespace sundrape
