// Ctrl-C, seen by a program that wants to end in order.
#pragma once

#include <atomic>

namespace eagerx::client {

/// Whether somebody wants the end. Set by a signal, read by all threads.
using Interrupt = std::atomic<bool>;
static_assert(Interrupt::is_always_lock_free);  // a handler of signals may write it

/// From now on SIGINT and SIGTERM set what is returned; a second one ends the program.
const Interrupt& watch_interrupts();

}  // namespace eagerx::client
