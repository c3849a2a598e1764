#include "generator/analysis/plausibility/plausibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/pages.hpp"

namespace eagerx::gen {

void check_plausibility(const CheckedGraph& checked, Diagnostics& diagnostics) {
  check_actions(checked, diagnostics);
  check_units(checked, diagnostics);
  check_wiring(checked, diagnostics);
  check_sensors(checked, diagnostics);
  check_memory(checked, diagnostics);
  check_keys(checked, diagnostics);
  check_outputs(checked, diagnostics);
  check_task(checked.graph, diagnostics);
  check_numbers(checked, diagnostics);
  check_steps(checked, diagnostics);
  check_kept_states(checked, diagnostics);
  check_files(checked, diagnostics);
}

void check_keys(const CheckedGraph& checked, Diagnostics& diagnostics) {
  const auto& timeout = checked.spec.reset_timeout_s;
  if (!timeout || checked.graph.has_reset_nodes()) return;
  diagnostics
      .warning("W0109", timeout->span,
               "`reset_timeout` does nothing: this graph has no reset nodes")
      .help = "leave it out";
}

void allow_warnings(const std::vector<Spanned<std::string>>& allowed, bool complete,
                    Diagnostics& diagnostics) {
  std::set<std::string> given;
  for (const auto& diagnostic : diagnostics.all()) {
    if (diagnostic.severity == Severity::warning) given.insert(diagnostic.code);
  }
  std::vector<std::string> known;
  for (const CodePage& page : code_pages()) {
    if (page.code.starts_with('W')) known.emplace_back(page.code);
  }
  std::vector<std::string> codes;
  for (const auto& [code, span] : allowed) {
    if (!contains(known, code)) {
      auto& problem =
          diagnostics.warning("W0108", span, fmt::format("there is no warning `{}`", code));
      problem.help = code.starts_with('E') ? "errors cannot be allowed: `allow` takes codes of "
                                             "warnings, such as W0103"
                                           : "`eagerx-gen explain` lists all codes";
    } else if (contains(codes, code)) {
      diagnostics.warning("W0108", span, fmt::format("`{}` is allowed twice", code)).help =
          "leave it out";
    } else if (complete && !given.contains(code)) {
      diagnostics
          .warning("W0108", span,
                   fmt::format("`{}` is allowed, but this graph does not give it", code))
          .help = "leave it out, so that you are warned when the graph gives it";
    }
    codes.push_back(code);
  }
  // Problems in `allow` itself cannot be allowed.
  std::erase(codes, "W0108");
  diagnostics.drop_warnings(codes);
}

}  // namespace eagerx::gen
