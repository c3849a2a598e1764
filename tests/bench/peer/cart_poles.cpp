// Steps of 4,096 CartPoles: `library STEPS` of the library, on one thread, or `loop STEPS` of a
// loop over plain arrays that the compiler vectorizes, with the sine and cosine of its own library.
// The loop writes the same rows as the library: observation, reward, ends. Actions are there as
// numbers.
#include <targets/environments/eagerx_environments.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "../environments/comparison.hpp"

namespace {

constexpr std::size_t kCount = 4096, kObserved = 4;
constexpr float kGravity = 9.8F, kPole = 0.1F, kMass = 1.1F, kLength = 0.5F, kForce = 10.0F;
constexpr float kStep = 0.02F, kLane = 2.4F, kTilt = 0.20943951F;
constexpr std::uint32_t kLongest = 500;

float x[kCount], v[kCount], theta[kCount], omega[kCount], sines[kCount], cosines[kCount];
std::uint32_t age[kCount];
std::uint32_t random_bits = 1;

float uniform() {
  random_bits = random_bits * 1664525U + 1013904223U;
  return static_cast<float>(random_bits >> 8U) * 0x1p-24F * 0.1F - 0.05F;
}

void begin(std::size_t i) {
  x[i] = uniform();
  v[i] = uniform();
  theta[i] = uniform();
  omega[i] = uniform();
  age[i] = 0;
}

void loop_step(const float* __restrict action, float* __restrict reward,
               std::uint8_t* __restrict terminated, std::uint8_t* __restrict truncated,
               float* __restrict observation) {
  // Two loops: in one, g++ would make a call of sincosf() of both, which it does not vectorize.
  for (std::size_t i = 0; i < kCount; ++i) sines[i] = std::sin(theta[i]);
  for (std::size_t i = 0; i < kCount; ++i) cosines[i] = std::cos(theta[i]);
  for (std::size_t i = 0; i < kCount; ++i) {
    const float force = action[i] > 0.5F ? kForce : -kForce;
    const float sine = sines[i], cosine = cosines[i];
    const float push = (force + kPole * kLength * omega[i] * omega[i] * sine) / kMass;
    const float turn = (kGravity * sine - cosine * push) /
                       (kLength * (4.0F / 3.0F - kPole * cosine * cosine / kMass));
    const float speed_up = push - kPole * kLength * turn * cosine / kMass;
    x[i] += kStep * v[i];
    v[i] += kStep * speed_up;
    theta[i] += kStep * omega[i];
    omega[i] += kStep * turn;
    age[i] += 1;
    reward[i] = 1.0F;
    terminated[i] = std::fabs(x[i]) > kLane || std::fabs(theta[i]) > kTilt;
    truncated[i] = age[i] == kLongest;
  }
  for (std::size_t i = 0; i < kCount; ++i) {
    if ((terminated[i] | truncated[i]) != 0) begin(i);
  }
  for (std::size_t i = 0; i < kCount; ++i) {
    observation[kObserved * i] = x[i];
    observation[kObserved * i + 1] = v[i];
    observation[kObserved * i + 2] = theta[i];
    observation[kObserved * i + 3] = omega[i];
  }
}

}  // namespace

int main(int count, char** words) {
  if (count != 3) return 2;
  const bool library = std::string_view(words[1]) == "library";
  const long steps = std::atol(words[2]);
  std::vector<float> action(kCount + bench::kRows);
  for (std::size_t i = 0; i < action.size(); ++i) action[i] = (i * 2654435761U >> 7U & 1U) != 0;
  bench::Rows rows(kCount, kObserved);
  eagerx_options options{};
  options.size = sizeof options;
  options.environments = kCount;
  options.seed = 1;
  options.autoreset = EAGERX_SAME_STEP;
  options.threads = 1;
  eagerx_environments* environments = eagerx_create(&options);
  if (environments == nullptr ||
      eagerx_reset(environments, nullptr, nullptr, rows.observation.data()) != 0) {
    std::fprintf(stderr, "%s\n", eagerx_error());
    return 1;
  }
  for (std::size_t i = 0; i < kCount; ++i) begin(i);
  std::size_t ended = 0;
  for (long i = 0; i < steps; ++i) {
    const float* pushes = action.data() + static_cast<std::size_t>(i) % bench::kRows;
    if (!library)
      loop_step(pushes, rows.rows.reward, rows.rows.terminated, rows.rows.truncated,
                rows.observation.data());
    else if (eagerx_step(environments, pushes, &rows.rows) != 0)
      return 1;
    ended += rows.ends[static_cast<std::size_t>(i) * 61 % kCount];
  }
  std::printf("%zu of %ld ended\n", ended, steps);  // about as many in both
  eagerx_destroy(environments);
}
