// The least that a step of CartPole costs: its model over SIMD registers, actions that are there as
// numbers, rows of what a step gives, and nothing else. Where an episode ends another begins from a
// state that is not sampled, at no cost but that of a choice. Prints environments, instruction set,
// registers a SIMD vector, steps/s on one core of this, steps/s of the library over those. In turn,
// in one process. The library also samples states, counts steps, looks at actions, tells
// truncation, and has each environment's parameters, as this has.
#include <targets/environments/eagerx_environments.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <eagerx/simd.hpp>
#include <models/objects/gym_cart_pole/gym_cart_pole.hpp>
#include <targets/environments/simd_rows.hpp>
#include <vector>

#include "comparison.hpp"

namespace {

constexpr std::size_t kObserved = 4;

template <std::size_t Registers>
struct Io {
  using Real = eagerx::Simd<float, Registers * eagerx::kRegisterBytes / sizeof(float)>;
};

template <std::size_t Registers>
class Loop {
 public:
  using Model = eagerx::models::GymCartPole<Io<Registers>>;
  using Real = typename Model::Real;
  static constexpr std::size_t kWidth = sizeof(Real) / sizeof(float);

  explicit Loop(std::size_t environments)
      : states_(environments / kWidth), parameters_(states_.size(), Model::default_attributes()) {}

  void step(const float* action, const eagerx_rows& rows) {
    for (std::size_t simd = 0; simd < states_.size(); ++simd) {
      const std::size_t at = simd * kWidth;
      auto& state = states_[simd];
      const auto outcome = Model::step(state, {{Real::load(action + at)}}, parameters_[simd]);
      outcome.reward.store(rows.reward + at);
      const std::uint64_t ends = lane_bits(outcome.terminated);
      for (std::size_t i = 0; i < kWidth; ++i)
        rows.terminated[at + i] = static_cast<std::uint8_t>(ends >> i & 1U);
      for (std::size_t i = 0; i < kObserved; ++i)
        state[i] = select(outcome.terminated, Real(0.01F), state[i]);
      const float* columns[kObserved];
      for (std::size_t i = 0; i < kObserved; ++i)
        columns[i] = reinterpret_cast<const float*>(&state[i]);
      constexpr std::size_t kPlaces[] = {0, 1, 2, 3};
      eagerx::environments::RowWriter<kWidth>::spread_all(
          columns, kPlaces, rows.observation + kObserved * at, kObserved);
    }
  }

 private:
  using State = eagerx::Array<Real, Model::kStates>;
  std::vector<State> states_;
  std::vector<eagerx::Array<Real, Model::kAttributes>> parameters_;
};

template <std::size_t Registers>
int compare(std::uint32_t n) {
  constexpr std::uint32_t kSteps = 400'000;
  std::vector<float> action(n + bench::kRows);
  for (std::size_t i = 0; i < action.size(); ++i) action[i] = (i * 2654435761U >> 7U & 1U) != 0;
  eagerx_options options{};
  options.size = sizeof(options);
  options.environments = n;
  options.seed = 1;
  options.autoreset = EAGERX_SAME_STEP;
  options.threads = 1;
  eagerx_environments* library = eagerx_create(&options);
  bench::Rows ours(n, kObserved), theirs(n, kObserved);
  if (library == nullptr || eagerx_reset(library, nullptr, nullptr, ours.observation.data()) != 0) {
    std::fprintf(stderr, "%s\n", eagerx_error());
    return 1;
  }
  Loop<Registers> loop(n);
  double best_library = 1e30, best_loop = 1e30;
  for (int i = 0; i < 60; ++i) {
    const auto step_library = [&](const float* a) { eagerx_step(library, a, &ours.rows); };
    const auto step_loop = [&](const float* a) { loop.step(a, theirs.rows); };
    best_library = std::min(best_library, bench::timed(kSteps / n, action.data(), step_library));
    best_loop = std::min(best_loop, bench::timed(kSteps / n, action.data(), step_loop));
  }
  eagerx_destroy(library);
  const double done = static_cast<double>(kSteps / n) * n;
  std::printf("cart_pole %u %s %zu %.0f %.3f\n", n,
              eagerx::kRegisterBytes == 64 ? "AVX-512" : "AVX2", Registers, 1e9 * done / best_loop,
              best_loop / best_library);
  return 0;
}

}  // namespace

/// As by_hand.cpp, without its checks.
int main() {
  for (const std::uint32_t n : {256U, 4096U}) {
    if (compare<1>(n) != 0 || compare<2>(n) != 0 || compare<4>(n) != 0) return 1;
  }
  return 0;
}
