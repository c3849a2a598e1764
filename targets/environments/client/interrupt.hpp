// Ctrl-C, seen by a program that wants to end in order.
#pragma once

namespace eagerx::client {

/// From now on SIGINT and SIGTERM make the returned number another than 0; a second one ends the
/// program.
const volatile int& watch_interrupts();

}  // namespace eagerx::client
