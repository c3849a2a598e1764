#include "generator/driver/commands/program_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>

#include "generator/driver/commands/arguments.hpp"
#include "generator/frontend/read/text.hpp"
#include "generator/frontend/spec/format.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

FormatPtr named(const char* what, const FormatPtr& item) {
  Format format = *format::file_map(what);
  format.item = item;
  return std::make_shared<const Format>(std::move(format));
}

/// Keys of a file of options.
const Format& options_format() {
  static const FormatPtr kFormat = [] {
    const FormatPtr reason = format::text("a reason");
    const FormatPtr number = format::text("a whole number");
    const FormatPtr value = format::record(
        "an option",
        {{"from", number, false, "its value is a whole number, at least this"},
         {"to", number, false, "and at most this"},
         {"one_of", format::list("a list of words", format::text("a word"), 1), false,
          "its values"},
         {"value", format::text("a word"), false,
          "what its value is called, which the program checks"},
         {"split", format::boolean(), false, "only for programs of which a part runs elsewhere"},
         {"without", reason, false, "why it has no value"}});
    return format::record(
        "the options",
        {{"takes", named("options", value), true, "what the program takes"},
         {"always", named("options", reason), false, "what it does anyway, and why"},
         {"never", named("options", reason), false, "what it does not do, and why"}});
  }();
  return *kFormat;
}

std::optional<std::uint64_t> whole_number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool good = !text.empty() && error == std::errc() && end == text.data() + text.size();
  return good ? std::optional(value) : std::nullopt;
}

/// "--steps N", "--agent policy|zero|random", "--trace FILE", "--csv"
std::string usage_of(const YamlValue::Entry& option) {
  if (option.value.find("from") != nullptr) return option.key + " N";
  if (const YamlValue* value = option.value.find("value")) return option.key + " " + value->text;
  std::vector<std::string> words;
  if (const YamlValue* values = option.value.find("one_of")) {
    for (const YamlValue& word : values->items) words.push_back(word.text);
  }
  return words.empty() ? option.key : fmt::format("{} {}", option.key, join(words, "|"));
}

class Checker {
 public:
  /// `is_split`: a part of the graph runs elsewhere.
  Checker(const YamlValue& table, const Target& target, bool is_split, Diagnostics& diagnostics)
      : takes_(*table.find("takes")),
        always_(table.find("always")),
        never_(table.find("never")),
        target_(target.id.value),
        is_split_(is_split),
        diagnostics_(diagnostics) {}

  /// The words that the program gets.
  std::vector<std::string> run(const std::vector<std::string>& words) {
    std::vector<std::string> passed;
    for (std::size_t i = 0; i < words.size(); ++i) {
      const std::size_t equals = words[i].find('=');
      const std::string name = words[i].substr(0, equals);
      if (always_ != nullptr && always_->find(name) != nullptr) continue;
      const auto option = ranges::find(takes_.entries, name, &YamlValue::Entry::key);
      if (option == takes_.entries.end() || !is_for_this(*option)) {
        refuse(name, i > 0 ? words[i - 1] : std::string());
        while (i + 1 < words.size() && !words[i + 1].starts_with("--")) ++i;  // its value
        continue;
      }
      passed.push_back(name);
      if (usage_of(*option) == name) {
        if (equals != std::string::npos) refuse_value(*option, words[i].substr(equals + 1));
        continue;
      }
      const bool next = equals == std::string::npos && i + 1 < words.size();
      const std::string value = next                          ? words[++i]
                                : equals != std::string::npos ? words[i].substr(equals + 1)
                                                              : std::string();
      check_value(*option, value);
      passed.push_back(value);
    }
    return passed;
  }

 private:
  Diagnostic& error(const std::string& message) { return diagnostics_.error("E0516", {}, message); }

  [[nodiscard]] bool is_for_this(const YamlValue::Entry& option) const {
    const YamlValue* split = option.value.find("split");
    return is_split_ || split == nullptr || split->text != "true";
  }

  void refuse(const std::string& name, const std::string& before) {
    const auto option = ranges::find(takes_.entries, before, &YamlValue::Entry::key);
    if (option != takes_.entries.end() && !name.starts_with("--"))
      return refuse_value(*option, name);
    auto& problem =
        error(fmt::format("a program for `{}` does not take `{}`", target_, shortened(name)));
    if (takes_.find(name) != nullptr) {
      problem.help = "only a graph with parts takes it: `placement:`, or `--split NAME=TARGET`";
      return;
    }
    const YamlValue* reason = never_ != nullptr ? never_->find(name) : nullptr;
    if (reason != nullptr) {
      problem.help = reason->text;
      return;
    }
    std::vector<std::string> known, usage;
    for (const auto& each : takes_.entries) {
      if (!is_for_this(each)) continue;
      known.push_back(each.key);
      usage.push_back(usage_of(each));
    }
    const std::string all = ranges::contains(known, "--help")
                                ? "`eagerx-gen run GRAPH.yaml -- --help` lists what it takes"
                                : fmt::format("it takes {}", join(usage, ", "));
    // Unknown options went to the program, but may have been meant for eagerx-gen.
    GenerateOptions ignored;
    for (const Argument& argument : on_building(ignored)) {
      if (!argument.is_option()) continue;
      for (std::string& each : comma_separated(argument.names)) known.push_back(std::move(each));
    }
    problem.help = did_you_mean(name, known, all);
  }

  void refuse_value(const YamlValue::Entry& option, const std::string& value) {
    const YamlValue* reason = option.value.find("without");
    error(fmt::format("`{}` has no value in a program for `{}`: `{}`", option.key, target_,
                      shortened(value)))
        .help = reason != nullptr ? reason->text : fmt::format("write `{}` alone", option.key);
  }

  void check_value(const YamlValue::Entry& option, const std::string& value) {
    const YamlValue* words = option.value.find("one_of");
    if (option.value.find("value") != nullptr) {
      if (!value.empty()) return;
    } else if (words != nullptr) {
      if (ranges::contains(words->items, value, &YamlValue::text)) return;
    } else {
      const auto bound = [&](const char* key, std::uint64_t otherwise) {
        const YamlValue* limit = option.value.find(key);
        return limit != nullptr ? whole_number(limit->text).value_or(otherwise) : otherwise;
      };
      const auto number = whole_number(value);
      if (number && *number >= bound("from", 0) && *number <= bound("to", UINT64_MAX)) return;
    }
    auto& problem = error(
        value.empty() ? fmt::format("`{}` needs a value", option.key)
                      : fmt::format("`{}` is not a value of `{}`", shortened(value), option.key));
    const YamlValue* from = option.value.find("from");
    const YamlValue* to = option.value.find("to");
    problem.help = fmt::format("write `{}`", usage_of(option));
    if (from != nullptr)
      problem.help += fmt::format(", a whole number from {} {}", from->text,
                                  to != nullptr ? "to " + to->text : "on");
  }

  const YamlValue& takes_;
  const YamlValue* always_;
  const YamlValue* never_;
  std::string target_;
  bool is_split_;
  Diagnostics& diagnostics_;
};

/// The file of options of a program's main loop, by what its sources include; empty if there is
/// none.
std::string options_file(const Run& run, const Target& target) {
  for (const auto& each : target.templates) {
    const LoadedFile source = load_file(each.first, ReadLimits().max_bytes);
    constexpr std::string_view kBegin = "#include <targets/", kEnd = "/app.hpp>";
    const std::size_t end = source.bytes.find(kEnd);
    const std::size_t begin = source.bytes.rfind(kBegin, end);
    if (begin == std::string::npos || end == std::string::npos) continue;
    const std::string place =
        source.bytes.substr(begin + kBegin.size(), end - begin - kBegin.size());
    const fs::path file = fs::path(run.root) / "targets" / place / "options.yaml";
    std::error_code error;
    if (place.find('\n') == std::string::npos && fs::exists(file, error)) return file.string();
  }
  return {};
}

}  // namespace

bool check_program_options(Run& run, const Target& target, std::vector<std::string>& words) {
  const std::string file = words.empty() ? std::string() : options_file(run, target);
  if (file.empty()) return true;
  const std::size_t errors_before = run.diagnostics.error_count();
  const YamlValue table = read_yaml_file(file, run.sources, run.diagnostics);
  if (run.diagnostics.error_count() != errors_before ||
      !check(table, options_format(), run.diagnostics))
    return false;
  words = Checker(table, target, run.graph->placement.has_value(), run.diagnostics).run(words);
  return run.diagnostics.error_count() == errors_before;
}

}  // namespace eagerx::gen
