// Signals: every signal that can be caught stops a program safely.
#pragma once

#include <atomic>
#include <cstdint>
#include <initializer_list>

namespace eagerx::host {

/// Whether the run must end. Set by a signal, read by all threads.
using Interrupt = std::atomic<bool>;
static_assert(Interrupt::is_always_lock_free);  // a handler of signals may write it

/// The effect of a second signal of a kind: the default one, or none.
enum class Second : std::uint8_t { ends, does_nothing };

/// For programs without deadlines: from now on, `signals` set the returned flag, and interrupted().
/// If the second signal has no effect, a waiting system call ends early.
const Interrupt& watch_interrupts(std::initializer_list<int> signals, Second second);

/// From now on signals that would end the program set a flag, and the run ends after the current
/// step, or slot of a reset that waits for something. A second Ctrl-C within a second does nothing
/// more; a later one makes safe (see on_stop) and ends the program at once. Signals that would stop
/// it (Ctrl-Z) wait for stop_if_requested(). A crash makes safe, and then takes its default effect.
/// A closed pipe and a file that is too large are write errors. Signals that the caller ignores
/// stay ignored, except SIGINT and SIGTERM. Call it from the main thread, before others begin.
void catch_interrupts();

/// Written by handlers of signals.
extern Interrupt caught;
/// True after a signal that ends the run.
inline bool interrupted() {
  return caught.load(std::memory_order_relaxed);
}

/// A further reason to end a waiting reset: the agent is gone. nullptr: nothing.
void on_gone(bool (*is_gone)(void*), void* context);
/// For resets: whether the run is to end, or to stop.
bool ends_reset();

/// Sets the function that makes actuators safe outside of a step: before the program is stopped, in
/// a crash, at a second Ctrl-C. nullptr: no actuators.
void on_stop(void (*make_safe)(void*), void* context);

/// Does so now, for the main thread.
void make_safe_now();

/// Whether a signal wants the program to stop, and continue later.
bool is_stop_requested();
/// If so: makes safe and stops; returns when the program continues. For the main thread, where
/// actuators can be commanded: between two steps, or while a link is waited for.
void stop_if_requested();

/// After everything is written: ends the program by the signal that ended its run, if that was one
/// of those whose effect the caller expects (SIGQUIT, or one that means a crash).
void end_by_signal();

/// As long as it lives, `program` is made safe when something stops it, if it drives hardware.
template <class Program>
class MadeSafe {
 public:
  explicit MadeSafe(Program& program) {
    if constexpr (requires { program.make_safe(); }) {
      if (program.is_real())
        on_stop([](void* context) { static_cast<Program*>(context)->make_safe(); }, &program);
    }
  }
  MadeSafe(const MadeSafe&) = delete;
  MadeSafe& operator=(const MadeSafe&) = delete;
  ~MadeSafe() { on_stop(nullptr, nullptr); }
};

}  // namespace eagerx::host

extern "C" {
/// Whether a signal requests the run to end or to stop: for resets of hardware, which do not depend
/// on targets.
bool eagerx_is_interrupted();
}
