// Time on a board: ticks of a hardware timer since the start of the program, in 64 bits.
#pragma once

#include <cstdint>

namespace eagerx::board {

/// Starts the timer, from 0. A running timer continues.
void start_clock();
/// Ticks so far.
std::uint64_t clock_ticks();
/// Waits until this tick, and returns as soon as the core can; immediately if it has passed.
void wait_for_clock(std::uint64_t ticks);
/// Ticks a second.
std::uint64_t clock_hz();

}  // namespace eagerx::board
