// Messages that SIMD groups need not keep.
#include "generator/graph/plan/vectorized.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/unit/graph_of_text.hpp"

namespace eagerx::gen {
namespace {

/// "speed.u" and others, a line each, without those that an engine node says it has applied.
std::string passing(const std::string& text) {
  const auto graph = graph_of_text(text);
  Plan plan = *graph->plan;
  plan.schedule = vectorized_schedule(plan);
  const std::vector<bool> passes = passing_rings(plan);
  EXPECT_EQ(passes.size(), plan.rings.size());
  std::string names;
  for (std::size_t r = 0; r < passes.size(); ++r) {
    const Ring& ring = plan.rings[r];
    const GraphNode& node = plan.graph->nodes[ring.node];
    if (!passes[r] || node.outputs[ring.output].name == "action_applied") continue;
    names += (node.role == NodeRole::environment ? "actions" : node.name) + "." +
             node.outputs[ring.output].name + "\n";
  }
  return names;
}

const std::string kHead =
    "name: cascade\nrate: 100\nengine: {type: OdeEngine, rate: 1000}\n"
    "objects:\n  motor: {type: DcMotor, sensors: {theta: {rate: 1000}, theta_dot: {rate: 1000}},\n"
    "          actuators: {u: {rate: 1000}}}\n"
    "nodes:\n"
    "  position: {type: PidController, rate: 200, config: {kp: 8, low: -40, high: 40},\n"
    "             inputs: [measured, setpoint]}\n"
    "  speed: {type: PidController, rate: 500, config: {kp: 0.3, low: -12, high: 12},\n"
    "          inputs: [measured, setpoint]}\n"
    "actions: {angle: {space: {dtype: float32, shape: [1], low: -3, high: 3}}}\n"
    "observations: [theta]\n"
    "connections:\n"
    "  - {from: actions.angle, to: position.setpoint}\n"
    "  - {from: motor.theta, to: observations.theta}\n"
    "  - {from: motor.theta, to: position.measured}\n"
    "  - {from: motor.theta_dot, to: speed.measured}\n"
    "  - {from: speed.u, to: motor.u}\n";

TEST(PassingRings, AreReadOnlyBehindTheirWritersInEveryStep) {
  // The speed is not among them: it goes to what comes behind the environment in the next step. Nor
  // is the angle, which is observed.
  EXPECT_EQ(passing(kHead + "  - {from: position.u, to: speed.setpoint}\n"),
            "actions.angle\nengine.tick\nposition.u\nspeed.u\nmotor/x.observation\n");
}

TEST(PassingRings, OlderMessagesStay) {
  EXPECT_EQ(passing(kHead + "  - {from: position.u, to: speed.setpoint, delay: 20 ms}\n"),
            "actions.angle\nengine.tick\nspeed.u\nmotor/x.observation\n");
}

TEST(PassingRings, ASlowerWriterMayBeSilentInAStep) {
  std::string text = kHead + "  - {from: position.u, to: speed.setpoint}\n";
  text.replace(text.find("rate: 200"), 9, "rate: 50");
  EXPECT_EQ(passing(text), "") << "a step is not a hyperperiod";
}

}  // namespace
}  // namespace eagerx::gen
