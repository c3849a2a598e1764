// The functions of PackKernel, for the instruction set that this is compiled for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <eagerx/lanes.hpp>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <limits>
#include <new>
#include <targets/environments/pack_kernel.hpp>
#include <targets/environments/task.hpp>
#include <type_traits>

namespace eagerx::environments {

/// Of a graph without a policy that looks at one observation alone.
struct NoAgent {};

/// `Program` is the graph's over packs of `Lanes`, `Action` and `Observation` are its messages,
/// `Agent` its policy.
template <class Graph, class Program, class Action, class Observation, std::size_t Lanes,
          class Agent = NoAgent>
class Packs {
 public:
  using Kernel = PackKernel<Graph>;

  static void fill(Kernel& kernel) {
    kernel.lanes = Lanes;
    kernel.bytes = sizeof(Program);
    kernel.alignment = alignof(Program);
    kernel.told = kTells ? Graph::kObservationNames.size() : 0;
    kernel.columns = Observation::kNumbers + kTerms + terms_of<Graph> + kernel.told;
    kernel.most_steps = kMostTicks / Program::kTicks;
    kernel.answers = Program::kAnswers;
    kernel.phases = Program::kPhases;
    kernel.is_beside = [](const void* pack, const typename Kernel::Program& one) {
      return static_cast<const Program*>(pack)->is_beside(one);
    };
    kernel.go_to = [](void* pack, const typename Kernel::Program& one) {
      static_cast<Program*>(pack)->go_to(one);
    };
    kernel.make = [](void* pack) { ::new (pack) Program{}; };
    kernel.load = [](void* pack, std::uint32_t lane, const typename Kernel::Program& one) {
      static_cast<Program*>(pack)->load(lane, one);
    };
    kernel.store = [](const void* pack, std::uint32_t lane, typename Kernel::Program& one) {
      static_cast<const Program*>(pack)->store(lane, one);
    };
    kernel.step = step;
    // Registers as wide as those of plain code are no faster with one environment a lane.
    constexpr std::size_t kPlainRegister = 16;
    if constexpr (!std::is_same_v<Agent, NoAgent> && kRegisterBytes > kPlainRegister) {
      kernel.observations = Agent::kObservations;
      kernel.inputs = Agent::kInputs;
      kernel.act = act;
    }
  }

 private:
  using Real = Pack<float, Lanes>;
  using Truth = typename Real::Truth;
  static constexpr bool kTells = Program::kAnswers && Observation::kMayMiss;
  static constexpr std::uint32_t kMostTicks = 2'000'000'000;  // below 2^31

  static std::uint64_t step(void* pack, const typename Kernel::Action* actions, float* columns,
                            const PackRows* rows) {
    Action action;
    for (std::size_t k = 0; k < Lanes; ++k) load_action(action, k, actions[k]);
    Program& program = *static_cast<Program*>(pack);
    write(program.step(action), columns);
    if (rows != nullptr && rows->observation != nullptr) {
      for (std::size_t i = 0; i < Observation::kNumbers; ++i)
        spread(columns + i * Lanes, rows->observation + rows->places[i], rows->observed);
    }
    if constexpr (has_task<Graph>) {
      const auto outcome = program.outcome();
      float* const ends = columns + Observation::kNumbers * Lanes;
      outcome.reward.store(ends + kReward * Lanes);
      put(outcome.terminated, ends + kTerminated * Lanes);
      put(outcome.truncated, ends + kTruncated * Lanes);
      put(outcome.success, ends + kSuccess * Lanes);
      for (std::size_t i = 0; i < terms_of<Graph>; ++i)
        outcome.terms[i].store(ends + (kTerms + i) * Lanes);
      if (rows != nullptr && rows->terms != nullptr) {
        for (std::size_t i = 0; i < terms_of<Graph>; ++i)
          spread(ends + (kTerms + i) * Lanes, rows->terms + i, terms_of<Graph>);
      }
      if (rows != nullptr)
        put_rows(outcome.reward, outcome.success, outcome.terminated, outcome.truncated, *rows);
      return lanes_of(outcome.terminated || outcome.truncated || !eagerx::isfinite(outcome.reward));
    } else {
      if (rows != nullptr) put_rows(Real(0), false, false, false, *rows);
      return 0;
    }
  }

  static void put_rows(const Real& reward, const Truth& success, const Truth& terminated,
                       const Truth& truncated, const PackRows& rows) {
    if (rows.reward != nullptr) reward.store(rows.reward);
    const auto put_bytes = [](const Truth& truth, std::uint8_t* to) {
      if (to != nullptr) bytes_of(truth, to);
    };
    put_bytes(success, rows.success);
    put_bytes(terminated, rows.terminated);
    put_bytes(truncated, rows.truncated);
  }
  /// A column into the rows of the lanes, each `width` numbers.
  static void spread(const float* column, float* to, std::size_t width) {
    constexpr std::size_t kAtATime = 8;
    for (std::size_t k = 0; k < Lanes; k += kAtATime, to += kAtATime * width)
      detail::unrolled<kAtATime>([&](auto j) { to[j * width] = column[k + j]; });
  }
  /// 1 where true.
  static void bytes_of(const Truth& truth, std::uint8_t* to) {
    std::int32_t from[Lanes];
    std::memcpy(from, &truth, sizeof from);
    for (std::size_t k = 0; k < Lanes; ++k) to[k] = static_cast<std::uint8_t>(from[k] & 1);
  }
  /// A bit for each lane.
  static std::uint64_t lanes_of(const Truth& truth) {
    static_assert(Lanes <= 64);
    if (!any(truth)) return 0;
    std::uint8_t bytes[Lanes];
    bytes_of(truth, bytes);
    std::uint64_t lanes = 0;
    for (std::size_t k = 0; k < Lanes; ++k) lanes |= std::uint64_t{bytes[k]} << k;
    return lanes;
  }

  static void act(const float* columns, typename Kernel::Action* actions) {
    Real input[Agent::kInputs];
    for (std::size_t i = 0; i < Agent::kInputs; ++i) input[i] = Real::load(columns + i * Lanes);
    const Action action = Agent::act(input);
    for (std::size_t k = 0; k < Lanes; ++k) Agent::store_action(action, k, actions[k]);
  }

  static void write(const Observation& observation, float* columns) {
    float* const ends = columns + Observation::kNumbers * Lanes;
    Truth finite = true;
    [[maybe_unused]] std::size_t channel = 0;
    observation.for_each([&](const char* /*name*/, const auto& window) {
      const Truth own = write(window, columns);
      if constexpr (kTells) put(own, ends + (kTerms + terms_of<Graph> + channel++) * Lanes);
      finite = finite && own;
    });
    put(finite, ends + kFinite * Lanes);
  }
  /// Whether the messages that are there are finite. What is not there is NaN, or 0.
  template <class Window>
  static Truth write(const Window& window, float*& columns) {
    using Message = typename Window::value_type;
    using Scalar = ScalarOf<Message>;
    constexpr bool kMisses = requires {
      window.held(0);
    };
    constexpr std::uint32_t kMessages = [] {
      if constexpr (kMisses) return Window::kMaxSize;
      if constexpr (!kMisses) return Window::size();
    }();
    Truth finite = true;
    for (std::uint32_t w = 0; w < kMessages; ++w) {
      Message message = window[w];
      Truth missing = false;
      if constexpr (kMisses) {
        missing = Truth(window.size() <= typename Window::Counts(w));
        message = detail::unless(
            missing, filled<Message>(std::numeric_limits<LaneOf<Scalar>>::quiet_NaN()), message);
      }
      for (std::size_t i = 0; i < size_of<Message>; ++i, columns += Lanes) {
        const Scalar& x = element(message, i);
        put(x, columns);
        if constexpr (std::is_same_v<Scalar, Real>)
          finite = finite && (missing || eagerx::isfinite(x));
      }
    }
    return finite;
  }

  static void put(const Real& x, float* column) { x.store(column); }
  static void put(const Truth& truth, float* column) {
    select(truth, Real(1), Real(0)).store(column);
  }
  template <class Whole>
  static void put(const Pack<Whole, Lanes>& x, float* column) {
    Real(x).store(column);
  }
};

}  // namespace eagerx::environments
