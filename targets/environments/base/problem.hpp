// The problem of a call, for eagerx_error().
#pragma once

#include <stdexcept>
#include <string>

namespace eagerx::environments {

/// The only exception that is thrown on purpose; none leaves the library.
class Problem : public std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// Throws a Problem. A separate function, so that callers are short.
[[noreturn]] void refuse(const char* text);
[[noreturn]] void refuse(const std::string& text);

/// The text of this thread's last failure.
const char* error_text();
void set_error(const std::string& text);
/// Keeps a text for error_text(); -1.
int fail(const char* text) noexcept;
/// fail() for the exception that a handler has caught.
int fail_as_caught() noexcept;

}  // namespace eagerx::environments
