// The packs of a batch, where environments run in packs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <targets/environments/layout.hpp>
#include <targets/environments/pack_kernel.hpp>
#include <targets/environments/task.hpp>
#include <vector>

namespace eagerx::environments {

/// What the guard of a program puts in the place of an action.
template <class Program, class Action>
Action applied_action(Program& program, const Action& action) {
  if constexpr (requires { program.guard; }) {
    return program.guard.check(action, 0);
  } else {
    return action;
  }
}

/// Environment k is lane k % lanes() of pack k / lanes(). All empty where there are no lanes.
template <class Graph>
class PackMemory {
 public:
  using Program = typename Graph::template Program<NoTrace>;
  using Action = typename Graph::Action;

  PackMemory(const PackKernel<Graph>& kernel, std::uint32_t environments)
      : kernel_(kernel), memory_(nullptr, Free{std::align_val_t{1}}) {
    if (lanes() == 0) return;
    const std::size_t packs = (environments + lanes() - 1) / lanes();
    const auto alignment = std::align_val_t{kernel.alignment};
    memory_ = {static_cast<std::byte*>(::operator new(packs* kernel.bytes, alignment)),
               Free{alignment}};
    for (std::size_t i = 0; i < packs; ++i) kernel.make(memory_.get() + i * kernel.bytes);
  }

  std::uint32_t lanes() const { return kernel_.lanes; }
  /// Longer episodes go on alone.
  std::uint32_t most_steps() const { return kernel_.most_steps; }

  /// For a step of each member of a team at the same time.
  void make_room(unsigned members) {
    columns_.resize(members * kernel_.columns * lanes());
    actions_.resize(std::size_t{members} * lanes(), Graph::zero());
  }

  void load(std::uint32_t k, const Program& one) { kernel_.load(pack(k), k % lanes(), one); }
  void store(std::uint32_t k, Program& one) const { kernel_.store(pack(k), k % lanes(), one); }

  Action& action(unsigned member, std::uint32_t k) {
    return actions_[std::size_t{member} * lanes() + k % lanes()];
  }
  /// Steps the pack of `k` with the actions of `member`, into its columns.
  void step(unsigned member, std::uint32_t k) {
    kernel_.step(pack(k), actions_.data() + std::size_t{member} * lanes(), columns(member));
  }
  PackColumn column(unsigned member, std::uint32_t k) {
    return {columns(member) + k % lanes(), lanes(), kernel_.columns - kTerms - terms_of<Graph>};
  }

  /// The guard looks at the observation of the step.
  void show_guard(const PackColumn& column, Program& program) const {
    // The guard of a graph without engine looks at no observation, and such a graph has no packs.
    if constexpr (requires {
                    requires decltype(program.guard)::kTakesOver;
                    program.guard.saw_numbers();
                  }) {
      if (!kernel_.answers) return;
      if (column.end(kFinite) != 0.0F) {
        program.guard.saw_numbers();
      } else {
        show_channels(column, program);
      }
    }
  }

  void write(const PackColumn& column, const Layout<Graph>& layout, float* row) const {
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
  static void show_channels(const PackColumn& column, Program& program) {
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

  std::byte* pack(std::uint32_t k) const { return memory_.get() + k / lanes() * kernel_.bytes; }
  float* columns(unsigned member) {
    return columns_.data() + std::size_t{member} * kernel_.columns * lanes();
  }

  PackKernel<Graph> kernel_;
  std::unique_ptr<std::byte[], Free> memory_;  // [packs][bytes]
  std::vector<float> columns_;                 // [members][columns][lanes]
  std::vector<Action> actions_;                // [members][lanes]
};

}  // namespace eagerx::environments
