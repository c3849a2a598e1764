// The problem of a call, for eagerx_error().
#pragma once

#include <stdexcept>
#include <string>

namespace eagerx::environments {

/// Nothing else is thrown here on purpose; none of it leaves the library.
class Problem : public std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// Throws it. In a function of its own, so that callers are short.
[[noreturn]] void refuse(const char* text);
[[noreturn]] void refuse(const std::string& text);

/// The text of this thread's last failure.
const char* error_text();
void set_error(const std::string& text);
/// Keeps a text for error_text(); -1.
int fail(const char* text) noexcept;
/// fail() for what a handler has caught.
int fail_as_caught() noexcept;

}  // namespace eagerx::environments
