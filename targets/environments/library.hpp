// What the functions of eagerx_environments.h do, for any generated graph: they check what they are
// given, and nothing that is thrown leaves them.
#pragma once

#include <targets/environments/eagerx_environments.h>

#include <atomic>
#include <cfenv>
#include <cstdint>
#include <eagerx/float_environment.hpp>
#include <eagerx/math/rounding_check.hpp>
#include <exception>
#include <new>
#include <runtime/host/base/json.hpp>
#include <string>
#include <system_error>
#include <targets/environments/batch.hpp>
#include <targets/environments/describe.hpp>
#include <targets/environments/packs_of_processor.hpp>
#include <targets/environments/pictures.hpp>
#include <targets/environments/problem.hpp>
#include <targets/environments/stepping.hpp>

namespace eagerx::environments {

/// Of this thread's last failure.
inline std::string& last_error() {
  thread_local std::string text;
  return text;
}
inline const char* error_text() {
  return last_error().c_str();
}

/// A program may have told the processor to take denormal numbers for zero, or to round otherwise,
/// and then bits would differ: that waits until the call is over.
class RightFloats {
 public:
  RightFloats() {
    if (says_so() || calculates_as_everywhere()) return;
    std::fegetenv(&callers_);
    std::fesetenv(FE_DFL_ENV);
    changed_ = true;
    if (!calculates_as_everywhere()) {
      std::fesetenv(&callers_);
      throw Problem("this processor takes denormal numbers for zero, or rounds otherwise");
    }
  }
  RightFloats(const RightFloats&) = delete;
  RightFloats& operator=(const RightFloats&) = delete;
  ~RightFloats() {
    if (changed_) std::fesetenv(&callers_);
  }

 private:
  /// What the processor says of itself, in a tenth of the time that it takes to calculate: neither
  /// the bits of denormal numbers nor those of rounding are set.
  static bool says_so() {
#if defined(__SSE2__) && defined(__x86_64__)
    constexpr unsigned kOtherwise = 0xe040U;
    return (__builtin_ia32_stmxcsr() & kOtherwise) == 0;
#else
    return false;
#endif
  }

  std::fenv_t callers_{};
  bool changed_ = false;
};

/// `packs` gives the functions of packs for so many environments.
template <class Graph, PackKernel<Graph> (*packs)(std::uint32_t)>
class Library {
 public:
  struct Environments {
    explicit Environments(const eagerx_options& options)
        : batch(options, packs(options.environments)) {}
    Batch<Graph> batch;
    std::atomic_flag busy;
    std::string counts, stepping;
  };

  static const char* describe(const char* generator, const char* why_no_packs) {
    const char* result = "";
    attempt([&] {
      static const std::string text =
          environments::describe<Graph>(generator, packs(EAGERX_ENVIRONMENTS_MOST), why_no_packs);
      result = text.c_str();
    });
    return result;
  }

  template <class Made>
  static Made* create(const eagerx_options* options) {
    Made* result = nullptr;
    attempt([&] {
      check(options);
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
      if (action == nullptr && Layout<Graph>::get().actions.numbers() != 0)
        throw Problem("action is null");
      if (rows != nullptr) check_size("eagerx_rows", rows->size, sizeof(eagerx_rows));
      const std::string problem = batch.step(action, rows != nullptr ? *rows : eagerx_rows{});
      is_finite = problem.empty();
      if (!is_finite) last_error() = problem;
    });
    return is_finite ? result : kRewardNotFinite;
  }

  static int act(Environments* environments, const float* observation, float* action) {
    return call(environments, [&](Batch<Graph>& batch) {
      if (observation == nullptr && Layout<Graph>::get().observations.numbers() != 0)
        throw Problem("observation is null");
      if (action == nullptr && Layout<Graph>::get().actions.numbers() != 0)
        throw Problem("action is null");
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

  static int get_states(Environments* environments, float* states) {
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
      check_number(batch, environment);
      batch.trace(environment, path);
    });
  }

  static std::uint64_t hash(Environments* environments, std::uint32_t environment) {
    std::uint64_t result = 0;
    call(environments, [&](Batch<Graph>& batch) {
      check_number(batch, environment);
      result = batch.hash(environment);
    });
    return result;
  }

  static int picture(Environments* environments, std::uint32_t environment, std::uint32_t width,
                     std::uint32_t height, std::uint8_t* pixels) {
    return call(environments, [&](Batch<Graph>& batch) {
      check_number(batch, environment);
      if (pixels == nullptr) throw Problem("pixels is null");
      check_side("width", width);
      check_side("height", height);
      batch.picture(environment, {pixels, static_cast<int>(width), static_cast<int>(height), 3});
    });
  }

  static const char* stepping(Environments* environments, const char* graph_has_none) {
    const char* result = nullptr;
    call(environments, [&](Batch<Graph>& batch) {
      environments->stepping = stepping_text(packs(batch.size()), packs(EAGERX_ENVIRONMENTS_MOST),
                                             batch.size(), batch.draws(), graph_has_none);
      result = environments->stepping.c_str();
    });
    return result;
  }

  static const char* counts(Environments* environments) {
    const char* result = nullptr;
    call(environments, [&](Batch<Graph>& batch) {
      host::Json json;
      json.begin_object();
      for (const auto& [name, count] : batch.counts()) json.key(name).whole(count);
      environments->counts = json.end_object().str();
      result = environments->counts.c_str();
    });
    return result;
  }

 private:
  static constexpr std::uint32_t kMostThreads = 1024;

  /// 0, or -1 with a text for eagerx_error().
  template <class F>
  static int attempt(F&& f) noexcept {
    try {
      f();
      return 0;
    } catch (const std::bad_alloc&) {
      return fail("not enough memory");
    } catch (const std::system_error& problem) {
      return fail(problem.code());
    } catch (const std::exception& problem) {
      return fail(problem.what());
    } catch (...) {
      return fail("something unknown was thrown");
    }
  }
  static int fail(const char* text) noexcept {
    try {
      last_error() = text;
    } catch (...) {
      last_error().clear();
    }
    return -1;
  }

  /// Only threads throw these.
  static int fail(const std::error_code& why) noexcept {
    try {
      last_error() = "the system gives no more threads: " + why.message();
    } catch (...) {
      last_error().clear();
    }
    return -1;
  }

  /// f(batch), if nobody else is in a call with it.
  template <class F>
  static int call(Environments* environments, F&& f) noexcept {
    if (environments == nullptr) return fail("environments is null");
    if (environments->busy.test_and_set(std::memory_order_acquire))
      return fail("another thread is in a call with these environments");
    const int result = attempt([&] {
      if (!environments->batch.has_threads())
        throw Problem("this process was made by fork() after these environments: make new ones");
      const RightFloats right;
      f(environments->batch);
    });
    environments->busy.clear(std::memory_order_release);
    return result;
  }

  static void check(const eagerx_options* options) {
    if (!rounds_each_operation()) {
      throw Problem(
          "this library was compiled with flags that change the bits of its numbers: leave out "
          "-ffast-math and its parts");
    }
    if (options == nullptr) throw Problem("options is null");
    check_size("eagerx_options", options->size, sizeof(eagerx_options));
    if (options->environments == 0 || options->environments > EAGERX_ENVIRONMENTS_MOST) {
      throw Problem("environments is " + std::to_string(options->environments) + ", not 1 to " +
                    std::to_string(EAGERX_ENVIRONMENTS_MOST));
    }
    if (options->autoreset > EAGERX_DISABLED)
      throw Problem("autoreset is " + std::to_string(options->autoreset) + ", not 0 to 2");
    if (options->pictures > 1)
      throw Problem("pictures is " + std::to_string(options->pictures) + ", not 0 or 1");
    if (options->threads > kMostThreads) {
      throw Problem("threads is " + std::to_string(options->threads) + ", not 0 to " +
                    std::to_string(kMostThreads));
    }
  }

  static void check_size(const char* name, std::size_t given, std::size_t wanted) {
    if (given == wanted) return;
    throw Problem(std::string(name) + " is of another version: its size is " +
                  std::to_string(given) + ", not " + std::to_string(wanted));
  }
  static void check_states(const float* states) {
    if (states == nullptr && Layout<Graph>::get().states.numbers() != 0)
      throw Problem("states is null");
  }
  static void check_side(const char* name, std::uint32_t pixels) {
    if (pixels >= 1 && pixels <= kWidestPicture) return;
    throw Problem(std::string(name) + " is " + std::to_string(pixels) + ", not 1 to " +
                  std::to_string(kWidestPicture));
  }
  static void check_number(const Batch<Graph>& batch, std::uint32_t environment) {
    if (environment < batch.size()) return;
    throw Problem("there is no environment " + std::to_string(environment) + ", but 0 to " +
                  std::to_string(batch.size() - 1));
  }
};

}  // namespace eagerx::environments
