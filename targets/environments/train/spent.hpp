// Time that a training spends on each activity.
#pragma once

#include <time.h>

#include <cstdint>

namespace eagerx::train {

/// Processor time of the calling thread, from here on.
class Stopwatch {
 public:
  double seconds() const { return now_s() - begin_s_; }
  /// Returns the time since the last call, and restarts.
  double lap() {
    const double end_s = now_s(), passed_s = end_s - begin_s_;
    begin_s_ = end_s;
    return passed_s;
  }

 private:
  static double now_s() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  }
  double begin_s_ = now_s();
};

/// Seconds of processor time, over all threads of this process.
struct Spent {
  double simulation_s = 0.0;  // steps of the environments
  double inference_s = 0.0;   // actor and critic choose and evaluate actions
  double learning_s = 0.0;    // advantages, gradients, updates
  double evaluation_s = 0.0;

  double total_s() const { return simulation_s + inference_s + learning_s + evaluation_s; }
  Spent& operator+=(const Spent& more) {
    simulation_s += more.simulation_s;
    inference_s += more.inference_s;
    learning_s += more.learning_s;
    evaluation_s += more.evaluation_s;
    return *this;
  }
};

/// The work done in that time, by this process.
struct Done {
  std::uint64_t steps = 0;    // of environments, for learning
  std::uint64_t samples = 0;  // that gradients were made of, a step as often as it was used
  std::uint64_t weights = 0;  // of actor and critic: two operations each for an answer
  double inference_gflop() const { return 2e-9 * static_cast<double>(steps * weights); }
  /// Forward, and backward for weights and for inputs.
  double learning_gflop() const { return 6e-9 * static_cast<double>(samples * weights); }
};

}  // namespace eagerx::train
