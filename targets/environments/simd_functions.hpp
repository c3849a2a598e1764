// The functions of SimdKernel, for the instruction set of this compilation.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <eagerx/lanes.hpp>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <limits>
#include <new>
#include <targets/environments/simd_kernel.hpp>
#include <targets/environments/simd_rows.hpp>
#include <targets/environments/task.hpp>
#include <type_traits>

namespace eagerx::environments {

/// Of a graph without a policy that looks at one observation alone.
struct NoAgent {};

/// `Program` is the graph's over SIMD vectors of `Lanes`, `Action` and `Observation` are its
/// messages, `Sampler` samples for several environments, `Agent` is the graph's policy.
template <class Graph, class Program, class Action, class Observation, std::size_t Lanes,
          class Sampler, class Agent = NoAgent>
class SimdFunctions {
 public:
  using Kernel = SimdKernel<Graph>;

  static void fill(Kernel& kernel) {
    static_assert(std::has_single_bit(Lanes) && Lanes <= 64, "a bit for each lane");
    kernel.lanes = Lanes;
    kernel.bytes = sizeof(Program);
    kernel.alignment = alignof(Program);
    kernel.reported = kTells ? Graph::kObservationNames.size() : 0;
    kernel.columns = Observation::kNumbers + reported_at<Graph> + kernel.reported;
    kernel.most_steps = kMostTicks / Program::kTicks;
    kernel.answers = Program::kAnswers;
    kernel.phases = Program::kPhases;
    kernel.fits_next_to = [](const void* group, const typename Kernel::Program& one) {
      return static_cast<const Program*>(group)->fits_next_to(one);
    };
    kernel.go_to = [](void* group, const typename Kernel::Program& one) {
      static_cast<Program*>(group)->go_to(one);
    };
    kernel.make = [](void* group) { ::new (group) Program{}; };
    kernel.load = [](void* group, std::uint32_t lane, const typename Kernel::Program& one) {
      static_cast<Program*>(group)->load(lane, one);
    };
    kernel.store = [](const void* group, std::uint32_t lane, typename Kernel::Program& one) {
      static_cast<const Program*>(group)->store(lane, one);
    };
    if constexpr (Program::kPhases == 1 && !kHasResetNodes) kernel.restart = restart;
    kernel.sample = Sampler::sample;
    kernel.most_samples = Sampler::kMost;
    kernel.action_bytes = sizeof(Action);
    if constexpr (!Graph::kSafety.declared) kernel.take = take;
    kernel.put = [](void* actions, std::uint32_t lane, const typename Kernel::Action& action) {
      load_action(*static_cast<Action*>(actions), lane, action);
    };
    kernel.step = step;
    // Registers as wide as those of plain code are not faster with one environment a lane.
    constexpr std::size_t kPlainRegister = 16;
    if constexpr (!std::is_same_v<Agent, NoAgent> && kRegisterBytes > kPlainRegister) {
      kernel.observations = Agent::kObservations;
      kernel.inputs = Agent::kInputs;
      kernel.act = act;
    }
  }

 private:
  using Real = Simd<float, Lanes>;
  using Truth = typename Real::Truth;
  static constexpr bool kTells = Program::kAnswers && Observation::kMayMiss;
  /// Whether a guard wants to know which observations are finite.
  static constexpr bool kWatches = Program::kAnswers && Graph::kSafety.declared;
  static constexpr std::uint32_t kMostTicks = 2'000'000'000;  // below 2^31
  static constexpr bool kHasResetNodes = requires(const typename Kernel::Program& one) {
    one.reset_timeouts();
  };

  static typename Graph::Observation restart(void* group, std::uint32_t lane,
                                             typename Kernel::Program& one,
                                             const typename Graph::States& states) {
    return static_cast<Program*>(group)->restart(lane, one, states);
  }

  static std::uint64_t take(const ActionRows& rows, void* actions) {
    Truth applicable = true;
    std::size_t field = 0;
    static_cast<Action*>(actions)->for_each([&](auto& message) {
      const float* const first = rows.first + rows.places[field];
      with_space(field++, message, [&](const auto& space) {
        for (std::size_t i = 0; i < size_of<std::remove_cvref_t<decltype(message)>>; ++i) {
          const Real x = column_of(first + i, rows.acted);
          const Truth fits = is_within(x, element(space.low, i), element(space.high, i));
          applicable = applicable && fits;
          element(message, i) =
              as_action<ScalarOf<std::remove_cvref_t<decltype(message)>>>(select(fits, x, Real(0)));
        }
      });
    });
    return lane_bits(!applicable);
  }
  /// Calls f(bounds of action `field`), and converts the action of plain numbers to that of the
  /// SIMD group.
  template <class Message, class F>
  static void with_space(std::size_t field, const Message& /*message*/, F&& f) {
    typename Kernel::Action one{};
    std::size_t at = 0;
    Graph::for_each_applied(one, [&](const auto& message, const auto& space) {
      using One = std::remove_cvref_t<decltype(message)>;
      constexpr bool kAlike = size_of<One> == size_of<Message> &&
                              std::is_same_v<ScalarOf<One>, LaneOf<ScalarOf<Message>>>;
      if constexpr (kAlike) {
        if (at == field) f(space);
      }
      ++at;
    });
  }
  /// Conservative, and exact for floats: whole numbers are truncated afterwards.
  template <class Number>
  static Truth is_within(const Real& x, Number low, Number high) {
    if constexpr (std::is_same_v<Number, bool>) {
      static_cast<void>(low), static_cast<void>(high);
      return x == Real(0) || x == Real(1);
    } else {
      constexpr double kExact = 0x1p24;  // up to here float32 has every whole number
      if constexpr (std::is_integral_v<Number>) {
        if (static_cast<double>(low) < -kExact || static_cast<double>(high) > kExact) return false;
      }
      return eagerx::isfinite(x) && x >= Real(static_cast<float>(low)) &&
             x <= Real(static_cast<float>(high));
    }
  }
  template <class Scalar>
  static Scalar as_action(const Real& x) {
    if constexpr (std::is_same_v<Scalar, Real>) {
      return x;
    } else if constexpr (std::is_same_v<Scalar, Truth>) {
      return x != Real(0);
    } else {
      return Scalar(Simd<std::int32_t, Lanes>(x));
    }
  }
  static Real column_of(const float* row, std::size_t width) {
    if (width == 1) return Real::load(row);
    float column[Lanes];
    for (std::size_t k = 0; k < Lanes; ++k) column[k] = row[k * width];
    return Real::load(column);
  }

  static std::uint64_t step(void* group, const void* actions, float* columns,
                            const SimdRows* rows) {
    Program& program = *static_cast<Program*>(group);
    typename Program::Messages now;
    const auto observation = program.step(*static_cast<const Action*>(actions), now);
    const bool writes_rows = rows != nullptr && rows->observation != nullptr;
    const float* numbers[Observation::kNumbers];
    write(observation, columns, !writes_rows || kWatches, numbers);
    if (writes_rows)
      RowWriter<Lanes>::spread_all(numbers, rows->places, rows->observation, rows->observed);
    const std::uint64_t last = rows != nullptr ? count_steps(*rows) : 0;
    if constexpr (has_task<Graph>) {
      const auto outcome = program.outcome(now);
      float* const ends = columns + Observation::kNumbers * Lanes;
      outcome.reward.store(ends + kReward * Lanes);
      if (rows == nullptr || !rows->have_ends()) {
        put(outcome.terminated, ends + kTerminated * Lanes);
        put(outcome.truncated, ends + kTruncated * Lanes);
        put(outcome.success, ends + kSuccess * Lanes);
      }
      for (std::size_t i = 0; i < terms_of<Graph>; ++i)
        outcome.terms[i].store(ends + (kTerms + i) * Lanes);
      put_seen(outcome, ends + (kTerms + terms_of<Graph>)*Lanes);
      if (rows != nullptr && rows->terms != nullptr) {
        for (std::size_t i = 0; i < terms_of<Graph>; ++i)
          RowWriter<Lanes>::spread(ends + (kTerms + i) * Lanes, rows->terms + i, terms_of<Graph>);
      }
      if (rows != nullptr)
        put_rows(outcome.reward, outcome.success, outcome.terminated, outcome.truncated, *rows);
      return last | lane_bits(outcome.terminated || outcome.truncated ||
                              !eagerx::isfinite(outcome.reward));
    } else {
      if (rows != nullptr) put_rows(Real(0), false, false, false, *rows);
      return last;
    }
  }
  template <class Outcome>
  static void put_seen([[maybe_unused]] const Outcome& outcome, [[maybe_unused]] float* column) {
    if constexpr (seen_of < Graph >> 0) {
      outcome.for_each_seen([&](const char*, const auto& message) {
        for (std::size_t i = 0; i < size_of<std::remove_cvref_t<decltype(message)>>;
             ++i, column += Lanes)
          put(element(message, i), column);
      });
    }
  }
  /// The lanes that have made the most.
  static std::uint64_t count_steps(const SimdRows& rows) {
    using Counts = LaneCounts<Lanes>;
    const Counts steps = Counts::load(rows.steps) + Counts(1U);
    steps.store(rows.steps);
    return lane_bits(steps == Counts(rows.most_steps));
  }

  static void put_rows(const Real& reward, const Truth& success, const Truth& terminated,
                       const Truth& truncated, const SimdRows& rows) {
    if (rows.reward != nullptr) reward.store(rows.reward);
    const auto put_bytes = [](const Truth& truth, std::uint8_t* to) {
      if (to != nullptr) bytes_of(truth, to);
    };
    put_bytes(success, rows.success);
    put_bytes(terminated, rows.terminated);
    put_bytes(truncated, rows.truncated);
  }
  /// 1 where true.
  static void bytes_of(const Truth& truth, std::uint8_t* to) {
    std::int32_t from[Lanes];
    std::memcpy(from, &truth, sizeof from);
    for (std::size_t k = 0; k < Lanes; ++k) to[k] = static_cast<std::uint8_t>(from[k] & 1);
  }

  static void act(const float* columns, typename Kernel::Action* actions) {
    Real input[Agent::kInputs];
    for (std::size_t i = 0; i < Agent::kInputs; ++i) input[i] = Real::load(columns + i * Lanes);
    const Action action = Agent::act(input);
    for (std::size_t k = 0; k < Lanes; ++k) Agent::store_action(action, k, actions[k]);
  }

  /// `numbers`: where those of all lanes are afterwards, in `columns` or, unless `all` shall be
  /// there, in the program's own memory.
  static void write(const Observation& observation, float* columns, bool all,
                    const float* (&numbers)[Observation::kNumbers]) {
    float* const ends = columns + Observation::kNumbers * Lanes;
    Truth finite = true;
    const float** place = numbers;
    [[maybe_unused]] std::size_t channel = 0;
    observation.for_each([&](const char* /*name*/, const auto& window) {
      const Truth own = write(window, columns, all, place);
      if constexpr (kTells) put(own, ends + (reported_at<Graph> + channel++) * Lanes);
      if constexpr (kWatches) finite = finite && own;
    });
    if constexpr (kWatches) put(finite, ends + kFinite * Lanes);
  }
  /// Whether the existing messages are finite. Missing ones are NaN, or 0.
  template <class Window>
  static Truth write(const Window& window, float*& columns, bool all, const float**& place) {
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
      Truth missing = false;
      decltype(auto) sent = window[w];
      constexpr bool kStays =
          std::is_lvalue_reference_v<decltype(sent)> && std::is_same_v<Scalar, Real> && !kMisses;
      const auto put_number = [&](const Scalar& x) {
        if constexpr (kStays) *place = reinterpret_cast<const float*>(&x);
        if constexpr (!kStays) *place = columns;
        if (!kStays || all) put(x, columns);
        if constexpr (std::is_same_v<Scalar, Real> && (kWatches || kTells))
          finite = finite && (missing || eagerx::isfinite(x));
        columns += Lanes, ++place;
      };
      if constexpr (kMisses) {
        missing = Truth(window.size() <= typename Window::Counts(w));
        const Message message = detail::unless(
            missing, filled<Message>(std::numeric_limits<LaneOf<Scalar>>::quiet_NaN()), sent);
        for (std::size_t i = 0; i < size_of<Message>; ++i) put_number(element(message, i));
      } else {
        for (std::size_t i = 0; i < size_of<Message>; ++i) put_number(element(sent, i));
      }
    }
    return finite;
  }

  static void put(const Real& x, float* column) { x.store(column); }
  static void put(const Truth& truth, float* column) {
    select(truth, Real(1), Real(0)).store(column);
  }
  template <class Whole>
  static void put(const Simd<Whole, Lanes>& x, float* column) {
    Real(x).store(column);
  }
};

}  // namespace eagerx::environments
