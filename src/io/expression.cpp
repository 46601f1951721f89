#include "sundrape/io/expression.hpp"

#include <algorithm>
#include <limits>
#include <regex>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>

#include "sundrape/io/nearest_name.hpp"

namespace sundrape {
namespace {

std::string variable_name(std::size_t k) { return fmt::format("reduction_{}_", k); }

/// One reduction: its function, its series, and what follows a comma. Names of probes and sets may hold dashes, which
/// are no minus here: nothing can be subtracted from a series.
const std::regex& reduction_pattern() {
  static const std::regex pattern(R"(\b([A-Za-z_]\w*)\s*\(\s*([A-Za-z_][\w-]*(?:\.[\w-]+)+)\s*(?:,\s*([^(),]*))?\))");
  return pattern;
}

Reduction read_reduction(const std::smatch& match, const Units& units) {
  Reduction reduction{.function = match[1], .series = match[2]};
  const auto& known = reduction_names();
  if (std::ranges::find(known, reduction.function) == known.end()) {
    const auto near = nearest_name(reduction.function, known);
    throw std::invalid_argument(
        fmt::format("'{}' makes no number of the series '{}'{}; accepted: {}", reduction.function, reduction.series,
                    near.empty() ? "" : fmt::format(", did you mean '{}'?", near), fmt::join(known, ", ")));
  }
  const bool has_place = match[3].matched;
  if (has_place != (reduction.function == "at"))
    throw std::invalid_argument(
        has_place ? fmt::format("{}({}) takes nothing besides the series", reduction.function, reduction.series)
                  : fmt::format("at({}) needs to know when: at({}, 0.3 s)", reduction.series, reduction.series));
  if (has_place) reduction.at = units.parse_quantity(match[3].str(), "s");
  return reduction;
}

mu::Parser parser() {
  mu::Parser p;
  p.DefineNameChars("0123456789_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ.");
  return p;
}

/// muParser's messages, without what speaks of expressions that nobody wrote.
[[noreturn]] void fail(const std::string& text, const mu::ParserError& problem) {
  throw std::invalid_argument(fmt::format("'{}' cannot be read: {}", text, problem.GetMsg()));
}

}  // namespace

const std::vector<std::string>& reduction_names() {
  static const std::vector<std::string> names{"at", "first", "last", "min", "max", "mean", "range", "argmin", "argmax"};
  return names;
}

Expression::Expression(std::string text, const Units& units) : text_(std::move(text)) {
  auto from = text_.cbegin();
  for (std::smatch match; std::regex_search(from, text_.cend(), match, reduction_pattern());
       from = match.suffix().first) {
    rewritten_ += match.prefix().str() + variable_name(reductions_.size());
    reductions_.push_back(read_reduction(match, units));
  }
  rewritten_.append(from, text_.cend());
  try {
    auto p = parser();
    p.SetExpr(rewritten_);
    for (const auto& [name, unused] : p.GetUsedVar()) {
      if (name.starts_with("reduction_")) continue;
      if (name.find('.') != std::string::npos)
        throw std::invalid_argument(
            fmt::format("'{}' is a series: say which number of it is meant, last({}) or one of {}", name, name,
                        fmt::join(reduction_names(), ", ")));
      numbers_.push_back(name);
    }
  } catch (const mu::ParserError& problem) {
    fail(text_, problem);
  }
}

const Reduction* Expression::single_reduction() const {
  const auto trimmed = std::regex_replace(rewritten_, std::regex(R"(\s)"), "");
  return reductions_.size() == 1 && trimmed == variable_name(0) ? &reductions_.front() : nullptr;
}

const std::string* Expression::single_number() const {
  const auto trimmed = std::regex_replace(rewritten_, std::regex(R"(\s)"), "");
  return numbers_.size() == 1 && trimmed == numbers_.front() ? &numbers_.front() : nullptr;
}

double Expression::evaluate(const std::function<double(const Reduction&)>& reduced,
                            const std::function<double(const std::string&)>& number) const {
  std::vector<double> values;
  values.reserve(reductions_.size() + numbers_.size());
  for (const auto& reduction : reductions_) values.push_back(reduced(reduction));
  for (const auto& name : numbers_) values.push_back(number(name));
  try {
    auto p = parser();
    for (std::size_t k = 0; k < reductions_.size(); ++k) p.DefineVar(variable_name(k), &values[k]);
    for (std::size_t k = 0; k < numbers_.size(); ++k) p.DefineVar(numbers_[k], &values[reductions_.size() + k]);
    p.SetExpr(rewritten_);
    return p.Eval();
  } catch (const mu::ParserError&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace sundrape
