#include "generator/analysis/bound/blame.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace eagerx::gen::bound {
namespace {

/// Files of the compiler's libraries: where Debian has their headers, and what their own debug
/// information names.
bool is_of_library(const std::string& file) {
  constexpr std::array<std::string_view, 4> kParts = {"/usr/include/", "/usr/lib/", "newlib",
                                                      "libgcc"};
  return std::ranges::any_of(
      kParts, [&](std::string_view part) { return file.find(part) != std::string::npos; });
}

/// Finds the calls that lead to an obstacle, the outermost first.
bool find_calls(const Analysed& function, const Obstacle& obstacle, std::set<const Analysed*>& seen,
                std::vector<Address>& calls) {
  if (!seen.insert(&function).second) return false;
  if (std::ranges::find(function.obstacles, obstacle) != function.obstacles.end()) return true;
  for (const auto& [at, callee] : function.calls) {
    calls.push_back(at);
    if (find_calls(*callee, obstacle, seen, calls)) return true;
    calls.pop_back();
  }
  return false;
}

std::vector<Address> calls_to(const Obstacle& obstacle, const std::set<Address>& roots,
                              Analysis& analysis) {
  std::set<const Analysed*> seen;
  std::vector<Address> calls;
  for (const Address root : roots) {
    if (find_calls(analysis.of(root), obstacle, seen, calls)) break;
  }
  return calls;
}

}  // namespace

std::optional<Blamed> blamed_for(const Obstacle& obstacle, const std::set<Address>& roots,
                                 Analysis& analysis, const Places& places) {
  std::vector<Address> way = calls_to(obstacle, roots, analysis);
  way.push_back(obstacle.at);
  std::optional<std::uint32_t> callee;
  for (auto at = way.rbegin(); at != way.rend(); ++at) {
    const Instruction* instruction = analysis.image().instruction(*at);
    if (instruction == nullptr) continue;
    for (const Frame& frame : places.of(*instruction)) {
      const std::string& file = places.files()[frame.file];
      if (frame.line > 0 && !is_of_library(file)) return Blamed{frame, callee};
      callee = frame.function;
    }
  }
  return std::nullopt;
}

}  // namespace eagerx::gen::bound
