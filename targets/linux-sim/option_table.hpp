// Name, value and effect of each option of the command line.
#pragma once

#include <span>
#include <string_view>
#include <targets/linux-sim/options.hpp>

namespace eagerx::linux_sim {

/// One option: the parser and the help are both made from this table.
struct Option {
  std::string_view name;
  std::string_view value;  // what stands for its value in the help; empty: takes none
  std::string_view wants;  // what its value must be, for errors
  std::string_view about;
  bool (*set)(Options&, std::string_view);
  bool split = false;  // only for programs of which a part runs elsewhere
};

/// In the order of the help.
std::span<const Option> all_options();

}  // namespace eagerx::linux_sim
