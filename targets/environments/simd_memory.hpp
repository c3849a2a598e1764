// The SIMD groups of a batch whose environments run vectorized.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <targets/environments/layout.hpp>
#include <targets/environments/simd_kernel.hpp>
#include <targets/environments/task.hpp>
#include <vector>

namespace eagerx::environments {

/// The action that a program's guard applies instead.
template <class Program, class Action>
Action applied_action(Program& program, const Action& action) {
  if constexpr (requires { program.guard; }) {
    return program.guard.check(action, 0);
  } else {
    return action;
  }
}

/// Environment k is lane k % lanes() of one of the SIMD groups of range k / lanes(): a range has as
/// many groups as a group has phases, and no two of them with environments are in the same one. All
/// empty where there are no lanes.
template <class Graph>
class SimdMemory {
 public:
  using Program = typename Graph::template Program<NoHooks>;
  using Action = typename Graph::Action;

  SimdMemory(const SimdKernel<Graph>& kernel, std::uint32_t environments)
      : kernel_(kernel),
        environments_(environments),
        memory_(nullptr, Free{std::align_val_t{1}}),
        actions_(nullptr, Free{std::align_val_t{1}}) {
    if (lanes() == 0) return;
    for (std::size_t field = 0; field < Graph::kActionNames.size(); ++field)
      action_places_.push_back(Layout<Graph>::get().actions.first(field));
    vectorized_.resize((environments + lanes() - 1) / lanes());
    Layout<Graph>::for_each_observed(
        [&, field = std::size_t{0}](const char*, auto observed, const auto&) mutable {
          using Observed = typename decltype(observed)::type;
          const std::size_t first = Layout<Graph>::get().observations.first(field++);
          for (std::size_t i = 0;
               i < messages_of<Observed>() * size_of<typename Observed::value_type>; ++i)
            places_.push_back(first + i);
        });
    const std::size_t groups = (environments + lanes() - 1) / lanes() * kernel.phases;
    if (kernel.phases > 1) {
      phase_.resize(environments);
      held_.resize(groups);
    }
    memory_ = allocated(groups * kernel.bytes);
    for (std::size_t i = 0; i < groups; ++i) kernel.make(memory_.get() + i * kernel.bytes);
  }

  std::uint32_t lanes() const { return kernel_.lanes; }
  /// Longer episodes continue alone.
  std::uint32_t most_steps() const { return kernel_.most_steps; }

  /// For a step of each thread of a pool at the same time.
  void make_room(unsigned members) {
    if (lanes() == 0) return;
    columns_.resize(members * kernel_.phases * kernel_.columns * lanes());
    actions_ = allocated(members * kernel_.action_bytes);
    for (unsigned member = 0; member < members; ++member) {
      for (std::uint32_t lane = 0; lane < lanes(); ++lane)
        kernel_.put(actions(member), lane, Graph::zero());
    }
  }

  /// An environment that no lane holds. Lanes that hold none get it, too: they are computed with
  /// the others, and numbers without a meaning (huge angles) may take longer than all of these.
  void load(std::uint32_t k, const Program& one) {
    const std::uint32_t first = range_of(k) * kernel_.phases;
    vectorized_[range_of(k)] |= bit(k);
    if (kernel_.phases > 1) join(k, first, one);
    for (std::uint32_t i = 0; i < kernel_.phases; ++i) {
      kernel_.load(at(first + i), lane_of(k), one);
      if (k + 1 < environments_) continue;
      for (std::uint32_t lane = lane_of(k) + 1; lane < lanes(); ++lane)
        kernel_.load(at(first + i), lane, one);
    }
  }
  /// Its lane holds it no longer.
  void leave(std::uint32_t k) {
    vectorized_[range_of(k)] &= ~bit(k);
    if (kernel_.phases > 1) --held_[range_of(k) * kernel_.phases + phase_[k]];
  }
  void store(std::uint32_t k, Program& one) const { kernel_.store(group(k), lane_of(k), one); }

  /// Whether environments can begin another episode in their lanes.
  bool restarts() const { return kernel_.restart != nullptr; }
  typename Graph::Observation restart(std::uint32_t k, Program& one,
                                      const typename Graph::States& states) {
    return kernel_.restart(group(k), lane_of(k), one, states);
  }

  /// The lanes of `k`'s range that hold an environment, a bit each.
  std::uint64_t vectorized(std::uint32_t k) const { return vectorized_[range_of(k)]; }

  /// Takes the actions of `member`'s next step, of the range of environments from `first` on.
  /// Returns the lanes whose action must still pass through the guard: pass the result to put().
  std::uint64_t take(unsigned member, std::uint32_t first, std::uint32_t environments,
                     const float* rows) {
    if (kernel_.take == nullptr || environments != lanes()) return ~std::uint64_t{0};
    const std::size_t acted = Layout<Graph>::get().actions.numbers();
    return kernel_.take({rows + first * acted, acted, action_places_.data()}, actions(member));
  }
  void put(unsigned member, std::uint32_t lane, const Action& action) {
    kernel_.put(actions(member), lane, action);
  }
  /// Whether a step of a range can write the rows of all of its lanes.
  bool writes_rows(std::uint32_t environments) const {
    return kernel_.phases == 1 && environments == lanes();
  }
  SimdRows rows_from(std::uint32_t first, const eagerx_rows& rows, std::uint32_t* steps,
                     std::uint32_t longest) const {
    const std::size_t observed = places_.size();
    const auto from = [&](auto* row, std::size_t width) {
      return row == nullptr ? nullptr : row + first * width;
    };
    return {from(rows.observation, observed),
            observed,
            places_.data(),
            from(rows.reward, 1),
            from(rows.terms, terms_of<Graph>),
            from(rows.success, 1),
            from(rows.terminated, 1),
            from(rows.truncated, 1),
            steps + first,
            longest != 0 ? std::min(longest, most_steps()) : most_steps()};
  }
  /// Steps the SIMD groups of `k`'s range with the actions of `member`, into their columns. As the
  /// kernel's, which means nothing with several phases.
  std::uint64_t step(unsigned member, std::uint32_t k, const SimdRows* rows) {
    const std::uint32_t first = range_of(k) * kernel_.phases;
    std::uint64_t notable = 0;
    for (std::uint32_t i = 0; i < kernel_.phases; ++i) {
      if (kernel_.phases > 1 && held_[first + i] == 0) continue;
      notable = kernel_.step(at(first + i), actions(member), columns(member, i), rows);
    }
    return notable;
  }
  /// The results of the last step of an environment, also after load() and leave() of other
  /// environments.
  SimdColumn column(unsigned member, std::uint32_t k, std::uint32_t lane) {
    return {columns(member, phase_of(k)) + lane, lanes(),
            kernel_.columns - reported_at<Graph> - kernel_.reported};
  }

  /// Whether the guard looks at observations.
  static constexpr bool shows_guard() {
    if constexpr (requires(Program & program) {
                    requires decltype(program.guard)::kTakesOver;
                    program.guard.saw_numbers();
                  }) {
      return true;
    } else {
      return false;
    }
  }
  /// The guard looks at the observation of the step.
  void show_guard(const SimdColumn& column, Program& program) const {
    // The guard of a graph without engine looks at no observation, and such a graph is not
    // vectorized.
    if constexpr (shows_guard()) {
      if (!kernel_.answers) return;
      if (column.end(kFinite) != 0.0F) {
        program.guard.saw_numbers();
      } else {
        show_channels(column, program);
      }
    }
  }

  void write(const SimdColumn& column, const Layout<Graph>& layout, float* row) const {
    std::size_t from = 0, field = 0;
    Layout<Graph>::for_each_observed([&](const char*, auto observed, const auto&) {
      using Observed = typename decltype(observed)::type;
      float* const to = row + layout.observations.first(field++);
      constexpr std::size_t kNumbers =
          messages_of<Observed>() * size_of<typename Observed::value_type>;
      for (std::size_t i = 0; i < kNumbers; ++i) to[i] = column.number(from++);
    });
  }

 private:
  struct Free {
    std::align_val_t alignment;
    void operator()(std::byte* memory) const { ::operator delete(memory, alignment); }
  };

  /// Which of the observations are not finite.
  void show_channels(const SimdColumn& column, Program& program) const {
    for (std::size_t i = 0; i < kernel_.reported; ++i)
      program.guard.saw(i, column.end(reported_at<Graph> + i) != 0.0F);
    if (kernel_.reported != 0) return;
    std::size_t from = 0, channel = 0;
    Layout<Graph>::for_each_observed([&](const char*, auto observed, const auto&) {
      using Observed = typename decltype(observed)::type;
      constexpr std::size_t kNumbers =
          messages_of<Observed>() * size_of<typename Observed::value_type>;
      bool finite = true;
      for (std::size_t i = 0; i < kNumbers; ++i)
        finite = finite && eagerx::isfinite(column.number(from++));
      program.guard.saw(channel++, finite);
    });
  }

  /// The SIMD group that is in its phase, or one without environments.
  void join(std::uint32_t k, std::uint32_t first, const Program& one) {
    std::uint32_t chosen = kernel_.phases;
    for (std::uint32_t i = 0; i < kernel_.phases; ++i) {
      if (held_[first + i] == 0) {
        if (chosen == kernel_.phases) chosen = i;
      } else if (kernel_.fits_next_to(at(first + i), one)) {
        chosen = i;
        break;
      }
    }
    if (held_[first + chosen] == 0) kernel_.go_to(at(first + chosen), one);
    phase_[k] = static_cast<std::uint8_t>(chosen);
    ++held_[first + chosen];
  }

  std::unique_ptr<std::byte[], Free> allocated(std::size_t bytes) const {
    const auto alignment = std::align_val_t{kernel_.alignment};
    return {static_cast<std::byte*>(::operator new(bytes, alignment)), Free{alignment}};
  }
  // Lanes are a power of two, and a division takes as long as many steps of a lane.
  std::uint32_t range_of(std::uint32_t k) const { return k >> std::countr_zero(lanes()); }
  std::uint32_t lane_of(std::uint32_t k) const { return k & (lanes() - 1); }
  std::uint64_t bit(std::uint32_t k) const { return std::uint64_t{1} << lane_of(k); }
  std::byte* actions(unsigned member) const {
    return actions_.get() + member * kernel_.action_bytes;
  }

  std::uint32_t phase_of(std::uint32_t k) const { return kernel_.phases > 1 ? phase_[k] : 0; }
  std::byte* at(std::size_t i) const { return memory_.get() + i * kernel_.bytes; }
  std::byte* group(std::uint32_t k) const {
    return at(std::size_t{range_of(k)} * kernel_.phases + phase_of(k));
  }
  float* columns(unsigned member, std::uint32_t phase) {
    return columns_.data() +
           (std::size_t{member} * kernel_.phases + phase) * kernel_.columns * lanes();
  }

  SimdKernel<Graph> kernel_;
  std::uint32_t environments_;
  std::unique_ptr<std::byte[], Free> memory_;  // [groups][bytes]
  std::vector<std::size_t> places_;            // of the numbers of an observation in a row
  std::vector<float> columns_;                 // [members][phases][columns][lanes]
  std::vector<std::uint8_t> phase_;            // [environments], in which group; none for one phase
  std::vector<std::uint32_t> held_;            // [groups], environments in it; the same
  std::vector<std::uint64_t> vectorized_;      // [ranges], a bit for each lane
  std::unique_ptr<std::byte[], Free> actions_;  // [members][action_bytes]
  std::vector<std::size_t> action_places_;      // of the first number of each in a row
};

}  // namespace eagerx::environments
