#pragma once
#include <array>
#include <vector>

#include "sundrape/force/load_course.hpp"
#include "sundrape/mesh/rigid_path.hpp"

namespace sundrape {

/// Points that are carried along a path: supports that move. Its course says how far they are.
struct PrescribedMotion {
  std::vector<int> points;
  std::array<bool, 3> components{true, true, true};  // that follow the path; the others are free or held elsewhere
  RigidPath path;
  LoadCourse course;
};

}  // namespace sundrape
