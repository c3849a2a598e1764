// eagerx-gen docs: opens the page of the reference that fits a word best in a browser.
#include <fmt/format.h>

#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "generator/driver/build/exec.hpp"
#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/commands.hpp"
#include "generator/driver/pipeline/paths.hpp"
#include "generator/frontend/library/other_names.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"
#include "generator/support/files/uri.hpp"
#include "generator/support/json/json.hpp"
#include "generator/support/process/process.hpp"

namespace eagerx::gen {
namespace {

struct DocsOptions {
  std::string word;
  bool address = false;
};

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Words of the reference with their pages, as the maker of the site wrote them; null if it did
/// not.
Json words_of(const std::string& site) {
  std::ifstream file(std::filesystem::path(site) / "words.json", std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return parse_json(text.str()).value_or(nullptr);
}

/// A browser that keeps what stands behind `#`: xdg-open does not, so it comes last. Empty without
/// a display to show one on.
std::string browser() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value == nullptr ? "" : value);
  };
  if (variable("DISPLAY").empty() && variable("WAYLAND_DISPLAY").empty()) return {};
  for (const std::string& name :
       std::array{variable("BROWSER"), std::string("x-www-browser"), std::string("xdg-open")}) {
    if (name.empty()) continue;
    if (std::string program = find_program(name); !program.empty()) return program;
  }
  return {};
}

/// The page of a word, from the folder of the site; empty if there is none.
std::string page_of(const Json& words, const std::string& word) {
  if (const Json* exact = member(&words, word)) return text_of(exact);
  if (const auto* known = words.as<Json::Object>()) {
    for (const auto& [name, page] : *known) {
      if (lower(name) == lower(word)) return text_of(&page);
    }
  }
  return {};
}

int not_there(const Json& words, const std::string& word) {
  std::vector<std::string> known;
  for (const auto& [name, page] : *words.as<Json::Object>()) known.push_back(name);
  const std::string near = nearest(word, known);
  const std::string other = meant_by_other_name(word, known);
  complain("error: the reference has no page for `{}`\nhelp: {}\n", word,
           !other.empty()  ? other
           : !near.empty() ? fmt::format("did you mean `{}`?", near)
                           : "`eagerx-gen docs` opens it at its beginning, with a search");
  return kWrongUsage;
}

int perform(const DocsOptions& options) {
  const std::string site = reference_folder();
  const Json words = site.empty() ? nullptr : words_of(site);
  if (!words.is<Json::Object>()) {
    complain(
        "error: this eagerx-gen is installed without its reference\nhelp: `cmake --build BUILD "
        "--target "
        "site` makes it; it needs the Debian packages cmark-gfm and python3-yaml\n");
    return kInputOutput;
  }
  const std::string page = options.word.empty() ? "index.html" : page_of(words, options.word);
  if (page.empty()) return not_there(words, options.word);
  const auto anchor = page.find('#');
  const std::string path = std::filesystem::path(site) / page.substr(0, anchor);
  const std::string address =
      uri_of_path(path) + (anchor == std::string::npos ? "" : page.substr(anchor));
  say("{}\n", address);
  const std::string program = options.address ? std::string() : browser();
  if (program.empty()) return kDone;
  flush_output();
  return exec(program, {address});
}

Command table(DocsOptions& options) {
  return {.name = "docs",
          .about = "open the reference manual in a browser, at the page of a word",
          .examples = {{"the first page, with a search", "eagerx-gen docs"},
                       {"an entity", "eagerx-gen docs ButterworthFilter"},
                       {"a code, a command, a key of the graph file",
                        "eagerx-gen docs E0307; eagerx-gen docs train; eagerx-gen docs budget"}},
          .arguments = {text("word", options.word,
                             "command, entity, target, code, or key of the graph file; a command "
                             "comes first (default: the first page)",
                             "WORD"),
                        flag("--address", options.address,
                             "only print the address, as without a display or a browser")},
          .run = [&options] { return perform(options); }};
}

}  // namespace

Command docs_command() {
  return with_options<DocsOptions>(table);
}

}  // namespace eagerx::gen
