#pragma once
#include <array>
#include <vector>

#include "sundrape/force/path_course.hpp"

namespace sundrape {

/// Points that are carried along a path: supports that move.
struct PrescribedMotion {
  std::vector<int> points;
  std::array<bool, 3> components{true, true, true};  // that follow the path; the others are free or held elsewhere
  PathCourse course;
  std::vector<int> directions = {};  // points that turn with it: directors of a shell
};

/// All prescribed motions of a system. A point may take part in several: these follow each other, the first in the list
/// first. What a motion carries may change in time.
class PrescribedMotions {
 public:
  PrescribedMotions() = default;
  /// @param points  of the system, P
  PrescribedMotions(std::vector<PrescribedMotion> motions, int points);

  [[nodiscard]] bool empty() const { return motions_.empty(); }
  [[nodiscard]] const PrescribedMotion& operator[](std::size_t motion) const { return motions_[motion]; }
  /// Whether a motion carries anything.
  [[nodiscard]] bool carries(std::size_t motion) const {
    return !motions_[motion].points.empty() || !motions_[motion].directions.empty();
  }
  /// Makes wherever carried points rest in `rest` (3P) the place from which their motions lead to where they are in q
  /// (3P) at a time.
  void rest_from(double time, ConstVectorRef q, VectorRef rest) const;
  /// Has a motion carry other points from a time on. Wherever points that it carried or will carry rest in `rest` (3P)
  /// becomes the place from which the motions of each lead to where it is in q (3P) now.
  void carry_instead(std::size_t motion, std::vector<int> points, std::vector<int> directions, double time,
                     ConstVectorRef q, VectorRef rest);
  /// Puts the carried components of q (3P) where they are at a time (or a load factor of a stage), starting from where
  /// they rest; no other entry changes.
  void place(double time, int stage, ConstVectorRef rest, VectorRef q) const;
  /// The same with their rates in v (3P).
  void place(double time, ConstVectorRef rest, VectorRef q, VectorRef v) const;
  /// Accelerations of the carried components [m/s²], 3P, zero elsewhere: differences of rates over a microsecond.
  [[nodiscard]] Vector acceleration(double time, ConstVectorRef rest) const;

 private:
  struct Carried {
    int point = 0;
    bool direction = false;
    std::vector<std::size_t> motions;  // in their order
  };
  void list_carried();
  void rest_from(double time, ConstVectorRef q, VectorRef rest, const std::vector<bool>& which) const;
  template <class Visit>
  void visit(double time, int stage, ConstVectorRef rest, Visit&& visit) const;

  std::vector<PrescribedMotion> motions_;
  std::vector<Carried> carried_;
  int points_ = 0;
};

}  // namespace sundrape
