// Words of the code in a TorchScript archive.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/policy/network/problem.hpp"

namespace eagerx::gen {

struct TorchToken {
  enum class Kind : std::uint8_t { name, number, text, sign, end };
  Kind kind = Kind::end;
  std::string_view text;  // of a text: without its quotes, as written
  int line = 1;
  int indent = 0;              // of its logical line
  bool first_of_line = false;  // of a logical line; brackets hold lines together
};

/// The last one is of kind `end`. E0753 where a character has no meaning.
std::optional<std::vector<TorchToken>> torch_tokens(std::string_view text, const std::string& file,
                                                    PolicyProblem& problem);

}  // namespace eagerx::gen
