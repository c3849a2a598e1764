// The graph's policy, vectorized over rows, if it depends on the last observation only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <targets/environments/layout.hpp>
#include <targets/environments/simd_kernel.hpp>
#include <vector>

namespace eagerx::environments {

template <class Graph>
class SimdAgent {
 public:
  using Action = typename Graph::Action;

  explicit SimdAgent(const SimdKernel<Graph>& kernel) : kernel_(kernel) {
    if (kernel.act == nullptr) return;
    std::vector<std::vector<Input>> fields;
    const Columns& columns = Layout<Graph>::get().observations;
    Layout<Graph>::for_each_observed([&](const char*, auto observed, const auto&) {
      using Observed = typename decltype(observed)::type;
      using Message = typename Observed::value_type;
      const std::size_t first = columns.first(fields.size());
      std::vector<Input>& field = fields.emplace_back();
      for (std::size_t i = 0; i < messages_of<Observed>() * size_of<Message>; ++i)
        field.push_back({first + i, seen<ScalarOf<Message>>});
    });
    for (const std::size_t* field = kernel.observations; inputs_.size() < kernel.inputs; ++field)
      inputs_.insert(inputs_.end(), fields[*field].begin(), fields[*field].end());
  }

  /// 1: one by one.
  std::uint32_t lanes() const { return kernel_.act != nullptr ? kernel_.lanes : 1; }
  /// Whether this number of answers is faster together than one by one.
  bool is_worth(std::uint32_t environments) const {
    constexpr std::uint32_t kOfLanes = 4;  // at most as much faster is a lane
    return environments * kOfLanes >= kernel_.lanes;
  }

  /// For SIMD groups of each thread of a pool at the same time.
  void make_room(unsigned members) {
    columns_.resize(members * inputs_.size() * kernel_.lanes);
    actions_.resize(std::size_t{members} * kernel_.lanes, Graph::zero());
  }

  void see(unsigned member, std::uint32_t lane, const float* row) {
    float* column = columns(member) + lane;
    for (const Input& input : inputs_) {
      *column = input.seen(row[input.column]);
      column += kernel_.lanes;
    }
  }
  /// The actions [lanes] for the last observations.
  const Action* act(unsigned member) {
    Action* const actions = actions_.data() + std::size_t{member} * kernel_.lanes;
    kernel_.act(columns(member), actions);
    return actions;
  }

 private:
  struct Input {
    std::size_t column;      // of a row
    float (*seen)(float x);  // as the message has it
  };
  template <class Scalar>
  static float seen(float x) {
    return static_cast<float>(from_row<Scalar>(x));
  }
  float* columns(unsigned member) {
    return columns_.data() + std::size_t{member} * inputs_.size() * kernel_.lanes;
  }

  SimdKernel<Graph> kernel_;
  std::vector<Input> inputs_;    // of the policy
  std::vector<float> columns_;   // [members][inputs][lanes]
  std::vector<Action> actions_;  // [members][lanes]
};

}  // namespace eagerx::environments
