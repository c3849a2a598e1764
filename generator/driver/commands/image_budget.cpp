#include "generator/driver/commands/image_budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "generator/backend/program_map/program_map.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/command_line/output.hpp"

namespace eagerx::gen {
namespace {

class BudgetCheck {
 public:
  BudgetCheck(const JudgedImage& image, Diagnostics& diagnostics)
      : image_(image), report_(image.report), diagnostics_(diagnostics) {}

  void run(const YamlValue& budget) {
    check(budget, "flash", "bytes of flash", report_.flash);
    check(budget, "ram", "bytes of RAM", report_.ram);
    check(budget, "stack", "bytes of stack", report_.stack.bytes);
    if (report_.instructions)
      check(budget, "instructions", "instructions in a slot", report_.instructions->most);
    else if (const YamlValue* entry = budget.find("instructions");
             entry != nullptr && !image_.parts)
      diagnostics_.error("E0422", entry->span, "instructions have a budget, but were not counted")
          .help = "give `--run TARGET`";
    const YamlValue* nodes = budget.find("nodes");
    if (nodes == nullptr) return;
    for (const auto& entry : nodes->entries) {
      if (!image_.parts || contains(*image_.parts, entry.key)) check_node(entry);
    }
  }

 private:
  void check_node(const YamlValue::Entry& entry) {
    const Usage* usage = find(entry.key);
    if (usage == nullptr && image_.parts) return;  // nothing is left of it
    if (usage == nullptr) {
      diagnostics_.error("E0421", entry.key_span,
                         fmt::format("{} has no node `{}`", image_.what, entry.key));
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
                           fmt::format("{} takes {} {}, {} over its budget of {}", image_.what,
                                       used, unit, used - limit(*entry), limit(*entry)));
    problem.help = who(key);
    if (std::string_view(key) != "stack") return;
    std::string calls = "the deepest chain of calls, and the bytes of each:\n";
    calls += stack_text(report_.stack);
    calls.pop_back();
    problem.notes.push_back({std::move(calls), {}, ""});
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

  const JudgedImage& image_;
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

void tell_what_is_left(const YamlValue& budget, const GraphOptions& options,
                       const std::vector<std::string>& of_images, const BuiltProgram* image) {
  if (image == nullptr) {
    std::vector<std::string> keys = of_images;
    if (budget.find("instructions") != nullptr) keys.emplace_back("instructions");
    complain("note: {} of `budget:` {} not checked, which needs an image for a board\n",
             listed(keys), keys.size() == 1 ? "is" : "are");
  } else if (budget.find("instructions") != nullptr) {
    complain(
        "note: instructions of `budget:` are counted in a run: `eagerx-gen size {} --graph {}{}`\n",
        image->image, options.graph,
        image->target->run.empty() ? "" : " --run " + image->target->id.value);
  }
}

}  // namespace

void check_image_budget(const JudgedImage& image, const YamlValue& budget,
                        Diagnostics& diagnostics) {
  BudgetCheck(image, diagnostics).run(budget);
}

void check_built_budget(Run& run, const GraphOptions& options,
                        const std::vector<BuiltProgram>& programs) {
  if (!run.spec->budget) return;
  const YamlValue& budget = *run.spec->budget;
  std::vector<std::string> of_images;
  for (const char* key : {"flash", "ram", "stack", "nodes"}) {
    if (budget.find(key) != nullptr) of_images.emplace_back(key);
  }
  if (of_images.empty() && budget.find("instructions") == nullptr) return;
  const auto boards = std::ranges::count_if(
      programs, [](const BuiltProgram& program) { return is_board(*program.target); });
  const BuiltProgram* image = nullptr;
  for (const BuiltProgram& program : programs) {
    if (!is_board(*program.target)) continue;
    image = &program;
    if (of_images.empty()) continue;
    const auto report = measure_image(program.image, program.build, run.diagnostics);
    if (!report) continue;
    const std::string what =
        boards == 1 ? "the image" : "the image for `" + program.target->id.value + "`";
    check_image_budget({*report, std::nullopt, what, parts_of(*run.graph, program.part)}, budget,
                       run.diagnostics);
  }
  if (!options.quiet) tell_what_is_left(budget, options, of_images, image);
}

void check_library_budget(Run& run, const GraphOptions& options, JudgedImage image) {
  if (!run.spec->budget) return;
  image.parts = parts_of(*run.graph, nullptr);
  check_image_budget(image, *run.spec->budget, run.diagnostics);
  if (!options.quiet && run.spec->budget->find("instructions") != nullptr)
    complain("note: instructions of `budget:` are counted in programs, not in a library\n");
}

}  // namespace eagerx::gen
