// Numbers for people.
#pragma once

#include <string>

namespace eagerx::client {

/// 75 as "1:15".
std::string minutes(double seconds);
/// 153211 as "153,000": three digits that matter.
std::string rounded(double number);

}  // namespace eagerx::client
