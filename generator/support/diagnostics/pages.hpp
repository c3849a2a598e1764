// A page for every code: cause, example, fix. They are the files of codes/, built into the
// program.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace eagerx::gen {

class Diagnostics;

/// The page of one code, the Markdown of codes/<code>.md. Its first line is `# <code>: <title>`.
struct CodePage {
  std::string_view code;  // "E0307"
  std::string_view text;

  [[nodiscard]] std::string_view title() const;
};

/// All pages, in the order of their codes.
std::span<const CodePage> code_pages();

/// The line that refers to the pages of the errors; empty without errors.
std::string pointer_to_pages(const Diagnostics& diagnostics);

}  // namespace eagerx::gen
