// The output of commands: the only way to the standard output, so that a full disk is reported, and
// foreign text cannot control a terminal.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// Prints text of lines. Characters that would do something else than be drawn are written as
/// `\x1b` or `\u202e`.
void say_text(std::string_view text);
/// The same of a table: tabs are meant, too.
void say_table(std::string_view text);
/// The same as say_text(), formatted.
template <class... Ts>
void say(fmt::format_string<Ts...> format, Ts&&... values) {
  say_text(fmt::format(format, std::forward<Ts>(values)...));
}

/// Prints to the standard error text that does not belong into a file.
void complain_text(std::string_view text);
template <class... Ts>
void complain(fmt::format_string<Ts...> format, Ts&&... values) {
  complain_text(fmt::format(format, std::forward<Ts>(values)...));
}

/// Waits until all that was printed has been taken. If something was not, the first call after that
/// says why, such as "No space left on device".
std::optional<std::string> flush_output();

/// Reports the reason that flush_output() returned: E0901.
void report_output(const std::string& why, Diagnostics& diagnostics);

/// Opens /dev/null where the standard input, output or error is closed: a file that is opened later
/// must not get its number.
void open_standard_descriptors();

}  // namespace eagerx::gen
