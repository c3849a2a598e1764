#include "generator/tools/training/lines.hpp"

#include <fmt/format.h>

namespace eagerx::gen {

std::optional<std::string_view> TrainingLines::next() {
  if (left_.empty() || has_failed_) return std::nullopt;
  ++number_;
  const std::size_t end = left_.find('\n');
  if (end == std::string_view::npos) {
    fail("the line has no end: the file is cut off");
    return std::nullopt;
  }
  const std::string_view line = left_.substr(0, end);
  left_.remove_prefix(end + 1);
  return line;
}

bool TrainingLines::fail(const std::string& what) {
  if (!has_failed_)
    diagnostics_
        .io_error("E0363", {file_, number_, 1, 1},
                  fmt::format("`{}`{}: {}", sources_.name(file_),
                              number_ == 0 ? "" : fmt::format(", line {}", number_), what))
        .help =
        "give what `eagerx-gen train` wrote with `--record`, `--csv` or, of a sweep, `--results`";
  has_failed_ = true;
  return false;
}

}  // namespace eagerx::gen
