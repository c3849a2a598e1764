#include "generator/driver/commands/topics.hpp"

#include <fmt/format.h>

#include "generator/driver/commands/train_settings.hpp"
#include "generator/frontend/read/bytes.hpp"
#include "generator/frontend/read/quantity.hpp"
#include "generator/frontend/spec/graph_spec.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

/// `text` in lines of at most 72 letters, each after `indent` blanks but the first.
std::string wrapped(std::string_view text, std::size_t indent) {
  constexpr std::size_t kWidth = 72;
  std::string result;
  std::size_t column = indent;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    if (column > indent && column + 1 + word.size() > kWidth) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (column > indent) {
      result += " ";
      ++column;
    }
    result += word;
    column += word.size();
    text.remove_prefix(std::min(word.size() + 1, text.size()));
  }
  return result;
}

/// From the table that checks graphs.
std::string graph_text() {
  constexpr std::size_t kIndent = 16;
  std::string text =
      "A graph file is YAML with these keys. `eagerx-gen schema` prints all of them for "
      "editors.\n\n";
  for (const Field& field : graph_format().fields)
    text += fmt::format("{:<{}}{}\n", field.name, kIndent,
                        wrapped(field.about + (field.required ? " (required)" : ""), kIndent));
  return text;
}

std::string units_text() {
  return fmt::format(
      "Rates and times may have a unit: `rate: 30 Hz`, `delay: 10ms`, `delay: 1/3 s`.\n"
      "Without a unit, rates are in Hz and times in seconds. Case counts.\n\n"
      "rates   {}\ntimes   {} (or \u00b5s)\nangles  {}\ngains   {} (of margins)\nmemory  {} (of "
      "`budget:`; k is 1024, M is 1024 k)\n",
      join(units_of(Quantity::rate), ", "), join(units_of(Quantity::time), ", "),
      join(units_of(Quantity::angle), ", "), join(units_of(Quantity::gain), ", "),
      join(units_of_memory(), ", "));
}

constexpr const char* kLibrary =
    "Entities and targets are folders with a manifest.yaml. They are looked for in\n\n"
    "1. the folders given with --path, in their order\n"
    "2. the folders of the graph's `library:`, relative to the graph file\n"
    "3. models and targets of eagerx-gen itself, or of the folder that the environment\n"
    "   variable EAGERX_HOME names\n\n"
    "`eagerx-gen info` lists what was found. An id must not be defined twice. Copies of\n"
    "them in an output folder are ignored.\n";

constexpr const char* kExitCodes =
    "0  done\n"
    "1  problems found: the messages say which\n"
    "2  wrong usage\n"
    "3  cannot read or write\n"
    "4  a bug in eagerx-gen\n";

}  // namespace

std::vector<Topic> help_topics() {
  return {
      {"graph-file", "the keys of a graph file", graph_text()},
      {"units", "units of rates and times", units_text()},
      {"library", "where eagerx-gen searches entities and targets", kLibrary},
      {"train-settings", "settings of `train`, with defaults and ranges", train_settings_text()},
      {"exit-codes", "meaning of exit codes", kExitCodes}};
}

}  // namespace eagerx::gen
