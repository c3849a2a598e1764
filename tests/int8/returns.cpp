// Prints the mean return of the swing-up example over SEEDS episodes of 100 steps, by the cost that
// its policy was trained with.
#include <cmath>
#include <cstdio>
#include <eagerx/trace.hpp>
#include <targets/common/run.hpp>

#include "pendulum_swing_up/graph.hpp"

namespace {

using graphs::pendulum_swing_up::Graph;

struct Return : eagerx::target::Watch<Graph> {
  double cost = 0.0;
  void step(std::uint32_t /*episode*/, eagerx::Seq /*step*/, const Action& action,
            const Observation& observation, const Outcome& /*outcome*/) {
    const double theta = std::atan2(static_cast<double>(observation.angle.back()[1]),
                                    static_cast<double>(observation.angle.back()[0]));
    const auto theta_dot = static_cast<double>(observation.theta_dot.back());
    const auto voltage = static_cast<double>(action.voltage[0]);
    cost += theta * theta + 0.1 * theta_dot * theta_dot + 0.01 * voltage * voltage;
  }
};

}  // namespace

int main() {
  const eagerx::target::RunPlan plan{.episodes = SEEDS, .steps = 100, .seed = 1};
  constinit static Graph::Program<eagerx::HashTrace> program{};
  const auto agent = [](eagerx::EpisodeKey /*key*/, eagerx::Seq /*step*/,
                        const Graph::Observation& observation) {
    return Graph::policy(observation);
  };
  Return episodes;
  eagerx::target::run_episodes<Graph>(plan, program, agent, episodes);
  std::printf("%.9f\n", -episodes.cost / SEEDS);
}
