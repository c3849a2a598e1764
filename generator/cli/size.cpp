// eagerx-gen size: what an image takes, and whether that is within the graph's budget.
#include "generator/size/size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "generator/cli/paths.hpp"
#include "generator/cli/pipeline.hpp"
#include "generator/report/report.hpp"
#include "generator/size/tools.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// Runs the image in the target's emulator, where an instruction lasts 2^shift ns.
std::optional<Instructions> count_instructions(const Run& run, const Options& options) {
  constexpr int kShift = 5;
  constexpr double kNsPerInstruction = 1 << kShift;
  constexpr double kNsPerSecond = 1e9;
  Instructions result;
  double hz = 0, sum = 0, least = 0, most = 0;
  const auto value = [](const std::string& line, std::string_view name, double& number) {
    if (line.starts_with(name)) number = std::strtod(line.c_str() + name.size(), nullptr);
  };
  double slots = 0;
  const int code =
      for_each_line({"env", fmt::format("EAGERX_EMULATOR_OPTIONS=-icount shift={}", kShift),
                     (fs::path(run.root) / "targets" / "run").string(), options.run_on,
                     options.image, "--timing"},
                    [&](std::string_view view) {
                      const std::string line(view);
                      value(line, "clock ", hz);
                      value(line, "slots ", slots);
                      value(line, "busy least ", least);
                      value(line, "busy most ", most);
                      value(line, "busy sum ", sum);
                    });
  if (code != 0 || hz <= 0 || slots <= 0) return std::nullopt;
  const double instructions_per_tick = kNsPerSecond / hz / kNsPerInstruction;
  result.slots = static_cast<std::uint64_t>(slots);
  result.least = static_cast<std::uint64_t>(std::llround(least * instructions_per_tick));
  result.most = static_cast<std::uint64_t>(std::llround(most * instructions_per_tick));
  result.mean = sum * instructions_per_tick / slots;
  return result;
}

class BudgetCheck {
 public:
  BudgetCheck(const SizeReport& report, const std::optional<Json>& baseline,
              Diagnostics& diagnostics)
      : report_(report), baseline_(baseline), diagnostics_(diagnostics) {}

  void run(const YamlValue& budget) {
    check(budget, "flash", "bytes of flash", report_.flash);
    check(budget, "ram", "bytes of RAM", report_.ram);
    check(budget, "stack", "bytes of stack", report_.stack.bytes);
    if (report_.instructions)
      check(budget, "instructions", "instructions in a slot", report_.instructions->most);
    else if (const YamlValue* entry = budget.find("instructions"))
      diagnostics_.error("E0422", entry->span, "instructions have a budget, but were not counted")
          .help = "give `--run TARGET`";
    const YamlValue* nodes = budget.find("nodes");
    if (nodes == nullptr) return;
    for (const auto& entry : nodes->entries) check_node(entry);
  }

 private:
  void check_node(const YamlValue::Entry& entry) {
    const Usage* usage = find(entry.key);
    if (usage == nullptr) {
      diagnostics_.error("E0421", entry.key_span,
                         fmt::format("the image has no node `{}`", entry.key));
      return;
    }
    check_part(entry, "flash", "bytes of flash", usage->flash);
    check_part(entry, "ram", "bytes of RAM", usage->ram);
  }

  const Usage* find(const std::string& name) const {
    for (const auto* parts : {&report_.nodes, &report_.others}) {
      if (const auto found = parts->find(name); found != parts->end()) return &found->second;
    }
    return nullptr;
  }

  void check_part(const YamlValue::Entry& node, const char* key, const char* unit,
                  std::uint64_t used) {
    const YamlValue* entry = node.value.find(key);
    if (entry == nullptr || used <= limit(*entry)) return;
    diagnostics_.error("E0420", entry->span,
                       fmt::format("`{}` takes {} {}, {} over its budget of {}", node.key, used,
                                   unit, used - limit(*entry), limit(*entry)));
  }

  void check(const YamlValue& budget, const char* key, const char* unit, std::uint64_t used) {
    const YamlValue* entry = budget.find(key);
    if (entry == nullptr || used <= limit(*entry)) return;
    auto& problem =
        diagnostics_.error("E0420", entry->span,
                           fmt::format("the image takes {} {}, {} over its budget of {}", used,
                                       unit, used - limit(*entry), limit(*entry)));
    problem.help = who(key);
  }

  static std::uint64_t limit(const YamlValue& entry) {
    return std::strtoull(entry.text.c_str(), nullptr, 10);
  }

  /// Who grew since the baseline; without one, who takes most.
  std::string who(const std::string& key) const {
    if (key != "flash" && key != "ram") return {};
    std::vector<std::pair<std::int64_t, std::string>> parts;
    for (const auto* group : {&report_.nodes, &report_.others}) {
      const char* name = group == &report_.nodes ? "nodes" : "others";
      for (const auto& [part, usage] : *group) {
        const auto now = static_cast<std::int64_t>(key == "flash" ? usage.flash : usage.ram);
        parts.emplace_back(now - before(name, part, key), part);
      }
    }
    std::sort(parts.rbegin(), parts.rend());
    std::string text = !baseline_ ? "most of it: " : "grown since the baseline: ";
    constexpr std::size_t kShown = 3;
    bool first = true;
    for (std::size_t i = 0; i < std::min(kShown, parts.size()); ++i) {
      if (parts[i].first <= 0) break;
      text += fmt::format("{}`{}` {}{}", first ? "" : ", ", parts[i].second, !baseline_ ? "" : "+",
                          parts[i].first);
      first = false;
    }
    return first ? std::string() : text;
  }

  std::int64_t before(const char* group, const std::string& part, const std::string& key) const {
    const Json* in = baseline_ ? &*baseline_ : nullptr;
    const auto bytes = number_of(member(member(member(in, group), part), key));
    return static_cast<std::int64_t>(bytes.value_or(0.0));
  }

  const SizeReport& report_;
  const std::optional<Json>& baseline_;
  Diagnostics& diagnostics_;
};

/// Nothing without --baseline.
std::optional<Json> read_baseline(Run& run, const Options& options) {
  if (options.baseline.empty()) return std::nullopt;
  std::ifstream file(options.baseline);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  auto json = parse_json(text);
  if (!json || !json->is<Json::Object>()) {
    run.diagnostics.io_error("E0911", {}, fmt::format("cannot read `{}`", options.baseline)).help =
        "give what `eagerx-gen size --json` printed";
    return std::nullopt;
  }
  return json;
}

void print_report(const SizeReport& report, const std::optional<PlanReport>& plan, bool as_json) {
  if (!as_json) {
    say("{}{}", size_text(report), plan ? timing_text(*plan) : "");
    return;
  }
  Json json = size_json(report);
  if (plan) {
    Json timing = report_json(*plan);
    json["ages"] = std::move(timing["ages"]);
    json["link"] = std::move(timing["link"]);
  }
  say("{}\n", dump_json(json));
}

}  // namespace

int size_command(const Options& options) {
  Run run;
  run.root = data_root();
  std::optional<PlanReport> plan;
  if (!options.graph.empty() && make(run, options)) plan = report_of(*run.plan);
  const std::optional<Json> baseline = read_baseline(run, options);
  if (run.diagnostics.has_errors()) return finish(run, options);
  const std::string folder = fs::path(options.image).parent_path().string();
  const std::string build = !options.build.empty() ? options.build : folder.empty() ? "." : folder;
  auto report = measure_image(options.image, build, run.diagnostics);
  if (!report) return finish(run, options);
  if (!options.run_on.empty()) {
    report->instructions = count_instructions(run, options);
    if (!report->instructions)
      run.diagnostics.io_error(
          "E0911", {}, fmt::format("cannot run `{}` on `{}`", options.image, options.run_on));
  }
  if (!options.quiet) print_report(*report, plan, options.json_output);
  if (plan && run.spec->budget) {
    BudgetCheck(*report, baseline, run.diagnostics).run(*run.spec->budget);
    check_plan_budget(*plan, *run.spec->budget, run.diagnostics);
  }
  return finish(run, options);
}

}  // namespace eagerx::gen
