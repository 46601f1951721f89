#pragma once
#include "sundrape/types.hpp"

namespace sundrape {

/// How air flows where the cloth is: everywhere alike, and in gusts.
struct WindField {
  Vector3 velocity = Vector3::Zero();  // its mean [m/s]
  Vector3 gust = Vector3::Zero();      // largest change of it by gusts [m/s]
  double period = 1;                   // of the slowest of them [s]
  unsigned seed = 1;                   // of their phases

  /// At a time: the mean and  gust · Σ sin(2π r_k t/T + φ_k)/3  with r = 1, √3, √7, which never repeats.
  [[nodiscard]] Vector3 at(double time) const;
};

/// What the air does to a plate.
struct AirCoefficients {
  double density = 1.2;  // ρ [kg/m³]
  double drag = 1.2;     // C_d of a plate across the flow
  double lift = 1;       // C_l: a plate at the angle α to the flow has the lift coefficient C_l sin α cos α
};

}  // namespace sundrape
