// The graph's agent, over rows of numbers: eagerx_act().
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/random.hpp>
#include <eagerx/rate.hpp>
#include <memory>
#include <string>
#include <targets/common/run.hpp>
#include <targets/environments/base/problem.hpp>
#include <targets/environments/layout.hpp>
#include <targets/environments/simd_agent.hpp>
#include <type_traits>
#include <vector>

namespace eagerx::environments {

/// Converts rows back into observations. A policy's inputs are float32 for every type of
/// observation, so a row has everything that it needs.
template <class Graph>
class SeenRows {
 public:
  using Observation = typename Graph::Observation;

  SeenRows() {
    std::size_t places = 0;
    Layout<Graph>::for_each_observed([&](const char*, auto observed, const auto&) {
      using Observed = typename decltype(observed)::type;
      using Message = typename Observed::value_type;
      static_assert(alignof(Message) <= alignof(Place));
      first_.push_back(places);
      places += (messages_of<Observed>() * sizeof(Message) + sizeof(Place) - 1) / sizeof(Place);
    });
    places_.resize(places);
  }

  /// Valid until the next call. A window of size 0 contains all messages of its row.
  Observation of(const float* row) {
    auto observation = std::bit_cast<Observation>(std::array<std::byte, sizeof(Observation)>{});
    std::size_t field = 0;
    Graph::for_each_observation(observation, [&](const char*, const auto& window, const auto&) {
      using Observed = std::remove_cvref_t<decltype(window)>;
      using Message = typename Observed::value_type;
      const float* from = row + layout_.observations.first(field);
      auto* const messages = reinterpret_cast<Message*>(places_.data() + first_[field++]);
      for (std::uint32_t w = 0; w < messages_of<Observed>(); ++w) {
        Message* const message = std::construct_at(messages + w);
        for (std::size_t i = 0; i < size_of<Message>; ++i)
          element(*message, i) = from_row<ScalarOf<Message>>(*from++);
      }
      // `observation` is not a constant, only what for_each_observation() shows of it.
      std::construct_at(const_cast<Observed*>(&window), messages, Seq{messages_of<Observed>()});
    });
    return observation;
  }

 private:
  using Place = std::max_align_t;
  const Layout<Graph>& layout_ = Layout<Graph>::get();
  std::vector<std::size_t> first_;  // [fields] in places_
  std::vector<Place> places_;       // messages that the windows show
};

/// Writes `action` as a row. The name of a message that float32 cannot say; null: none.
template <class Graph>
const char* write_action(typename Graph::Action action, float* row) {
  const Layout<Graph>& layout = Layout<Graph>::get();
  const char* refused = nullptr;
  std::size_t field = 0;
  Graph::for_each_action(action, [&](const char* name, const auto& message, const auto&) {
    using Message = std::remove_cvref_t<decltype(message)>;
    using Scalar = ScalarOf<Message>;
    float* const to = row + layout.actions.first(field++);
    for (std::size_t i = 0; i < size_of<Message>; ++i) {
      const Scalar x = element(message, i);
      to[i] = static_cast<float>(x);
      if (from_row<Scalar>(to[i]) != x && x == x) refused = name;
    }
  });
  return refused;
}

/// The agent that the graph names. Throws Problem if it is none that a library can have.
template <class Graph>
target::Agent agent_of_graph() {
  constexpr target::Agent kAgent = target::default_agent<Graph>();
  if (kAgent == target::Agent::csv)
    refuse("the agent of the graph is a file of actions, which a library cannot read");
  return kAgent;
}

/// The rows of the environments `first` to `end` - 1, among those of all.
struct Rows {
  std::uint32_t first, end;
  const float* observations;
  float* actions;
};

/// The agents of a batch, for the threads of its pool: over SIMD vectors if the policy supports
/// them.
template <class Graph>
class Agents {
 public:
  explicit Agents(const SimdKernel<Graph>& kernel) : simd_(kernel) {}
  void make_room(unsigned members) {
    seen_.resize(members);
    simd_.make_room(members);
  }

  /// Writes the actions of running environments, with act_alone(k, observation) if they are not
  /// vectorized. Returns the results of write_action().
  template <class IsRunning, class ActAlone>
  const char* act(unsigned member, Rows rows, IsRunning&& is_running, ActAlone&& act_alone) {
    const char* refused = nullptr;
    const auto write = [&](std::uint32_t k, const typename Graph::Action& action) {
      if (const char* name = write_action<Graph>(action, rows.actions + k * acted_)) refused = name;
    };
    const std::uint32_t step = agent_of_graph<Graph>() == target::Agent::policy ? simd_.lanes() : 1;
    for (std::uint32_t first = rows.first; first < rows.end; first += step) {
      const std::uint32_t end = std::min(rows.end, first + step);
      std::uint32_t running = 0;
      for (std::uint32_t k = first; k < end; ++k) running += is_running(k) ? 1 : 0;
      const bool vectorized = step > 1 && simd_.is_worth(running);
      for (std::uint32_t k = first; k < end; ++k) {
        if (!is_running(k)) continue;
        const float* const row = rows.observations + k * observed_;
        if (vectorized) {
          simd_.see(member, k - first, row);
        } else {
          write(k, act_alone(k, seen_[member].of(row)));
        }
      }
      if (!vectorized) continue;
      const auto* const answers = simd_.act(member);
      for (std::uint32_t k = first; k < end; ++k) {
        if (is_running(k)) write(k, answers[k - first]);
      }
    }
    return refused;
  }

 private:
  std::size_t observed_ = Layout<Graph>::get().observations.numbers();
  std::size_t acted_ = Layout<Graph>::get().actions.numbers();
  std::vector<SeenRows<Graph>> seen_;  // [members]
  SimdAgent<Graph> simd_;
};

}  // namespace eagerx::environments
