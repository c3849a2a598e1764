#include "generator/driver/commands/image_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "generator/backend/program_map/program_map.hpp"
#include "generator/driver/commands/image_time.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/command_line/output.hpp"

namespace eagerx::gen {
namespace {

class BudgetCheck {
 public:
  BudgetCheck(const MeasuredImage& image, Diagnostics& diagnostics)
      : image_(image), report_(image.report), diagnostics_(diagnostics) {}

  void run(const BudgetSpec& budget) {
    check(budget.flash, "flash", "bytes of flash", report_.flash);
    check(budget.ram, "ram", "bytes of RAM", report_.ram);
    check(budget.stack, "stack", "bytes of stack", report_.stack.bytes);
    if (report_.instructions)
      check(budget.instructions, "", "instructions in a slot", report_.instructions->most);
    else if (budget.instructions && !image_.parts)
      diagnostics_
          .error("E0422", budget.instructions->span,
                 "instructions have a budget, but were not counted")
          .help = "give `--run TARGET`";
    if (!budget.nodes) return;
    for (const NodeBudgetSpec& node : *budget.nodes)
      if (!image_.parts || contains(*image_.parts, node.name.value)) check_node(node);
  }

 private:
  using Limit = std::optional<Spanned<std::uint64_t>>;

  void check_node(const NodeBudgetSpec& node) {
    const Usage* usage = find(node.name.value);
    if (usage == nullptr && image_.parts) return;  // nothing is left of it
    if (usage == nullptr) {
      diagnostics_.error("E0421", node.name.span,
                         fmt::format("{} has no node `{}`", image_.what, node.name.value));
      return;
    }
    const std::string name = fmt::format("`{}`", node.name.value);
    check_limit(node.flash, name, "bytes of flash", usage->flash);
    check_limit(node.ram, name, "bytes of RAM", usage->ram);
  }

  const Usage* find(const std::string& name) const {
    for (const auto* parts : {&report_.nodes, &report_.others}) {
      if (const auto found = parts->find(name); found != parts->end()) return &found->second;
    }
    return nullptr;
  }

  /// The problem if more is used than the limit; else nullptr.
  Diagnostic* check_limit(const Limit& limit, const std::string& whose, const char* unit,
                          std::uint64_t used) {
    if (!limit || used <= limit->value) return nullptr;
    return &diagnostics_.error("E0420", limit->span,
                               fmt::format("{} takes {} {}, {} over its budget of {}", whose, used,
                                           unit, used - limit->value, limit->value));
  }

  /// `key`: of a report, which says who takes most.
  void check(const Limit& limit, std::string_view key, const char* unit, std::uint64_t used) {
    Diagnostic* const problem = check_limit(limit, image_.what, unit, used);
    if (problem == nullptr) return;
    if (key == "flash" || key == "ram") problem->help = who(std::string(key));
    if (key != "stack") return;
    std::string calls = "the deepest chain of calls, and the bytes of each:\n";
    calls += stack_text(report_.stack);
    calls.pop_back();
    problem->notes.push_back({std::move(calls), {}, ""});
  }

  /// Who grew since the baseline; without one, who takes most.
  std::string who(const std::string& key) const {
    std::vector<std::pair<std::int64_t, std::string>> parts;
    for (const auto* group : {&report_.nodes, &report_.others}) {
      const char* name = group == &report_.nodes ? "nodes" : "others";
      for (const auto& [part, usage] : *group) {
        const auto now = static_cast<std::int64_t>(key == "flash" ? usage.flash : usage.ram);
        parts.emplace_back(now - before(name, part, key), part);
      }
    }
    std::sort(parts.rbegin(), parts.rend());
    std::string text = !image_.baseline ? "most of it: " : "grown since the baseline: ";
    constexpr std::size_t kShown = 3;
    bool first = true;
    for (std::size_t i = 0; i < std::min(kShown, parts.size()); ++i) {
      if (parts[i].first <= 0) break;
      text += fmt::format("{}`{}` {}{}", first ? "" : ", ", parts[i].second,
                          !image_.baseline ? "" : "+", parts[i].first);
      first = false;
    }
    return first ? std::string() : text;
  }

  std::int64_t before(const char* group, const std::string& part, const std::string& key) const {
    const Json* in = image_.baseline ? &*image_.baseline : nullptr;
    const auto bytes = number_of(member(member(member(in, group), part), key));
    return static_cast<std::int64_t>(bytes.value_or(0.0));
  }

  const MeasuredImage& image_;
  const SizeReport& report_;
  Diagnostics& diagnostics_;
};

bool is_board(const Target& target) {
  return target.system.empty() && !target.toolchain.empty();
}

bool is_in(const Placement& placement, std::size_t node, const PlacedPart& part) {
  const std::size_t place = placement.part_of[node];
  return place != Placement::kHub && &placement.parts[place] == &part;
}

/// Of a program for a board: `smooth`, `pendulum/theta`, and what nodes share.
std::vector<std::string> parts_of(const Graph& graph, const PlacedPart* part) {
  std::vector<std::string> parts(kSharedParts.begin(), kSharedParts.end());
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    if (part == nullptr || is_in(*graph.placement, n, *part)) parts.push_back(graph.nodes[n].name);
  }
  return parts;
}

/// "flash, ram and stack"
std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

void tell_what_is_left(const BudgetSpec& budget, const GraphOptions& options,
                       const std::vector<std::string>& of_images, const BuiltProgram* image) {
  if (image == nullptr) {
    std::vector<std::string> keys = of_images;
    if (budget.instructions) keys.emplace_back("instructions");
    complain("note: {} of `budget:` {} not checked, which needs an image for a board\n",
             listed(keys), keys.size() == 1 ? "is" : "are");
  } else if (budget.instructions) {
    complain(
        "note: instructions of `budget:` are counted in a run: `eagerx-gen size {} --graph {}{}`\n",
        image->image, options.graph,
        image->target->run.empty() ? "" : " --run " + image->target->id.value);
  }
}

/// A part of a graph has no slots of its own.
void check_time(Run& run, const BuiltProgram& program) {
  if (program.part == nullptr) return check_built_time(run, program);
  const BudgetSpec& budget = *run.spec->budget;
  run.diagnostics.error("E0422", budget.time ? budget.time->span : budget.slot->span,
                        fmt::format("the time of slots has a budget, but no bound: `{}` is a part "
                                    "of the graph, which waits for others",
                                    program.part->name));
}

}  // namespace

void check_image_budget(const MeasuredImage& image, const BudgetSpec& budget,
                        Diagnostics& diagnostics) {
  BudgetCheck(image, diagnostics).run(budget);
}

void check_built_budget(Run& run, const GraphOptions& options,
                        const std::vector<BuiltProgram>& programs) {
  if (!run.spec->budget) return;
  const BudgetSpec& budget = *run.spec->budget;
  std::vector<std::string> of_images;
  if (budget.flash) of_images.emplace_back("flash");
  if (budget.ram) of_images.emplace_back("ram");
  if (budget.stack) of_images.emplace_back("stack");
  if (budget.nodes) of_images.emplace_back("nodes");
  const std::size_t of_size = of_images.size();
  if (budget.time) of_images.emplace_back("time");
  if (budget.slot) of_images.emplace_back("slot");
  if (of_images.empty() && !budget.instructions) return;
  const auto boards = std::ranges::count_if(
      programs, [](const BuiltProgram& program) { return is_board(*program.target); });
  const BuiltProgram* image = nullptr;
  for (const BuiltProgram& program : programs) {
    if (!is_board(*program.target)) continue;
    image = &program;
    if (limits_time(budget)) check_time(run, program);
    if (of_size == 0) continue;
    const auto report = measure_image(program.image, program.build, run.diagnostics);
    if (!report) continue;
    const std::string what =
        boards == 1 ? "the image" : "the image for `" + program.target->id.value + "`";
    check_image_budget({*report, std::nullopt, what, parts_of(*run.graph, program.part)}, budget,
                       run.diagnostics);
  }
  if (!options.quiet) tell_what_is_left(budget, options, of_images, image);
}

void check_library_budget(Run& run, const GraphOptions& options, MeasuredImage image) {
  if (!run.spec->budget) return;
  image.parts = parts_of(*run.graph, nullptr);
  check_image_budget(image, *run.spec->budget, run.diagnostics);
  if (!options.quiet && run.spec->budget->instructions)
    complain("note: instructions of `budget:` are counted in programs, not in a library\n");
  if (!options.quiet && limits_time(*run.spec->budget))
    complain("note: times of `budget:` are those of programs, not of a library\n");
}

}  // namespace eagerx::gen
