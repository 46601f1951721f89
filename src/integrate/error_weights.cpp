#include "sundrape/integrate/error_weights.hpp"

namespace sundrape {

void ErrorWeights::evaluate(ConstVectorRef y, VectorRef weights) const {
  const Eigen::Index n = start.size();
  for (Eigen::Index k = 0; k < n; k += 3) {
    const double way = (y.segment<3>(k) - start.segment<3>(k)).norm(), speed = y.segment<3>(n + k).norm();
    weights.segment<3>(k).setConstant(1 / (rtol * way + atol_position));
    const double slack = rate_slack.size() > 0 ? rate_slack[k / 3] : 1.0;
    weights.segment<3>(n + k).setConstant(1 / (slack * (rtol * speed + atol_velocity)));
  }
}

}  // namespace sundrape
