#pragma once
#include "sundrape/io/study.hpp"

#include "case_section.hpp"

namespace sundrape {

/// More values of an axis, or runs of a study, are a slip.
constexpr std::size_t most_study_runs = 100000;

/// One `[[axis]]` of a study. @throws CaseError
[[nodiscard]] StudyAxis read_axis(const CaseSection& section);

}  // namespace sundrape
