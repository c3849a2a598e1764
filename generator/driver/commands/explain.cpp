// eagerx-gen explain: explains a code, or lists all codes.
#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <optional>

#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/commands.hpp"
#include "generator/support/diagnostics/pages.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/diagnostics/utf8.hpp"

namespace eagerx::gen {
namespace {

struct Group {
  std::string_view prefix;
  const char* about;
};
constexpr std::array kGroups = {
    Group{"E01", "reading text"},
    Group{"E02", "form of graphs and manifests"},
    Group{"E03", "names, spaces, parameters"},
    Group{"E04", "time, memory, budgets"},
    Group{"E05", "templates, packages, code of entities"},
    Group{"E06", "weight files"},
    Group{"E07", "policy against graph; E075x: what a weight file does not say"},
    Group{"E08", "files of EAGERx and of robots (URDF, MJCF)"},
    Group{"E09", "writing, images"},
    Group{"W01", "warnings: allowed, but hardly meant"},
};

/// `e307`, `0307` and `307` are E0307, `w101` is W0101; nullopt for what is no code.
std::optional<std::string> code_of(std::string_view word) {
  constexpr std::size_t kDigits = 4;
  const bool warning = word.starts_with('W') || word.starts_with('w');
  if (warning || word.starts_with('E') || word.starts_with('e')) word.remove_prefix(1);
  const bool digits = ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; });
  if (word.empty() || word.size() > kDigits || !digits) return std::nullopt;
  return fmt::format("{}{:0>{}}", warning ? 'W' : 'E', word, kDigits);
}

void list_all() {
  const auto pages = code_pages();
  for (const Group& group : kGroups) {
    say("{}xx {}\n", group.prefix, group.about);
    for (const CodePage& page : pages) {
      if (page.code.starts_with(group.prefix)) say("  {}  {}\n", page.code, page.title());
    }
  }
  say("\n`eagerx-gen explain CODE` says more about one of them\n");
}

/// The codes before and after one that does not exist.
std::string neighbours(const std::string& code) {
  const auto pages = code_pages();
  const auto behind =
      ranges::find_if(pages, [&](const CodePage& page) { return page.code > code; });
  std::string text;
  const auto add = [&](const CodePage& page) {
    text += fmt::format("{}{} ({})", text.empty() ? "" : " and ", page.code, page.title());
  };
  if (behind != pages.begin()) add(*std::prev(behind));
  if (behind != pages.end()) add(*behind);
  return text;
}

struct ExplainOptions {
  std::string code;  // empty: list all
};

int perform(const ExplainOptions& options) {
  if (options.code.empty()) {
    list_all();
    return kDone;
  }
  const auto code = code_of(options.code);
  if (!code) {
    complain(
        "error: `{}` is not a code\nhelp: codes are such as E0307; `eagerx-gen explain` "
        "lists them\n",
        options.code);
    return kWrongUsage;
  }
  for (const CodePage& page : code_pages()) {
    if (page.code != *code) continue;
    say_text(page.text);
    return kDone;
  }
  complain(
      "error: there is no code `{}`\nhelp: next to it are {}; `eagerx-gen explain` lists all\n",
      *code, neighbours(*code));
  return kWrongUsage;
}

Command table(ExplainOptions& options) {
  return {
      .name = "explain",
      .about = "explain the cause and the fix of a code such as E0307, or list all codes",
      .examples = {{"one code", "eagerx-gen explain E0307"}, {"all codes", "eagerx-gen explain"}},
      .arguments = {text("code", options.code,
                         "a code, such as E0307 or 307 (default: list all codes)", "CODE")},
      .run = [&options] { return perform(options); }};
}

}  // namespace

Command explain_command() {
  return with_options<ExplainOptions>(table);
}

}  // namespace eagerx::gen
