// Functions of eagerx_environments.h for any generated graph: they check their arguments, and no
// exception leaves them.
#pragma once

#include <targets/environments/eagerx_environments.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <eagerx/math/rounding_check.hpp>
#include <string>
#include <targets/environments/base/checks.hpp>
#include <targets/environments/base/description.hpp>
#include <targets/environments/base/problem.hpp>
#include <targets/environments/batch.hpp>
#include <targets/environments/describe.hpp>
#include <targets/environments/pictures.hpp>
#include <targets/environments/simd_of_processor.hpp>

namespace eagerx::environments {

/// `simd_kernel` returns the functions of SIMD groups for that number of environments.
template <class Graph, SimdKernel<Graph> (*simd_kernel)(std::uint32_t)>
class Library {
 public:
  struct Environments {
    explicit Environments(const eagerx_options& options)
        : batch(options, simd_kernel(options.environments)) {}
    Batch<Graph> batch;
    std::atomic_flag busy;
    std::string counts, stepping;
  };

  static const char* describe(const char* generator, const char* why_not_vectorized) {
    const char* result = "";
    attempt([&] {
      static const std::string text = environments::describe<Graph>(
          generator, simd_kernel(EAGERX_ENVIRONMENTS_MOST), why_not_vectorized);
      result = text.c_str();
    });
    return result;
  }

  template <class Made>
  static Made* create(const eagerx_options* options) {
    Made* result = nullptr;
    attempt([&] {
      if (!rounds_each_operation()) {
        refuse(
            "this library was compiled with flags that change the bits of its numbers: leave out "
            "-ffast-math and its parts");
      }
      if (std::getenv("EAGERX_PACKS") != nullptr)
        refuse("write `EAGERX_SIMD`, the new name of the variable `EAGERX_PACKS`");
      check_options(options);
      const RightFloats right;
      result = new Made(*options);
    });
    return result;
  }

  static int reset(Environments* environments, const std::uint8_t* mask, const std::uint64_t* seeds,
                   float* observation) {
    return call(environments, [&](Batch<Graph>& batch) { batch.reset(mask, seeds, observation); });
  }

  static int step(Environments* environments, const float* action, const eagerx_rows* rows) {
    constexpr int kRewardNotFinite = 1;
    bool is_finite = true;
    const int result = call(environments, [&](Batch<Graph>& batch) {
      if (action == nullptr) check_rows("action", action, Layout<Graph>::get().actions.numbers());
      if (rows != nullptr) check_size("eagerx_rows", rows->size, sizeof(eagerx_rows));
      static constexpr eagerx_rows kNothing{};
      is_finite = batch.step(action, rows != nullptr ? *rows : kNothing);
      if (!is_finite) set_error(batch.problem());
    });
    return is_finite ? result : kRewardNotFinite;
  }

  static int act(Environments* environments, const float* observation, float* action) {
    return call(environments, [&](Batch<Graph>& batch) {
      check_rows("observation", observation, Layout<Graph>::get().observations.numbers());
      check_rows("action", action, Layout<Graph>::get().actions.numbers());
      batch.act(observation, action);
    });
  }

  static int set_states(Environments* environments, const std::uint8_t* mask, const float* states) {
    return call(environments, [&](Batch<Graph>& batch) {
      check_states(states);
      batch.set_states(mask, states);
    });
  }

  static int tune(Environments* environments, const std::uint8_t* mask, const float* states) {
    return call(environments, [&](Batch<Graph>& batch) {
      check_states(states);
      batch.tune(mask, states);
    });
  }

  template <class Number>
  static int get_states(Environments* environments, Number* states) {
    return call(environments, [&](Batch<Graph>& batch) {
      check_states(states);
      batch.get_states(states);
    });
  }

  static int set_stage(Environments* environments, const std::uint8_t* mask, const char* stage) {
    return call(environments,
                [&](Batch<Graph>& batch) { batch.set_stage(mask, stage != nullptr ? stage : ""); });
  }

  static int critic(Environments* environments, float* rows, float* final_rows) {
    return call(environments, [&](Batch<Graph>& batch) { batch.critic(rows, final_rows); });
  }

  static int trace(Environments* environments, std::uint32_t environment, const char* path) {
    return call(environments, [&](Batch<Graph>& batch) {
      check_number(environment, batch.size());
      batch.trace(environment, path);
    });
  }

  static std::uint64_t hash(Environments* environments, std::uint32_t environment) {
    std::uint64_t result = 0;
    call(environments, [&](Batch<Graph>& batch) {
      check_number(environment, batch.size());
      result = batch.hash(environment);
    });
    return result;
  }

  static int picture(Environments* environments, std::uint32_t environment, std::uint32_t width,
                     std::uint32_t height, std::uint8_t* pixels) {
    return call(environments, [&](Batch<Graph>& batch) {
      check_number(environment, batch.size());
      check_rows("pixels", pixels, 1);
      check_side("width", width, kWidestPicture);
      check_side("height", height, kWidestPicture);
      batch.picture(environment, {pixels, static_cast<int>(width), static_cast<int>(height), 3});
    });
  }

  static const char* stepping(Environments* environments, const char* graph_has_none) {
    const char* result = nullptr;
    call(environments, [&](Batch<Graph>& batch) {
      const auto used = simd_kernel(batch.size()), widest = simd_kernel(EAGERX_ENVIRONMENTS_MOST);
      environments->stepping = stepping_text({used.lanes, used.isa}, {widest.lanes, widest.isa},
                                             batch.size(), batch.draws(), graph_has_none);
      result = environments->stepping.c_str();
    });
    return result;
  }

  static const char* counts(Environments* environments) {
    const char* result = nullptr;
    call(environments, [&](Batch<Graph>& batch) {
      environments->counts = batch.counts().text();
      result = environments->counts.c_str();
    });
    return result;
  }

 private:
  /// 0, or -1 with a text for eagerx_error().
  template <class F>
  static int attempt(F&& f) noexcept {
    try {
      f();
      return 0;
    } catch (...) {
      return fail_as_caught();
    }
  }

  /// f(batch), if no other call with it is running.
  template <class F>
  static int call(Environments* environments, F&& f) noexcept {
    if (environments == nullptr) return fail("environments is null");
    if (environments->busy.test_and_set(std::memory_order_acquire))
      return fail("another thread is in a call with these environments");
    const int result = attempt([&] {
      if (!environments->batch.has_threads())
        refuse("this process was made by fork() after these environments: make new ones");
      const RightFloats right;
      f(environments->batch);
    });
    environments->busy.clear(std::memory_order_release);
    return result;
  }

  static void check_states(const void* states) {
    check_rows("states", states, Layout<Graph>::get().states.columns.numbers());
  }
};

}  // namespace eagerx::environments
