// The floating-point environment of this process.
#pragma once

namespace eagerx::linux_sim {

/// Makes the processor keep denormal numbers and round to nearest, regardless of settings by a
/// library or a flag of the linker, in this thread and those that it starts. False if that fails.
/// `was_wrong`: whether the mode was wrong.
bool put_floats_right(bool& was_wrong);

/// The message for calculates_as_everywhere() being false at the end of a run.
extern const char* const kFloatsWentWrong;

}  // namespace eagerx::linux_sim
