#include "sundrape/material/plate_bending.hpp"

#include <stdexcept>

#include <Eigen/Cholesky>

namespace sundrape {

PlateBending::PlateBending(const Eigen::Matrix3d& rigidity) : rigidity_(rigidity) {
  const bool symmetric =
      (rigidity - rigidity.transpose()).cwiseAbs().maxCoeff() <= 1e-12 * rigidity.cwiseAbs().maxCoeff();
  if (!rigidity.allFinite() || !symmetric || Eigen::LLT<Eigen::Matrix3d>(rigidity).info() != Eigen::Success)
    throw std::invalid_argument("the bending rigidities of a sheet must be symmetric and positive definite [N m]");
}

PlateBending::PlateBending(Form form, const MomentCurvature& warp, const MomentCurvature& weft, double poisson)
    : form_(form), warp_(warp), weft_(weft), poisson_(poisson) {
  if (form == Form::linear) throw std::invalid_argument("a linear sheet is given by its rigidities");
  if (!(poisson >= 0 && poisson < 0.5)) throw std::invalid_argument("Poisson's ratio must lie in [0, 0.5)");
  const double b1 = warp.initial_rigidity(), b2 = weft.initial_rigidity(), mean = 0.5 * (b1 + b2);
  rigidity_ = Eigen::Vector3d(b1, b2, 0.5 * (1 - poisson) * mean).asDiagonal();
  rigidity_(0, 1) = rigidity_(1, 0) = poisson * mean;
  rigidity_ /= 1 - poisson * poisson;
  if (Eigen::LLT<Eigen::Matrix3d>(rigidity_).info() != Eigen::Success)
    throw std::invalid_argument(
        "the bending of warp and weft differs too much for Poisson's ratio: the sheet would give energy back");
}

}  // namespace sundrape
