// The closed loop in time, when a step is added at the opened port.
#include <algorithm>
#include <cmath>

#include "generator/tools/linear/modes.hpp"
#include "generator/tools/linear/open_loop.hpp"

namespace eagerx::gen {
namespace {

using Eigen::Index;
constexpr std::size_t kFewest = 40, kMost = 20'000;  // messages

/// Messages until the slowest pole of the closed loop has settled, or an unstable one has grown.
std::size_t messages_until_settled(const Eigen::VectorXcd& poles, std::size_t messages_a_period) {
  constexpr double kTimeConstants = 6.0;
  double slowest = 0.0;  // hyperperiods
  for (const std::complex<double> z : poles) {
    const double magnitude = std::abs(z);
    if (is_integrator(z) || magnitude < 1e-6) continue;
    slowest = std::max(slowest, 1.0 / std::abs(std::log(magnitude)));
  }
  const double messages = kTimeConstants * slowest * static_cast<double>(messages_a_period);
  return static_cast<std::size_t>(std::clamp(std::ceil(messages), double{kFewest}, double{kMost}));
}

}  // namespace

std::vector<StepSample> step_response_of(const SampledSystem& system) {
  const OpenLoop loop(system);
  const Index m = loop.c.rows();
  // What returns in a message may depend on the messages before it in the same hyperperiod.
  const auto returned = (Eigen::MatrixXd::Identity(m, m) - loop.d).partialPivLu();
  const Eigen::VectorXd added = Eigen::VectorXd::Ones(m);
  const std::size_t count = messages_until_settled(poles_of(loop.closed(0)), system.opened);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(loop.a.rows());
  std::vector<StepSample> samples;
  while (samples.size() < count) {
    const Eigen::VectorXd y = returned.solve(loop.c * x + loop.d * added);
    const Eigen::VectorXd u = y + added;
    x = loop.a * x + loop.b * u;
    for (Index i = 0; i < m; ++i)
      samples.push_back({loop.message_s * static_cast<double>(samples.size()), u[i], -y[i]});
    if (!x.allFinite()) break;
  }
  return samples;
}

}  // namespace eagerx::gen
