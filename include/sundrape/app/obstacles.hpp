#pragma once
#include <memory>

#include "sundrape/force/obstacle_contact.hpp"
#include "sundrape/io/case.hpp"
#include "sundrape/io/result.hpp"

namespace sundrape {

/// An obstacle of a case as contact sees it, and as a viewer does.
struct BuiltObstacle {
  ContactBody body;
  ObstacleRecord record;
};

[[nodiscard]] PathCourse course_of(const PathCase& path);

/// @throws CaseError  a shape that cannot be built, with the obstacle's line
[[nodiscard]] BuiltObstacle build_obstacle(const ObstacleCase& c);

}  // namespace sundrape
