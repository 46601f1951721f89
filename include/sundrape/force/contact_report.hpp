#pragma once
#include <algorithm>

namespace sundrape {

/// How the cloth stands to what it touches at one instant.
struct ContactReport {
  int contacts = 0;                // points, or nodes and edges, that press on something
  int sliding = 0;                 // of these, those whose friction has its full size
  double deepest_penetration = 0;  // into an obstacle, or of what is nearer than the thickness to other cloth [m]
  double fastest_creep = 0;        // of those that friction holds [m/s]

  /// Counts what another kind of contact reports, too.
  void include(const ContactReport& other) {
    contacts += other.contacts;
    sliding += other.sliding;
    deepest_penetration = std::max(deepest_penetration, other.deepest_penetration);
    fastest_creep = std::max(fastest_creep, other.fastest_creep);
  }
  /// Counts the friction of something that presses: held by it, or sliding.
  void count_friction(double speed, double fastest_held) {
    if (speed < fastest_held)
      fastest_creep = std::max(fastest_creep, speed);
    else
      ++sliding;
  }
};

}  // namespace sundrape
