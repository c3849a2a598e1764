// Errors of the library: it calls abort() for numbers that are not finite, which would end a
// program without an explanation.
#pragma once

#include <ode/ode.h>

#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace eagerx::models {

/// The step that this thread makes, with the names of the robots in it.
struct StepUnderWay {
  const void* objects = nullptr;
  /// Names the fastest joint of these objects, and its speed; empty if there is none.
  const char* (*fastest)(const void* objects, double& speed) = nullptr;
  std::uint64_t step = 0;  // of the episode, from 1 on

  static StepUnderWay& of_thread() {
    thread_local StepUnderWay now;
    return now;
  }
};

/// Called by the library before abort().
inline void stop_with_message(int /*number*/, const char* message, va_list arguments) {
  static_cast<void>(std::fflush(stdout));
  const StepUnderWay& now = StepUnderWay::of_thread();
  std::fprintf(stderr, "OpenDynamicsEngine: the library gives up in step %llu of the episode: ",
               static_cast<unsigned long long>(now.step));
  std::vfprintf(stderr, message, arguments);
  double speed = 0.0;
  const char* const joint = now.fastest != nullptr ? now.fastest(now.objects, speed) : "";
  if (*joint != '\0')
    std::fprintf(stderr, "\nThe fastest joint is `%s`, at %g rad/s or m/s", joint, speed);
  std::fputs(
      "\nSteps are too long for what acts on the robot: raise `substeps` of the engine, or lower "
      "torques, stiffness and damping.\n",
      stderr);
  std::_Exit(1);
}

inline void tell_why_it_stops() {
  dSetErrorHandler(stop_with_message);
  dSetDebugHandler(stop_with_message);
}

}  // namespace eagerx::models
