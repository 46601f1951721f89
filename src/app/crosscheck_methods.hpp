#pragma once
#include <string>
#include <vector>

#include "sundrape/app/model.hpp"

namespace sundrape {

/// A way to an equilibrium, as settings of a case.
struct Method {
  std::string name;  // of its analysis, too
  std::vector<std::string> sets = {};
};

/// Every method of a crosscheck for a case, the one that others are held against first.
[[nodiscard]] std::vector<Method> crosscheck_methods(const Case& c, const CaseModel& model);

/// What all methods have in common: the same imperfection, where the case leaves that to the analysis.
[[nodiscard]] std::vector<std::string> common_settings(const Case& c);

}  // namespace sundrape
