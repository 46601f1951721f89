#pragma once
#include <functional>
#include <string>
#include <vector>

#include "sundrape/io/units.hpp"

namespace sundrape {

/// A number that an expression takes from a series of a result: `at(probe.tip.z, 0.3 s)`.
struct Reduction {
  std::string function;  // first, last, min, max, mean, range, argmin, argmax, at
  std::string series;    // "probe.tip.z": names with a dot are series
  double at = 0;         // of at(): time [s] or load factor
};

/// Names of the reductions, as messages and docs list them.
[[nodiscard]] const std::vector<std::string>& reduction_names();

/// Arithmetic over what a result holds: numbers by their names (`steps`), series by a reduction each, and whatever
/// muParser knows: + − * / ^, comparisons, `a ? b : c`, sqrt, abs, log10, min(a, b), ...
class Expression {
 public:
  /// @throws std::invalid_argument  what is wrong with the text, in one line
  Expression(std::string text, const Units& units);

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] const std::vector<Reduction>& reductions() const { return reductions_; }
  [[nodiscard]] const std::vector<std::string>& numbers() const { return numbers_; }
  /// The one reduction or number that is the whole expression; nothing if there is more to it.
  [[nodiscard]] const Reduction* single_reduction() const;
  [[nodiscard]] const std::string* single_number() const;

  /// Its value; not a number where it divides by zero and the like.
  [[nodiscard]] double evaluate(const std::function<double(const Reduction&)>& reduced,
                                const std::function<double(const std::string&)>& number) const;

 private:
  std::string text_;       // as it was written
  std::string rewritten_;  // with every reduction as a variable, which muParser takes
  std::vector<Reduction> reductions_;
  std::vector<std::string> numbers_;
};

}  // namespace sundrape
