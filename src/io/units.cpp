#include "sundrape/io/units.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>
#include <udunits2.h>

namespace sundrape {
namespace {

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;

struct FreeConverter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
using Converter = std::unique_ptr<cv_converter, FreeConverter>;

constexpr std::string_view blanks = " \t";

std::string_view trim(std::string_view text) {
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool is_ascii(std::string_view text) {
  for (const char c : text)
    if (static_cast<unsigned char>(c) > 127) return false;
  return true;
}

/// Empty if the text is no unit.
Unit parse_unit(ut_system* system, std::string_view text) {
  const std::string name(trim(text));
  return Unit(ut_parse(system, name.c_str(), is_ascii(name) ? UT_ASCII : UT_UTF8));
}

// UDUNITS calls 1/s convertible to s (it inverts the number), so dimensions are compared by dividing instead.
bool same_dimension(const ut_unit* a, const ut_unit* b) {
  const Unit ratio(ut_divide(a, b));
  return ratio && ut_is_dimensionless(ratio.get()) != 0;
}

struct NamedDimension {
  const char* unit;
  const char* name;
};
constexpr std::array dimension_names{
    NamedDimension{"m", "a length"},
    NamedDimension{"m^2", "an area"},
    NamedDimension{"m^3", "a volume"},
    NamedDimension{"kg", "a mass"},
    NamedDimension{"s", "a time"},
    NamedDimension{"N", "a force"},
    NamedDimension{"N/m", "a force per length"},
    NamedDimension{"N/m^2", "a force per area"},
    NamedDimension{"N/m^3", "a force per volume"},
    NamedDimension{"N m", "a moment or a bending rigidity per width"},
    NamedDimension{"N m^2", "a bending rigidity"},
    NamedDimension{"m/N", "a length per force"},
    NamedDimension{"kg/m", "a mass per length"},
    NamedDimension{"kg/m^2", "a mass per area"},
    NamedDimension{"kg/m^3", "a mass per volume"},
    NamedDimension{"m/s", "a speed"},
    NamedDimension{"m/s^2", "an acceleration"},
    NamedDimension{"1/s", "a rate"},
    NamedDimension{"1/m", "a curvature"},
};

std::string dimension_of(ut_system* system, const ut_unit* unit, std::string_view written) {
  for (const auto& known : dimension_names)
    if (same_dimension(unit, parse_unit(system, known.unit).get())) return known.name;
  if (ut_is_dimensionless(unit) != 0) return written == "1" || written.empty() ? "a plain number" : "an angle";
  return fmt::format("of another dimension ({})", written);
}

/// Whether `word` stands in a unit on its own, not as a part of a longer name.
bool has_word(std::string_view text, std::string_view word) {
  const auto is_letter = [&](std::size_t i) {
    return i < text.size() && (std::isalpha(static_cast<unsigned char>(text[i])) != 0 || text[i] == '_');
  };
  for (auto at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1))
    if (!(at > 0 && is_letter(at - 1)) && !is_letter(at + word.size())) return true;
  return false;
}

/// The commonest slip with textile data: a gram, an ounce or a pound where its weight is meant.
std::string force_hint(ut_system* system, std::string_view written, const ut_unit* target) {
  struct Slip {
    const char* unit;
    const char* force;
    const char* what;
  };
  constexpr std::array slips{Slip{"oz", "ozf", "a fluid ounce"}, Slip{"g", "gf", "a mass"}, Slip{"kg", "kgf", "a mass"},
                             Slip{"lb", "lbf", "a mass"}};
  for (const auto& slip : slips) {
    if (!has_word(written, slip.unit)) continue;
    std::string meant(written);
    meant.replace(meant.find(slip.unit), std::string_view(slip.unit).size(), slip.force);
    const Unit forced = parse_unit(system, meant);
    if (forced && same_dimension(forced.get(), target))
      return fmt::format(" ('{}' is {}: write '{}' for the force)", slip.unit, slip.what, slip.force);
  }
  return {};
}

}  // namespace

void Units::FreeSystem::operator()(ut_system* system) const { ut_free_system(system); }

Units::Units() {
  ut_set_error_message_handler(ut_ignore);  // its complaints become exceptions here
  system_.reset(ut_read_xml(nullptr));
  if (!system_) throw std::runtime_error("the units database of UDUNITS-2 cannot be read");
  const auto alias = [&](const char* name, const char* meaning) {
    const Unit unit = parse_unit(system_.get(), meaning);
    ut_map_name_to_unit(name, UT_ASCII, unit.get());
    ut_map_name_to_unit(name, UT_UTF8, unit.get());
  };
  alias("deg", "degree");
  alias("dyn", "dyne");
}

std::string Units::dimension(std::string_view si_unit) const {
  return dimension_of(system_.get(), parse_unit(system_.get(), si_unit).get(), trim(si_unit));
}

double Units::in_si(std::string_view written) const {
  const Unit unit = parse_unit(system_.get(), written);
  if (!unit || trim(written).empty()) throw std::invalid_argument(fmt::format("unknown unit '{}'", written));
  // UDUNITS does not say what a unit's base is, so products of powers of base units are tried.
  constexpr int most = 4;
  for (int m = -most; m <= most; ++m)
    for (int kg = -most; kg <= most; ++kg)
      for (int s = -most; s <= most; ++s) {
        const Unit base = parse_unit(system_.get(), fmt::format("m^{} kg^{} s^{}", m, kg, s));
        if (!same_dimension(unit.get(), base.get())) continue;
        const Converter converter(ut_get_converter(unit.get(), base.get()));
        return cv_convert_double(converter.get(), 1);
      }
  throw std::invalid_argument(fmt::format("'{}' is no mechanical unit", written));
}

double Units::parse_quantity(std::string_view text, std::string_view si_unit) const {
  std::string_view rest = trim(text);
  if (rest.starts_with('+')) rest.remove_prefix(1);
  double number = 0;
  const auto [end, problem] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (problem == std::errc::invalid_argument)
    throw std::invalid_argument(fmt::format("'{}' does not begin with a number; {} is expected, e.g. \"1 {}\"", text,
                                            dimension(si_unit), si_unit));
  if (problem != std::errc() || !std::isfinite(number))
    throw std::invalid_argument(fmt::format("'{}' is not a finite number", text));

  const std::string_view written = trim(rest.substr(static_cast<std::size_t>(end - rest.data())));
  if (written.empty()) return number;
  // UDUNITS would multiply a second number in ("1 2 cm" is 2 cm); only the 1 of "1/s" is a unit.
  const bool stray_number =
      written.find_first_of("0123456789+-.") == 0 && !written.starts_with("1/") && !written.starts_with("1 /");
  const Unit unit = stray_number ? nullptr : parse_unit(system_.get(), written);
  if (!unit) throw std::invalid_argument(fmt::format("'{}': unknown unit '{}'", text, written));

  const Unit target = parse_unit(system_.get(), si_unit);
  if (!same_dimension(unit.get(), target.get()))
    throw std::invalid_argument(fmt::format("'{}' is {}, {} is expected{}", text,
                                            dimension_of(system_.get(), unit.get(), written), dimension(si_unit),
                                            force_hint(system_.get(), written, target.get())));
  const Converter converter(ut_get_converter(unit.get(), target.get()));
  const double value = cv_convert_double(converter.get(), number);
  if (!std::isfinite(value)) throw std::invalid_argument(fmt::format("'{}' is not a finite number", text));
  return value;
}

}  // namespace sundrape
