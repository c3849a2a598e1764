// Numbers in readable form, and words of a text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace eagerx::client {

/// 75 as "1:15".
std::string minutes(double seconds);
/// 153211 as "153,000": three digits that matter.
std::string rounded(double number);

/// The texts between the separators: "a,,b" are "a", "" and "b"; an empty text is one piece.
std::vector<std::string_view> pieces_of(std::string_view text, char separator);

}  // namespace eagerx::client
