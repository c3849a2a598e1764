// The loop of a sampled system that is opened at a port, as matrices.
#pragma once

#include <cstddef>

#include "generator/tools/linear/matrices.hpp"

namespace eagerx::gen {

/// y = C·x + D·u of the opened port. With several messages a hyperperiod, u and y are vectors of
/// them (lifting).
struct OpenLoop {
  Eigen::MatrixXd a, b, c, d;
  double message_s = 0.0;  // from one message to the next

  explicit OpenLoop(const SampledSystem& system)
      : a(matrix_of(system.a, system.state.size())),
        b(matrix_of(system.b, system.inputs.size())
              .rightCols(static_cast<Eigen::Index>(system.opened))),
        c(matrix_of(system.c, system.state.size())
              .bottomRows(static_cast<Eigen::Index>(system.opened))),
        d(matrix_of(system.d, system.inputs.size())
              .bottomRightCorner(static_cast<Eigen::Index>(system.opened),
                                 static_cast<Eigen::Index>(system.opened))),
        message_s(system.period_s / static_cast<double>(system.opened)) {}

  /// The map of a hyperperiod with u[k] = y[k - delay]: of the state and the messages on their way.
  [[nodiscard]] Eigen::MatrixXd closed(std::size_t delay) const {
    // Message i of a hyperperiod is u[i]; y[i] goes to u[i + delay], of this one or of a later.
    const Eigen::Index n = a.rows(), m = c.rows(), q = static_cast<Eigen::Index>(delay);
    // z = [x, the last `delay` messages of y, oldest first]; u = S·z + R·y.
    Eigen::MatrixXd s = Eigen::MatrixXd::Zero(m, n + q), r = Eigen::MatrixXd::Zero(m, m);
    for (Eigen::Index i = 0; i < m; ++i) {
      if (i < q)
        s(i, n + i) = 1.0;
      else
        r(i, i - q) = 1.0;
    }
    Eigen::MatrixXd cz = Eigen::MatrixXd::Zero(m, n + q), az = Eigen::MatrixXd::Zero(n, n + q);
    cz.leftCols(n) = c;
    az.leftCols(n) = a;
    const Eigen::MatrixXd y =
        (Eigen::MatrixXd::Identity(m, m) - d * r).partialPivLu().solve(cz + d * s);
    Eigen::MatrixXd next(n + q, n + q);
    next.topRows(n) = az + b * (s + r * y);
    for (Eigen::Index k = 0; k < q; ++k) {
      const Eigen::Index at = k + m;  // of the old messages and then those of y
      if (at < q)
        next.row(n + k) = Eigen::RowVectorXd::Unit(n + q, n + at);
      else
        next.row(n + k) = y.row(at - q);
    }
    return next;
  }
};

}  // namespace eagerx::gen
