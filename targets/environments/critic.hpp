// Inputs of a training's critic besides the observations: `critic:` of a graph's task.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <string_view>
#include <targets/environments/layout.hpp>
#include <targets/environments/simd_kernel.hpp>
#include <targets/environments/task.hpp>
#include <type_traits>
#include <vector>

namespace eagerx::environments {

/// Whether the critic of a training has inputs other than the observations.
template <class Graph>
inline constexpr bool has_critic = seen_of<Graph> > 0 || requires {
  Graph::kCriticStates;
};

/// The columns of its rows: messages of the task, then states as episodes began with them.
template <class Graph>
class CriticLayout {
 public:
  using States = typename Graph::States;

  Columns columns;

  static const CriticLayout& get() {
    static const CriticLayout layout;
    return layout;
  }

  /// f(name, type of the message) for each field, in the order in which they were added.
  template <class F>
  static void for_each_field(F&& f) {
    if constexpr (seen_of < Graph >> 0) {
      typename Graph::Outcome{}.for_each_seen([&](const char* name, const auto& message) {
        f(name, std::type_identity<std::remove_cvref_t<decltype(message)>>{});
      });
    }
    for_each_state([&](const char* name, auto, const auto& space) {
      f(name, std::type_identity<std::remove_cvref_t<decltype(space.low)>>{});
    });
  }

  /// The messages of a step, or of a reset.
  template <class Outcome>
  void write_seen(const Outcome& outcome, float* row) const {
    std::size_t field = 0;
    outcome.for_each_seen([&](const char*, const auto& message) {
      float* const to = row + columns.first(field++);
      for (std::size_t i = 0; i < size_of<std::remove_cvref_t<decltype(message)>>; ++i)
        to[i] = static_cast<float>(element(message, i));
    });
  }
  void write_seen(const SimdColumn& column, float* row) const {
    for (std::size_t i = 0; i < seen_.size(); ++i)
      row[seen_[i]] = column.end(kTerms + terms_of<Graph> + i);
  }
  /// 0 for states that are not sampled.
  void write_states(const States& states, float* row) const {
    std::size_t field = messages_;
    for_each_state([&](const char*, auto member, const auto& space) {
      float* const to = row + columns.first(field++);
      constexpr std::size_t kSize = size_of<std::remove_cvref_t<decltype(space.low)>>;
      for (std::size_t i = 0; i < kSize; ++i)
        to[i] = states.*member ? static_cast<float>(element(*(states.*member), i)) : 0.0F;
    });
  }

 private:
  CriticLayout() {
    std::vector<std::size_t> sizes;
    for_each_field([&](const char* name, auto type) {
      sizes.push_back(size_of<typename decltype(type)::type>);
      columns.add(name, sizes.back());
    });
    columns.arrange();
    while (seen_.size() < seen_of<Graph>) {
      for (std::size_t i = 0; i < sizes[messages_]; ++i)
        seen_.push_back(columns.first(messages_) + i);
      ++messages_;
    }
  }

  /// f(name, member of States, space) for each that the critic sees.
  template <class F>
  static void for_each_state([[maybe_unused]] F&& f) {
    if constexpr (requires { Graph::kCriticStates; }) {
      for (const std::string_view wanted : Graph::kCriticStates) {
        Graph::for_each_state([&](const char* name, const char*, auto member, const auto& space) {
          if (name == wanted) f(name, member, space);
        });
      }
    }
  }

  std::size_t messages_ = 0;       // fields that are not states
  std::vector<std::size_t> seen_;  // columns of the messages' numbers
};

/// The rows of all environments, as of their last step or reset.
template <class Graph>
class CriticRows {
 public:
  explicit CriticRows(std::uint32_t environments)
      : rows_(environments * numbers()), final_(rows_.size()) {}

  /// Numbers of a row.
  static std::size_t numbers() {
    if constexpr (has_critic<Graph>) return CriticLayout<Graph>::get().columns.numbers();
    return 0;
  }

  template <class Program>
  void begin([[maybe_unused]] std::uint32_t k, [[maybe_unused]] const Program& program,
             [[maybe_unused]] const typename Graph::States& states) {
    if constexpr (has_critic<Graph>) {
      step(k, program);
      CriticLayout<Graph>::get().write_states(states, row(k));
    }
  }
  template <class Program>
  void step([[maybe_unused]] std::uint32_t k, [[maybe_unused]] const Program& program) {
    if constexpr (seen_of < Graph >> 0)
      CriticLayout<Graph>::get().write_seen(program.outcome(), row(k));
  }
  void step([[maybe_unused]] std::uint32_t k, [[maybe_unused]] const SimdColumn& column) {
    if constexpr (seen_of < Graph >> 0) CriticLayout<Graph>::get().write_seen(column, row(k));
  }
  /// Ends the episode; the next one begins immediately.
  void end(std::uint32_t k) {
    std::copy_n(rows_.data() + k * numbers(), numbers(), final_.data() + k * numbers());
  }

  /// Into buffers [environments][numbers], or null.
  void read(float* rows, float* final_rows) const {
    if (rows != nullptr) std::ranges::copy(rows_, rows);
    if (final_rows != nullptr) std::ranges::copy(final_, final_rows);
  }

 private:
  float* row(std::uint32_t k) { return rows_.data() + k * numbers(); }

  std::vector<float> rows_, final_;  // [environments][numbers]
};

}  // namespace eagerx::environments
