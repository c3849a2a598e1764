// The floating-point environment of this process.
#pragma once

namespace eagerx::linux_sim {

/// Makes the processor keep denormal numbers and round to the nearest, whatever a library or a flag
/// of the linker has set, in this thread and those that it starts. False if it does not obey.
/// `was_wrong`: whether there was something to put right.
bool put_floats_right(bool& was_wrong);

/// The message for calculates_as_everywhere() being false at the end of a run.
extern const char* const kFloatsWentWrong;

}  // namespace eagerx::linux_sim
