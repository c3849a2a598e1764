// A library of environments, written by hand: the disc pendulum without friction, with the
// interface that generated libraries have. Test double of the trainer's tests. With
// EAGERX_TEST_CHOICES the action is 3, 4 or 5 for -2, 0 and 2 V; with EAGERX_TEST_HIDDEN the speed
// is not observed; with EAGERX_TEST_CRITIC the critic sees the angle's distance from upright, too,
// and a number of the episode; with EAGERX_TEST_STAGES there are two stages, which begin nearer to
// upright; with EAGERX_TEST_SEVERAL a second choice, -1 or 0, halves the voltage. In the
// environment of a process, EAGERX_TEST_BREAKS=rollout says that a reward of iteration 32 is not
// finite, and EAGERX_TEST_BREAKS=evaluation one of the evaluation after iteration 10.
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <eagerx/math.hpp>
#include <eagerx/random.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "targets/environments/eagerx_environments.h"

namespace {

constexpr float kPeriod = 1.0F / 30.0F;    // s
constexpr std::uint32_t kSteps = 150;      // of an episode
constexpr std::uint32_t kStillSteps = 60;  // upright for so long is a success

#if defined(EAGERX_TEST_SEVERAL)
constexpr bool kChooses = true;
constexpr std::size_t kActed = 2;
#define ACTION R"("shape": [2], "dtype": "int64", "low": [3, -1], "high": [5, 0])"
#elif defined(EAGERX_TEST_CHOICES)
constexpr bool kChooses = true;
constexpr std::size_t kActed = 1;
#define ACTION R"("shape": [], "dtype": "int64", "low": [3], "high": [5])"
#else
constexpr bool kChooses = false;
constexpr std::size_t kActed = 1;
#define ACTION R"("shape": [], "dtype": "float32", "low": [-2], "high": [2])"
#endif

#ifdef EAGERX_TEST_CRITIC
#define NUMBER R"("shape": [], "dtype": "float32", "low": [null], "high": [null], "first": )"
#define CRITIC R"(, "critic": [{"name": "error", )" NUMBER R"(0}, {"name": "luck", )" NUMBER "1}]"
#else
#define CRITIC
#endif

#ifdef EAGERX_TEST_STAGES
#define STAGES                                                         \
  R"(, "stages": [{"name": "still", "success": 0.9, "return": null},)" \
  R"({"name": "moved", "success": null, "return": -60}])"
#else
#define STAGES
#endif

#ifdef EAGERX_TEST_HIDDEN
constexpr std::size_t kWidth = 2;  // of an observation
#define SPEED
#else
constexpr std::size_t kWidth = 3;
#define SPEED                                                                           \
  R"(, {"name": "speed", "shape": [], "dtype": "float32", "window": 1, "low": [null],)" \
  R"( "high": [null], "first": 2})"
#endif

float voltage_of(const float* action) {
  const float share = kActed > 1 && action[1] == -1.0F ? 0.5F : 1.0F;
  return kChooses ? share * 2.0F * (action[0] - 4.0F) : action[0];
}

/// Whether a voltage is one of those that actions stand for.
bool is_known(float voltage) {
  if (kActed > 1 && (voltage == -1.0F || voltage == 1.0F)) return true;
  return !kChooses || voltage == -2.0F || voltage == 0.0F || voltage == 2.0F;
}

struct Pendulum {
  std::uint64_t seed = 0;
  std::uint32_t number = 0, episode = 0, step = 0, upright = 0;
  float angle = 0.0F, speed = 0.0F;  // rad, rad/s; 0 is upright
  float luck = 0.0F;                 // of the episode
  float end[2] = {};                 // what the critic saw last in the one that ended
  bool ended = false;
  float nearer[2] = {1.0F, 1.0F};  // share of the ranges: of this episode, of the next one
  float next[2] = {NAN, NAN};      // angle and speed that the next episode begins with, if not NaN

  void begin() {
    eagerx::Random random({seed, number, episode++}, eagerx::entity_id("pendulum"));
    nearer[0] = nearer[1];
    angle = nearer[0] * random.uniform(-3.14F, 3.14F);
    speed = nearer[0] * random.uniform(-9.0F, 9.0F);
    luck = random.uniform(0.0F, 1.0F);
    if (!std::isnan(next[0])) angle = next[0];
    if (!std::isnan(next[1])) speed = next[1];
    next[0] = next[1] = NAN;
    step = upright = 0;
    ended = false;
  }
  void advance(float voltage) {
    constexpr int kSubsteps = 8;
    constexpr float kStep = kPeriod / kSubsteps;
    for (int i = 0; i < kSubsteps; ++i) {
      speed += kStep * (26.97F * voltage + 129.5F * eagerx::sin(angle) - 0.99F * speed);
      angle += kStep * speed;
    }
    ++step;
  }
  float error() const { return eagerx::atan2(eagerx::sin(angle), eagerx::cos(angle)); }
  void show(float* row) const {
    row[0] = error();
    row[1] = luck;
  }
  void observe(float* row) const {
    row[0] = eagerx::cos(angle);
    row[1] = eagerx::sin(angle);
    if (kWidth > 2) row[2] = speed;
  }
};

thread_local std::string failure;

/// Whether this is the step whose reward is not finite.
bool breaks(const Pendulum& one, std::uint32_t evaluations) {
  constexpr std::uint32_t kNumber = 10, kEpisode = 7, kStep = 100;  // step 1000 of an era
  constexpr std::uint64_t kEvaluation = std::uint64_t{1} << 63U;
  const char* const text = std::getenv("EAGERX_TEST_BREAKS");
  if (text == nullptr || one.number != kNumber || one.step != kStep) return false;
  if (std::string_view(text) == "evaluation") return evaluations == 2;
  return one.seed < kEvaluation && one.episode == kEpisode;
}

/// Of the reward.
float unit() {
  const char* const text = std::getenv("EAGERX_TEST_UNIT");
  return text == nullptr ? 1.0F : std::strtof(text, nullptr);
}

template <class T>
void put(T* rows, std::size_t i, T value) {
  if (rows != nullptr) rows[i] = value;
}

}  // namespace

struct eagerx_environments {
  std::vector<Pendulum> all;
  std::uint32_t autoreset = 0;
  std::uint32_t evaluations = 0;  // so far, with the seed that each begins with
};

extern "C" {

uint32_t eagerx_version(void) {
  return EAGERX_ENVIRONMENTS_VERSION;
}
const char* eagerx_describe(void) {
  return R"({"version": 5, "generator": "0.1.0", "graph": "test_pendulum", "engine": "none",
    "hash": "0x0123456789abcdef", "rate_hz": 30, "isa": "any", "lanes": 1, "threads": true,
    "observations": [
      {"name": "angle", "shape": [2], "dtype": "float32", "window": 1, "low": [-1, -1],
       "high": [1, 1], "first": 0})" SPEED R"(],
    "actions": [{"name": "voltage", )" ACTION R"(, "first": 0}],
    "states": [{"name": "pendulum.model_state", "shape": [2], "dtype": "float32",
                "low": [-4, -10], "high": [4, 10], "first": 0}],
    "task": {"terms": ["angle", "speed", "effort"], "success": true, "episode_steps": 150)" CRITIC
      STAGES "}}";
}
const char* eagerx_error(void) {
  return failure.c_str();
}
eagerx_environments* eagerx_create(const eagerx_options* options) {
  auto* result = new eagerx_environments;
  result->autoreset = options->autoreset;
  for (std::uint32_t i = 0; i < options->environments; ++i) {
    Pendulum pendulum;
    pendulum.seed = options->seed;
    pendulum.number = options->numbers != nullptr ? options->numbers[i] : i;
    result->all.push_back(pendulum);
  }
  return result;
}
const char* eagerx_stepping(eagerx_environments* /*environments*/) {
  return "one by one: a test";
}
void eagerx_destroy(eagerx_environments* environments) {
  delete environments;
}
int eagerx_reset(eagerx_environments* environments, const uint8_t* mask, const uint64_t* seeds,
                 float* observation) {
  if (seeds != nullptr && *seeds == std::uint64_t{1} << 63U) ++environments->evaluations;
  for (std::size_t i = 0; i < environments->all.size(); ++i) {
    if (mask != nullptr && mask[i] == 0) continue;
    Pendulum& one = environments->all[i];
    if (seeds != nullptr) one.seed = seeds[i];
    if (seeds != nullptr) one.episode = 0;
    one.begin();
    if (observation != nullptr) one.observe(observation + kWidth * i);
  }
  return 0;
}
int eagerx_set_states(eagerx_environments* environments, const uint8_t* mask, const float* states) {
  for (std::size_t i = 0; i < environments->all.size(); ++i) {
    if (mask == nullptr || mask[i] != 0)
      std::memcpy(environments->all[i].next, states + 2 * i, sizeof(float[2]));
  }
  return 0;
}
int eagerx_step(eagerx_environments* environments, const float* action, const eagerx_rows* rows) {
  bool is_finite = true;
  const float factor = unit();
  for (std::size_t i = 0; i < environments->all.size(); ++i) {
    Pendulum& one = environments->all[i];
    if (one.ended) {  // EAGERX_DISABLED
      put(rows->reward, i, 0.0F);
      put<std::uint8_t>(rows->truncated, i, 0);
      continue;
    }
    const float voltage = voltage_of(action + kActed * i);
    if (!(voltage >= -2.0F && voltage <= 2.0F && is_known(voltage))) {
      failure = "an action is out of its space";
      return -1;
    }
    one.advance(voltage);
    is_finite = is_finite && !breaks(one, environments->evaluations);
    const float error = one.error();
    const float slow = one.speed / (1.0F + 10.0F * eagerx::abs(error));
    const float terms[] = {-error * error, -0.1F * slow * slow, -0.001F * voltage * voltage};
    one.upright = eagerx::abs(error) < 0.15F ? one.upright + 1 : 0;
    one.ended = one.step == kSteps;
    put(rows->reward, i, factor * (terms[0] + terms[1] + terms[2]));
    put<std::uint8_t>(rows->terminated, i, 0);
    put<std::uint8_t>(rows->truncated, i, one.ended ? 1 : 0);
    put<std::uint8_t>(rows->success, i, one.upright >= kStillSteps ? 1 : 0);
    if (rows->terms != nullptr) std::memcpy(rows->terms + 3 * i, terms, sizeof terms);
    if (one.ended && environments->autoreset == EAGERX_SAME_STEP) {
      if (rows->final_observation != nullptr) one.observe(rows->final_observation + kWidth * i);
      one.show(one.end);
      one.begin();
    }
    if (rows->observation != nullptr) one.observe(rows->observation + kWidth * i);
  }
  if (!is_finite) failure = "a reward is not finite";
  return is_finite ? 0 : 1;
}

int eagerx_set_stage(eagerx_environments* environments, const uint8_t* mask, const char* stage) {
  const std::string_view name = stage != nullptr ? stage : "";
  for (std::size_t i = 0; i < environments->all.size(); ++i) {
    if (mask != nullptr && mask[i] == 0) continue;
    environments->all[i].nearer[1] = name == "still" ? 0.02F : name == "moved" ? 0.1F : 1.0F;
  }
  return 0;
}

int eagerx_critic(eagerx_environments* environments, float* critic, float* final_critic) {
  for (std::size_t i = 0; i < environments->all.size(); ++i) {
    const Pendulum& one = environments->all[i];
    if (critic != nullptr) one.show(critic + 2 * i);
    if (final_critic != nullptr) std::memcpy(final_critic + 2 * i, one.end, sizeof one.end);
  }
  return 0;
}

}  // extern "C"
