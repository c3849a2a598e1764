#include "generator/backend/compile/forbidden.hpp"

#include <cxxabi.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <memory>
#include <set>
#include <tuple>

#include "generator/support/diagnostics/search.hpp"
#include "generator/support/process/process.hpp"

namespace eagerx::gen {
namespace {

struct Kind {
  std::string_view what, fix;
  std::vector<std::string_view> names;
};

/// As targets/common/bare-metal/no_heap.cmake forbids them on boards, by their names on this
/// machine, and the functions whose last bit differs from library to library.
const std::vector<Kind>& kinds() {
  static const std::vector<Kind> kKinds = {
      {"takes memory from a heap",
       "use eagerx::Array, whose size is known when it is compiled",
       {"_Znwm", "_Znam", "_ZnwmSt11align_val_t", "_ZnamSt11align_val_t", "_ZnwmRKSt9nothrow_t",
        "_ZnamRKSt9nothrow_t", "malloc", "calloc", "realloc", "aligned_alloc", "posix_memalign"}},
      {"throws an exception",
       "count what went wrong, or give a value that says so",
       {"__cxa_throw", "__cxa_allocate_exception", "__cxa_rethrow", "_ZSt20__throw_length_errorPKc",
        "_ZSt20__throw_out_of_rangePKc", "_ZSt24__throw_out_of_range_fmtPKcz",
        "_ZSt17__throw_bad_allocv", "_ZSt25__throw_bad_function_callv",
        "_ZSt19__throw_logic_errorPKc"}},
      {"has a static variable that is made at its first use",
       "make it a member, or constexpr",
       {"__cxa_guard_acquire"}},
      {"uses the console or files",
       "send a message instead",
       {"printf", "puts", "putchar", "fprintf", "fputs", "fopen", "fwrite", "_ZSt4cout",
        "_ZSt4cerr"}}};
  return kKinds;
}

bool is_of_cmath(std::string_view name) {
  static constexpr std::array kNames = {
      "sin",   "cos",   "tan",   "asin",  "acos",  "atan", "atan2", "sincos", "sinh",  "cosh",
      "tanh",  "asinh", "acosh", "atanh", "exp",   "exp2", "exp10", "expm1",  "log",   "log2",
      "log10", "log1p", "pow",   "cbrt",  "hypot", "erf",  "erfc",  "tgamma", "lgamma"};
  const auto is = [&](std::string_view base) { return ranges::contains(kNames, base); };
  const bool suffix = name.ends_with('f') || name.ends_with('l');
  return is(name) || (suffix && is(name.substr(0, name.size() - 1)));
}

/// Why `name` is forbidden; empty if it is not.
std::pair<std::string, std::string> classify(std::string_view name) {
  if (is_of_cmath(name))
    return {
        fmt::format("calls `{}` of <cmath>, whose last bit differs from machine to machine", name),
        "use the function of this name in <eagerx/math.hpp>"};
  for (const Kind& kind : kinds()) {
    if (ranges::contains(kind.names, name)) return {std::string(kind.what), std::string(kind.fix)};
  }
  return {};
}

/// Memory that a program writes to, besides that of its own objects. Constants lie in .rodata, and
/// in .data.rel.ro if they have addresses in them.
bool is_writable(std::string_view section) {
  constexpr std::array<std::string_view, 4> kWritable = {".bss", ".data", ".tbss", ".tdata"};
  return !section.starts_with(".data.rel.ro") &&
         ranges::any_of(kWritable, [&](std::string_view kind) {
           return section == kind || section.starts_with(std::string(kind) + ".");
         });
}

/// "count" of `mine::Gain<…>::callback(…)::count`; empty if that cannot be said.
std::string variable_of(const std::string& symbol) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> text(
      abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status), &std::free);
  if (status != 0 || text == nullptr) return symbol.starts_with('.') ? std::string() : symbol;
  const std::string_view name = text.get();
  const std::size_t scope = name.rfind("::");
  return std::string(scope == std::string_view::npos ? name : name.substr(scope + 2));
}

/// The variables of an object file that are in such memory.
std::set<std::string> static_variables(const std::string& object) {
  std::set<std::string> result;
  const auto said = run_process({"nm", "-f", "sysv", "--defined-only", object});
  std::string_view text = said ? std::string_view(said->output) : std::string_view();
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const std::size_t bar = line.rfind('|');
    if (bar == std::string_view::npos || !is_writable(line.substr(bar + 1))) continue;
    line = line.substr(0, line.find('|'));
    result.emplace(line.substr(0, line.find_last_not_of(' ') + 1));
  }
  return result;
}

std::pair<std::string, std::string> classify_variable(const std::string& symbol) {
  if (symbol.starts_with("_ZGV")) return {};  // whether another one has been made
  const std::string name = variable_of(symbol);
  return {fmt::format("uses a static variable{}, which no reset sets and which all programs share",
                      name.empty() ? "" : fmt::format(" (`{}`)", name)),
          "make it a member, which `reset()` sets, or constexpr"};
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  while (true) {
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    if (line.empty()) return words;
    words.push_back(line.substr(0, line.find(' ')));
    line.remove_prefix(words.back().size());
  }
}

/// From the place itself outwards through what was inlined.
std::vector<ForbiddenCall::Place> places_of(const std::string& object, const std::string& section,
                                            const std::string& offset) {
  std::vector<ForbiddenCall::Place> places;
  const auto said = run_process({"addr2line", "-i", "-e", object, "-j", section, "0x" + offset});
  std::string_view text = said ? std::string_view(said->output) : std::string_view();
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    line = line.substr(0, line.find(" (discriminator"));
    const std::size_t colon = line.rfind(':');
    if (colon == std::string_view::npos) continue;
    std::uint32_t number = 0;
    std::from_chars(line.data() + colon + 1, line.data() + line.size(), number);
    places.push_back({std::string(line.substr(0, colon)), number});
  }
  return places;
}

}  // namespace

std::vector<ForbiddenCall> forbidden_calls(const std::string& object) {
  std::vector<ForbiddenCall> calls, uses;
  const auto said = run_process({"readelf", "-rW", object});
  if (!said) return calls;
  const std::set<std::string> variables = static_variables(object);
  std::string section;
  std::string_view text = said->output;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.starts_with("Relocation section '")) {
      constexpr std::string_view kBefore = "Relocation section '.rela";
      section.clear();
      if (line.starts_with(kBefore))
        section = line.substr(kBefore.size(), line.find('\'', kBefore.size()) - kBefore.size());
      if (!section.starts_with(".text")) section.clear();
      continue;
    }
    // offset info type value name - addend
    const auto words = words_of(line);
    constexpr std::size_t kName = 4;
    if (section.empty() || words.size() <= kName) continue;
    const std::string_view name = words[kName].substr(0, words[kName].find('@'));
    auto [what, fix] = classify(name);
    const std::string symbol(name);
    const bool variable = what.empty() && (is_writable(name) || variables.contains(symbol));
    if (variable) std::tie(what, fix) = classify_variable(symbol);
    if (what.empty()) continue;
    (variable ? uses : calls)
        .push_back({std::move(what), std::move(fix),
                    places_of(object, section, std::string(words[0])), variable ? symbol : ""});
  }
  calls.insert(calls.end(), uses.begin(), uses.end());
  return calls;
}

}  // namespace eagerx::gen
