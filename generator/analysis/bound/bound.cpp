#include "generator/analysis/bound/bound.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <map>
#include <set>

#include "generator/analysis/bound/regions.hpp"
#include "generator/analysis/size/function_name.hpp"
#include "generator/analysis/size/program_file.hpp"
#include "generator/analysis/size/tools.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

using bound::Obstacle;
using bound::Reason;
using bound::Region;

/// "step": the first of these functions that an image has.
struct Part {
  const char* name;
  std::vector<const char*> functions;
};

const std::vector<Part>& parts_of_programs() {
  static const std::vector<Part> kParts = {
      {"step", {"Program::step_unguarded", "Program::step_checked", "Program::step"}},
      {"reset", {"Program::reset"}},
      {"guard", {"Guard::check"}},
      {"policy", {"Graph::policy"}},
      {"outcome", {"Program::outcome"}}};
  return kParts;
}

/// What the program of a graph runs in a slot (templates/cpp/slots.mustache).
constexpr std::array<std::string_view, 2> kHalves = {"Program::run_before_action",
                                                     "Program::run_after_action"};

/// The rates that are due in `Program::run_before_action<std::integral_constant<unsigned, 5>>`, as
/// bits; nullopt: its schedule decides at run time.
std::optional<std::uint64_t> due_in(const std::string& mangled) {
  constexpr std::string_view kConstant = "ISt17integral_constantI";
  const auto begin = mangled.find(kConstant);
  if (begin == std::string::npos) return std::nullopt;
  const auto number = mangled.find('L', begin + kConstant.size());
  if (number == std::string::npos || number + 2 >= mangled.size()) return std::nullopt;
  std::uint64_t bits = 0;
  const char* const end = mangled.data() + mangled.size();
  const auto result = std::from_chars(mangled.data() + number + 2, end, bits);
  return result.ec == std::errc() ? std::optional(bits) : std::nullopt;
}

struct Words {
  const char *what, *help;
};

Words words_of(Reason reason) {
  switch (reason) {
    case Reason::loop:
      return {"the loop",
              "let its turns have a limit that the compiler knows: count to a constant, or take "
              "`eagerx::bounded<N>(count)` of <eagerx/bounded.hpp>, which stops after N"};
    case Reason::several_entries:
      return {"the loop with several entries", "write it without `goto`, as one `for` or `while`"};
    case Reason::recursion:
      return {"the recursive call", "write it as a loop with a limit"};
    case Reason::pointer_call:
      return {"the call through a pointer",
              "call the function itself, or a template parameter: a pointer or a virtual function "
              "may lead anywhere"};
    case Reason::lost:
      break;
  }
  return {"the jump", "it leads to where this image has no code that can be followed"};
}

class Report {
 public:
  Report(const bound::Image& image, const std::vector<std::string>& rates)
      : image_(image),
        rates_(rates),
        places_(image),
        analysis_(image),
        regions_(analysis_, places_) {}

  /// nullopt: the image has no program with a map.
  std::optional<BoundReport> make(const std::string& path, Diagnostics& diagnostics) {
    name_functions();
    const std::string program = places_.program();
    if (program.empty()) {
      diagnostics.io_error("E0911", {}, fmt::format("`{}` has no program of a graph", path)).help =
          "give an image that was built with -g from what `eagerx-gen generate` wrote";
      return std::nullopt;
    }
    const auto map = map_of_program(program, path, diagnostics);
    if (!map) return std::nullopt;
    add_parts();
    add_slots();
    add_nodes(*map);
    add_missing();
    add_functions();
    return std::move(report_);
  }

 private:
  /// Once: there are as many functions as names, and many more instructions.
  void name_functions() {
    for (const auto& [at, instruction] : image_.instructions()) {
      for (const auto& frame : places_.of(at)) {
        if (!names_.contains(frame.function))
          names_[frame.function] = function_name(frame.function);
      }
    }
  }

  std::vector<Region> named(const std::string& name) {
    return regions_.find([&](const std::string& mangled) { return names_.at(mangled) == name; });
  }

  InstructionBound row(const std::string& name, const bound::Regions::Most& most) {
    for (const Obstacle& obstacle : most.obstacles) obstacles_[obstacle].insert(name);
    return {name, most.instructions, most.obstacles.empty()};
  }

  void add_parts() {
    for (const Part& part : parts_of_programs()) {
      for (const char* function : part.functions) {
        const auto regions = named(function);
        if (regions.empty()) continue;
        report_.parts.push_back(row(part.name, regions_.most(regions)));
        if (part.name == std::string_view("step")) step_ = regions;
        break;
      }
    }
  }

  std::string slot_name(std::optional<std::uint64_t> due) const {
    if (!due) return "any slot";
    std::string name;
    for (std::size_t bit = 0; bit < 64; ++bit) {
      if ((*due >> bit & 1U) == 0) continue;
      name += name.empty() ? "" : ", ";
      name += bit < rates_.size() ? rates_[bit] : fmt::format("rate {}", bit);
    }
    return name;
  }

  /// A slot is what is before the environment's action and what is after it; the schedule of the
  /// step comes on top, once.
  void add_slots() {
    std::map<std::optional<std::uint64_t>, std::vector<std::string>> functions;
    for (const auto& [mangled, name] : names_) {
      if (std::ranges::find(kHalves, name) != kHalves.end())
        functions[due_in(mangled)].push_back(mangled);
    }
    std::vector<Region> all;
    for (const auto& [due, of_slot] : functions) {
      bound::Regions::Most sum;
      for (const std::string_view half : kHalves) {
        const auto regions = regions_.find([&, &of_slot = of_slot](const std::string& mangled) {
          return names_.at(mangled) == half && std::ranges::find(of_slot, mangled) != of_slot.end();
        });
        const auto most = regions_.most(regions);
        sum.instructions += most.instructions;
        sum.obstacles.insert(most.obstacles.begin(), most.obstacles.end());
        all.insert(all.end(), regions.begin(), regions.end());
      }
      report_.slots.push_back(row(slot_name(due), sum));
    }
    if (!step_.empty() && !all.empty())
      report_.parts.push_back(row("schedule", regions_.most_without(step_, all)));
  }

  void add_nodes(const ProgramMap& map) {
    for (const auto& [node, type] : map.type_of_node) {
      const auto most = regions_.most(step_, [&, &node = node](bound::Address at) {
        const std::string* owner = places_.node(at, map);
        return owner != nullptr && *owner == node;
      });
      if (most.instructions > 0) report_.nodes.push_back(row(node, most));
    }
  }

  /// Copies of one loop, which the compiler made, are one.
  void add_missing() {
    for (const auto& [obstacle, of] : obstacles_) {
      const Words words = words_of(obstacle.reason);
      NoBound missing{
          words.what, "", function_name(image_.function_of(obstacle.at)), words.help, {}};
      const auto& frames = places_.of(obstacle.at);
      if (!frames.empty() && frames.front().line > 0) {
        const std::string file =
            std::filesystem::path(frames.front().file).lexically_normal().string();
        missing.place = fmt::format("{}:{}", file, frames.front().line);
        missing.function = names_.at(frames.front().function);
      }
      const auto same = std::ranges::find_if(report_.missing, [&](const NoBound& other) {
        return other.what == missing.what && other.place == missing.place &&
               other.function == missing.function;
      });
      NoBound& one = same == report_.missing.end() ? report_.missing.emplace_back(missing) : *same;
      for (const std::string& name : of) {
        if (std::ranges::find(one.of, name) == one.of.end()) one.of.push_back(name);
      }
    }
  }

  void add_functions() {
    for (const auto& [at, name] : image_.functions()) {
      bound::LongestPath path(bound::Weight::all());
      const std::uint64_t most = path.of(analysis_.of(at));
      if (path.obstacles().empty() && most > 0)
        report_.functions.push_back({function_name(name), at, most});
    }
  }

  const bound::Image& image_;
  const std::vector<std::string>& rates_;
  bound::Places places_;
  bound::Analysis analysis_;
  bound::Regions regions_;
  std::map<std::string, std::string> names_;
  std::vector<Region> step_;
  std::map<Obstacle, std::set<std::string>> obstacles_;
  BoundReport report_;
};

void add_rows(std::string& text, const char* title, const std::vector<InstructionBound>& rows) {
  if (rows.empty()) return;
  text += fmt::format("{}\n", title);
  for (const InstructionBound& row : rows)
    text += fmt::format("  {:<28} {:>10}{}\n", row.name, row.most, row.is_bound ? "" : " and more");
}

Json rows_json(const std::vector<InstructionBound>& rows) {
  Json json = Json::list();
  for (const InstructionBound& row : rows)
    json.push_back(Json{{"name", row.name}, {"most", row.most}, {"bound", row.is_bound}});
  return json;
}

}  // namespace

std::optional<BoundReport> bound_instructions(const std::string& image,
                                              const std::vector<std::string>& rates,
                                              Diagnostics& diagnostics) {
  const auto prefix = tool_prefix(image);
  if (!prefix || *prefix != "arm-none-eabi-") {
    diagnostics
        .io_error(
            "E0911", {},
            fmt::format("instructions of `{}` have no bound: it is no image for a Cortex-M", image))
        .help = "other machines are not analysed; count in an emulator with `--run TARGET`";
    return std::nullopt;
  }
  const auto read = bound::Image::read(image, *prefix);
  if (!read) {
    diagnostics
        .io_error("E0911", {}, fmt::format("cannot read `{}` with `{}objdump`", image, *prefix))
        .help = "install the board's compiler: toolchains/install-packages boards";
    return std::nullopt;
  }
  auto report = Report(*read, rates).make(image, diagnostics);
  if (!report) return std::nullopt;
  for (const NoBound& missing : report->missing) {
    std::vector<std::string> of;
    for (const std::string& name : missing.of) of.push_back("`" + name + "`");
    diagnostics
        .error("E0427", {},
               fmt::format("{} at {} in `{}` has no bound: none for {}", missing.what,
                           missing.place.empty() ? "an unknown place" : missing.place,
                           missing.function, join(of, ", ")))
        .help = missing.help;
  }
  return report;
}

std::string bound_text(const BoundReport& report) {
  std::string text = "instructions at most, from the image alone\n";
  add_rows(text, "parts of a step", report.parts);
  add_rows(text, "slots, without the schedule", report.slots);
  add_rows(text, "nodes, in a step", report.nodes);
  return text;
}

Json bound_json(const BoundReport& report) {
  Json json;
  json["parts"] = rows_json(report.parts);
  json["slots"] = rows_json(report.slots);
  json["nodes"] = rows_json(report.nodes);
  Json functions = Json::list();
  for (const FunctionBound& one : report.functions)
    functions.push_back(Json{{"name", one.name}, {"address", one.address}, {"most", one.most}});
  json["functions"] = std::move(functions);
  Json missing = Json::list();
  for (const NoBound& one : report.missing)
    missing.push_back(
        Json{{"what", one.what}, {"place", one.place}, {"function", one.function}, {"of", one.of}});
  json["missing"] = std::move(missing);
  return json;
}

}  // namespace eagerx::gen
