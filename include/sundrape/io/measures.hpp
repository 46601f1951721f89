#pragma once
#include <memory>
#include <string>
#include <vector>

#include "sundrape/io/case.hpp"
#include "sundrape/io/expression.hpp"
#include "sundrape/io/result_reader.hpp"

/// What expressions may ask of a result, by name.
namespace sundrape {

/// A number or a family of series that results have.
struct MeasureInfo {
  std::string name;  // of series with what varies in capitals: "probe.NAME.x"
  std::string unit;  // SI; "1": a plain number; empty: several
  std::string doc;
  bool timing = false;  // seconds of this very run: another one has others
};

/// Numbers that results may have, each analysis some of them: the statistics by their names, and a few of the mesh.
[[nodiscard]] const std::vector<MeasureInfo>& number_catalogue();
/// Kinds of series.
[[nodiscard]] const std::vector<MeasureInfo>& series_catalogue();

/// The name of a probe or a set as expressions write it: letters, digits, - and _, and _ for everything else.
[[nodiscard]] std::string as_word(const std::string& name);

/// The entry of a number or of a series of a case.
/// @param with_reference  whether there is another result that `reference.*` can be held against
/// @throws std::invalid_argument  no such measure of this case; the message says which there are
[[nodiscard]] const MeasureInfo& measure_info(const std::string& name, const Case& c, bool with_reference);

/// A quantity over the frames, or over the steps, of a run.
struct MeasureSeries {
  std::vector<double> variable = {};  // time [s] or load factor, ascending but for load factors
  std::vector<double> value = {};     // SI
  std::vector<double> rate = {};      // d value / d variable where it is known; or empty
};

/// The number that a reduction takes from a series. `at` goes between two entries by a cubic where rates are known and
/// by a straight line otherwise, `mean` weighs by the variable.
/// @throws std::invalid_argument  no entries, or `at` is outside of them
[[nodiscard]] double reduce(const MeasureSeries& series, const Reduction& reduction);

/// What one result measures.
class Measures {
 public:
  /// @param reference  what `reference.*` are distances from; may be null. Both must outlive this.
  explicit Measures(const ResultReader& result, const ResultReader* reference = nullptr);

  /// @throws std::invalid_argument  the result has no such number or series; FileError  it cannot be read
  [[nodiscard]] double number(const std::string& name) const;
  [[nodiscard]] MeasureSeries series(const std::string& name) const;

 private:
  const ResultReader& result_;
  const ResultReader* reference_;
};

}  // namespace sundrape
