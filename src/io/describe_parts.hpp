#pragma once
#include "sundrape/io/case.hpp"

#include "case_description.hpp"

namespace sundrape {

/// Parts of describe(): one support, load or analysis each.
void describe_fix(CaseDescription& out, const FixCase& fix, std::size_t index);
void describe_motion(CaseDescription& out, const MotionCase& motion, std::size_t index);
/// A path with its timing, of the section "motion.path" or "obstacle.motion" at `path`.
void describe_course(CaseDescription& out, const std::string& section, const std::string& path, const PathCase& course);
void describe_load(CaseDescription& out, const LoadCase& load, std::size_t index);
void describe_dynamics(CaseDescription& out, const DynamicsCase& dynamics);
void describe_relaxation(CaseDescription& out, const RelaxationCase& relaxation);
void describe_arc_length(CaseDescription& out, const ArcLengthCase& path, int stages);
void describe_output(CaseDescription& out, const OutputCase& output, Model model);

}  // namespace sundrape
