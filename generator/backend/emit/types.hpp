// C++ types that more than one template writes.
#pragma once

#include <string>

#include "generator/backend/emit/names.hpp"

namespace eagerx::gen {

/// "eagerx::Window<float, eagerx::Rate<30>, 1, 1, true>"; observations are padded.
std::string window_type(const Plan& plan, std::size_t node, std::size_t input,
                        Numbers numbers = Numbers::plain);
/// The constructor arguments of that window at a tick: "{smooth_filtered_, n30Hz_}".
std::string window_argument(const Plan& plan, const ProgramNames& names, std::size_t node,
                            std::size_t input);
/// Whether these check the rates due in the slot.
bool asks_what_is_due(const Plan& plan, std::size_t node, std::size_t input);
/// Where message `seq` is written: "smooth_filtered_[0]".
std::string ring_place(const Plan& plan, const ProgramNames& names, std::size_t ring,
                       const std::string& seq);

}  // namespace eagerx::gen
