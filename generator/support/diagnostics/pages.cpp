#include "generator/support/diagnostics/pages.hpp"

#include <fmt/format.h>

#include <set>
#include <vector>

#include "generator/support/diagnostics/diagnostics.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {

std::string_view CodePage::title() const {
  const std::size_t begin = text.find(": ") + 2;
  return text.substr(begin, text.find('\n') - begin);
}

std::string pointer_to_pages(const Diagnostics& diagnostics) {
  std::set<std::string_view> codes;
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.severity == Severity::error) codes.insert(diagnostic.code);
  }
  if (codes.empty()) return {};
  if (codes.size() == 1)
    return fmt::format("`eagerx-gen explain {}` says more about this error\n", *codes.begin());
  return fmt::format("`eagerx-gen explain CODE` says more about each of {}\n",
                     join(std::vector(codes.begin(), codes.end()), ", "));
}

}  // namespace eagerx::gen
