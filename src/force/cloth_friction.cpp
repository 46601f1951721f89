#include "cloth_friction.hpp"

namespace sundrape {

ClothFriction::ClothFriction(const Separation& separation, const Vector3& normal,
                             const std::array<Vector3, 4>& velocities, double coefficient, double push,
                             const FrictionLaw& law, FrictionMatrix matrix)
    : separation_(separation),
      normal_(normal),
      relative_(Vector3::Zero()),
      coefficient_(coefficient),
      push_(push),
      along_(Matrix3::Identity() - normal * normal.transpose()) {
  for (std::size_t k = 0; k < 4; ++k) relative_ += separation.weights[k] * velocities[k];
  sliding_ = along_ * relative_;
  const double speed = sliding_.norm();
  over_speed_ = law.over_speed(speed);
  by_sliding_ = -coefficient * push * over_speed_ * Matrix3::Identity();
  if (matrix == FrictionMatrix::tangent)
    by_sliding_ -= coefficient * push * law.slope_over_speed(speed) * sliding_ * sliding_.transpose();
}

void ClothFriction::prepare_by_place(const std::array<Vector3, 4>& x, const std::array<Vector3, 4>& velocities,
                                     const SeparationHessian& turning, double slope, double pressure_area,
                                     const std::array<Vector3, 4>& crossing) {
  for (std::size_t a = 0; a < 2; ++a) {
    joint_[a] = slide_velocity_[a] = Vector3::Zero();
    for (std::size_t k = 0; k < 4; ++k) {
      joint_[a] += separation_.by_slide[a][k] * x[k];
      slide_velocity_[a] += separation_.by_slide[a][k] * velocities[k];
      slide_[a][k] = turning.slide_gradient(a, k);
    }
  }
  for (std::size_t l = 0; l < 4; ++l)
    push_gradient_[l] = -slope * separation_.weights[l] * normal_ + pressure_area * crossing[l];
}

Matrix3 ClothFriction::by_velocity(std::size_t k, std::size_t l) const {
  return separation_.weights[k] * separation_.weights[l] * by_sliding_ * along_;
}

Matrix3 ClothFriction::by_place(std::size_t k, std::size_t l) const {
  const auto& w = separation_.weights;
  Matrix3 by_way = w[l] * Matrix3::Identity(), velocity = Matrix3::Zero();  // ∂r/∂x_l, ∂(Σ w v)/∂x_l
  Vector3 weight = Vector3::Zero();                                         // ∂w_k/∂x_l
  for (std::size_t a = 0; a < 2; ++a) {
    by_way += joint_[a] * slide_[a][l].transpose();
    velocity += slide_velocity_[a] * slide_[a][l].transpose();
    weight += separation_.by_slide[a][k] * slide_[a][l];
  }
  const Matrix3 turn = along_ * by_way / separation_.distance;  // ∂n/∂x_l
  const Matrix3 sliding = along_ * velocity - normal_ * (relative_.transpose() * turn) - normal_.dot(relative_) * turn;
  const Vector3 force_by_push = -coefficient_ * over_speed_ * sliding_;
  const Matrix3 force = force_by_push * push_gradient_[l].transpose() + by_sliding_ * sliding;
  return w[k] * force + push_ * force_by_push * weight.transpose();
}

}  // namespace sundrape
