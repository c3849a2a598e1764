// What a node sees of the rest of its graph: a linear system from each of its ticks to the next.
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/graph/plan/plan.hpp"

namespace eagerx::gen {

/// From tick i to the next, with u the message that is the input: x' = A·x + B·u, the node receives
/// C·x, and further ports send E·x + F·u in between.
struct PlantPhase {
  Eigen::MatrixXd a, b, c, e, f;
  std::size_t input_messages = 1;     // in between; u is the first
  std::vector<std::size_t> messages;  // of each further port
};

/// An element of what the node receives.
struct ReceivedElement {
  std::string input;
  std::size_t element = 0;
};

/// The plant as the node sees it, with delays, windows and holds: after the phases comes the first
/// again. x is the state of the program when the node is called.
struct NodePlant {
  double period_s = 0.0;  // of the node
  std::vector<std::string> state;
  std::vector<double> values;  // of the state, where it was linearized
  std::vector<ReceivedElement> received;
  std::vector<PlantPhase> phases;
  std::vector<std::string> losing, smoothing;  // as of a SampledSystem

  [[nodiscard]] Eigen::Index inputs() const { return phases.front().b.cols(); }
};

/// What the program of target linearize printed with `--node`; nothing if it is none of this
/// graph's.
std::optional<NodePlant> read_plant(std::string_view text, const Plan& plan);

/// The state that matters: what is received, or sent by further ports, depends on it. It never
/// stays as it is, whatever happens (a parameter). With `reached` it also depends on the input.
enum class Kept : unsigned char { seen, reached };
void reduce(NodePlant& plant, Kept kept);
/// Leaves out the other numbers of the state.
void keep(NodePlant& plant, const std::vector<bool>& keeps);

/// The product of the maps of all phases from `a`, the map of each.
Eigen::MatrixXd monodromy(const std::vector<Eigen::MatrixXd>& a);

}  // namespace eagerx::gen
