// The graphs `plain` and `friction` as loops over SIMD registers that were written by hand: the
// equations, limits, observations and resets of this folder's files and nothing else. Prints graph,
// environments, instruction set, registers a SIMD vector, steps/s of the loop on one core, steps/s
// of the library over those; exit code 1 if their observations differ in a bit. In turn, in one
// process.
#include <targets/environments/eagerx_environments.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <eagerx/math.hpp>
#include <eagerx/simd.hpp>
#include <models/engines/ode_engine/rk4.hpp>
#include <models/nodes/butterworth_filter/butterworth_design.hpp>
#include <models/objects/pendulum/pendulum_ode.hpp>
#include <models/objects/test_pendulum/test_pendulum_ode.hpp>
#include <vector>

#include "comparison.hpp"

namespace {

#ifdef __AVX512F__
constexpr std::size_t kRegister = 16;
#else
constexpr std::size_t kRegister = 8;
#endif
constexpr std::uint32_t kLongest = 150;
constexpr std::size_t kObserved = 3;

template <std::size_t Registers>
struct Io {
  using Real = eagerx::Simd<float, Registers * kRegister>;
};

/// tests/bench/environments/plain.yaml
template <std::size_t Registers>
struct Plain {
  using Ode = eagerx::models::TestPendulumOde<Io<Registers>>;
  using Real = typename Ode::Real;
  static constexpr const char* kName = "plain";
  static constexpr float kBound = 3.0F;  // V
  static constexpr int kSubsteps = 4;
  static constexpr std::size_t kMemory = 0;
  static Real smooth(Real u, float* /*memory*/, std::size_t /*environments*/) { return u; }
};

/// tests/bench/environments/friction.yaml
template <std::size_t Registers>
struct Friction {
  using Ode = eagerx::models::PendulumOde<Io<Registers>>;
  using Real = typename Ode::Real;
  static constexpr const char* kName = "friction";
  static constexpr float kBound = 2.0F;  // V
  static constexpr int kSubsteps = 30;
  static constexpr std::size_t kMemory = 2;
  static Real smooth(Real u, float* memory, std::size_t environments) {
    using eagerx::models::FilterType;
    static constexpr auto kSection =
        eagerx::models::design_butterworth(2, FilterType::lowpass, 12.0, 12.0, 30.0).sections[0];
    const auto of = [](double number) { return Real(static_cast<float>(number)); };
    const Real y = of(kSection.b0) * u + Real::load(memory);
    const Real z1 = of(kSection.b1) * u - of(kSection.a1) * y + Real::load(memory + environments);
    z1.store(memory);
    (of(kSection.b2) * u - of(kSection.a2) * y).store(memory + environments);
    return y;
  }
};

template <class Graph>
class ByHand {
 public:
  explicit ByHand(std::size_t environments)
      : theta_(environments), omega_(environments), memory_(environments * Graph::kMemory) {}

  void set(const float* states, std::size_t numbers) {
    for (std::size_t i = 0; i < theta_.size(); ++i) {
      theta_[i] = states[i * numbers];
      omega_[i] = states[i * numbers + 1];
    }
    std::ranges::fill(memory_, 0.0F);
    age_ = 0;
  }

  void step(const float* action, const eagerx_rows& rows) {
    const bool ends = ++age_ == kLongest;
    for (std::size_t at = 0; at < theta_.size(); at += kWidth)
      step_group(at, action + at, ends, rows.observation + at * kObserved);
    std::memset(rows.reward, 0, theta_.size() * sizeof(float));
    std::memset(rows.terminated, 0, theta_.size());
    std::memset(rows.truncated, ends ? 1 : 0, theta_.size());
    if (!ends) return;
    std::ranges::fill(memory_, 0.0F);
    age_ = 0;
  }

 private:
  using Ode = typename Graph::Ode;
  using Real = typename Graph::Real;
  using State = typename Ode::State;
  static constexpr std::size_t kWidth = sizeof(Real) / sizeof(float);

  void step_group(std::size_t at, const float* action, bool ends, float* row) {
    constexpr auto kStep = static_cast<float>(1.0 / 30.0 / Graph::kSubsteps);
    const Real bounded =
        eagerx::clamp(Real::load(action), Real(-Graph::kBound), Real(Graph::kBound));
    const Real u = Graph::smooth(bounded, memory_.data() + at, theta_.size());
    const auto c = Ode::precompute(Ode::default_parameters(), {{u}});
    const auto f = [&](const State& x) __attribute__((always_inline)) {
      return Ode::derivative(c, x);
    };
    State x = {{Real::load(&theta_[at]), Real::load(&omega_[at])}};
    for (int i = 0; i < Graph::kSubsteps; ++i) x = eagerx::models::rk4_step(f, x, Real(kStep));
    if (ends) x = {{sampled(3.14F), sampled(9.0F)}};
    x[0].store(&theta_[at]);
    x[1].store(&omega_[at]);
    observe(x, row);
  }
  static void observe(const State& x, float* row) {
    float columns[kObserved][kWidth];
    const auto both = eagerx::sincos(x[0]);
    both.cos.store(columns[0]);
    both.sin.store(columns[1]);
    x[1].store(columns[2]);
    for (std::size_t i = 0; i < kWidth; ++i) {
      for (std::size_t k = 0; k < kObserved; ++k) row[i * kObserved + k] = columns[k][i];
    }
  }
  Real sampled(float bound) {
    float numbers[kWidth];
    for (float& number : numbers) {  // xorshift32
      random_ ^= random_ << 13U;
      random_ ^= random_ >> 17U;
      random_ ^= random_ << 5U;
      number = bound * (static_cast<float>(random_) * 0x1p-31F - 1.0F);
    }
    return Real::load(numbers);
  }

  std::vector<float> theta_, omega_, memory_;
  std::uint32_t age_ = 0, random_ = 1;
};

int failed(const char* what) {
  std::fprintf(stderr, "%s: %s\n", what, eagerx_error());
  return 1;
}

struct Times {
  double loop = 1e30, library = 1e30;
};

/// The library's environments and the loop's begin alike and stay so; then both are timed.
template <class Graph>
int compare(std::uint32_t n, std::size_t state_numbers, std::uint32_t steps, Times& best) {
  std::vector<float> action(n + bench::kRows), states(n * state_numbers);
  for (std::size_t i = 0; i < action.size(); ++i)
    action[i] = static_cast<float>(i * 37 % 61) / 10.0F - 3.0F;
  eagerx_options options{};
  options.size = sizeof(options);
  options.environments = n;
  options.seed = 1;
  options.longest = kLongest;
  options.autoreset = EAGERX_SAME_STEP;
  options.threads = 1;
  eagerx_environments* library = eagerx_create(&options);
  bench::Rows ours(n, kObserved), theirs(n, kObserved);
  if (library == nullptr || eagerx_reset(library, nullptr, nullptr, ours.observation.data()) != 0 ||
      eagerx_get_states(library, states.data()) != 0)
    return failed("the library");
  ByHand<Graph> by_hand(n);
  by_hand.set(states.data(), state_numbers);
  for (std::uint32_t i = 0; i + 1 < kLongest; ++i) {
    eagerx_step(library, action.data() + i % bench::kRows, &ours.rows);
    by_hand.step(action.data() + i % bench::kRows, theirs.rows);
    if (ours.observation != theirs.observation) {
      std::fprintf(stderr, "%s: observations differ after %u steps\n", Graph::kName, i + 1);
      return 1;
    }
  }
  for (int i = 0; i < 7; ++i) {
    const auto step_library = [&](const float* a) { eagerx_step(library, a, &ours.rows); };
    const auto step_loop = [&](const float* a) { by_hand.step(a, theirs.rows); };
    best.library = std::min(best.library, bench::timed(steps / n, action.data(), step_library));
    best.loop = std::min(best.loop, bench::timed(steps / n, action.data(), step_loop));
  }
  eagerx_destroy(library);
  return 0;
}

/// Loops over SIMD vectors of one, two and four registers.
template <template <std::size_t> class Graph>
int compare_widths(std::size_t state_numbers, std::uint32_t steps) {
  for (const std::uint32_t n : {64U, 4096U}) {
    Times times[3];
    if (compare<Graph<1>>(n, state_numbers, steps, times[0]) != 0 ||
        compare<Graph<2>>(n, state_numbers, steps, times[1]) != 0 ||
        compare<Graph<4>>(n, state_numbers, steps, times[2]) != 0)
      return 1;
    for (std::size_t i = 0; i < 3; ++i) {
      const double done = static_cast<double>(steps / n) * n;
      std::printf("%s %u %s %d %.0f %.3f\n", Graph<1>::kName, n,
                  kRegister == 16 ? "AVX-512" : "AVX2", 1 << i, 1e9 * done / times[i].loop,
                  times[i].loop / times[i].library);
    }
  }
  return 0;
}

}  // namespace

/// The linked library's graph; numbers of the states of an environment.
int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const std::size_t numbers = std::strtoul(argv[2], nullptr, 10);
  return std::strcmp(argv[1], "plain") == 0 ? compare_widths<Plain>(numbers, 4'000'000)
                                            : compare_widths<Friction>(numbers, 1'000'000);
}
