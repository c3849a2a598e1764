#include "generator/analysis/bound/bound.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <set>

#include "generator/analysis/bound/cycles.hpp"
#include "generator/analysis/bound/missing.hpp"
#include "generator/analysis/bound/regions.hpp"
#include "generator/analysis/bound/slot_code.hpp"
#include "generator/analysis/size/function_name.hpp"
#include "generator/analysis/size/program_file.hpp"
#include "generator/analysis/size/tools.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

using bound::Obstacle;
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
      {"outcome", {"Program::outcome"}},
      {"telemetry", {"TelemetryWork::until"}}};
  return kParts;
}

/// Functions for angles that few programs ever meet (runtime/eagerx/math/payne_hanek.hpp), and the
/// condition that spares them: kLargest of float.
constexpr std::array<std::string_view, 2> kOfHugeAngles = {"reduce_huge_float",
                                                           "reduce_huge_angle"};
constexpr std::string_view kWithoutHugeAngles = "angles up to 12800 rad";
constexpr std::string_view kWithoutDenormals = "no denormal numbers";

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

class Report {
 public:
  Report(const bound::Image& image, const std::vector<std::string>& rates, const Machine* machine)
      : image_(image),
        rates_(rates),
        places_(image),
        analysis_(image),
        regions_(analysis_, places_) {
    take_model(machine);
  }

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
    find_nodes(*map);
    add_parts();
    add_slots();
    report_.nodes = nodes_in({step_});
    add_interrupts(machine_);
    add_missing();
    add_functions();
    return std::move(report_);
  }

 private:
  /// Once: there are many more instructions than functions.
  void name_functions() {
    for (const std::string& mangled : places_.functions()) names_.push_back(function_name(mangled));
  }

  void take_model(const Machine* machine) {
    machine_ = machine;
    if (machine == nullptr) {
      report_.why_no_time = "the board of this image is not known";
      return;
    }
    const auto core = bound::core_of(machine->cpu);
    if (!core || machine->clock_hz == 0) {
      report_.why_no_time = core ? fmt::format("the clock of `{}` is not known", machine->board)
                                 : fmt::format("no cycles are known of a core `{}`", machine->cpu);
      return;
    }
    cycles_.emplace(image_, *core, machine->wait_states.value_or(0));
    timed_.emplace(analysis_, places_, *cycles_);
    report_.time = {machine->board, machine->cpu, machine->clock_hz, machine->wait_states, {}};
  }

  /// `most` of the regions, in instructions and in cycles.
  struct Both {
    bound::Regions::Most instructions, cycles;
    void add(const Both& other) {
      instructions.most += other.instructions.most;
      instructions.obstacles.insert(other.instructions.obstacles.begin(),
                                    other.instructions.obstacles.end());
      cycles.most += other.cycles.most;
    }
  };
  template <class Find>
  Both both(Find&& find) {
    Both result{find(regions_), {}};
    if (timed_) result.cycles = find(*timed_);
    return result;
  }

  std::vector<Region> find(const bound::IsNamed& is_named) {
    std::vector<Region> regions = regions_.find(is_named);
    for (const Region& region : regions) roots_.insert(region.function);
    return regions;
  }
  std::vector<Region> named(const std::string& name) {
    return find([&](std::uint32_t function) { return names_[function] == name; });
  }

  InstructionBound row(const std::string& name, const Both& most) {
    for (const Obstacle& obstacle : most.instructions.obstacles) obstacles_[obstacle].insert(name);
    return {name, most.instructions.most, most.cycles.most, most.instructions.obstacles.empty()};
  }

  void add_parts() {
    for (const Part& part : parts_of_programs()) {
      for (const char* function : part.functions) {
        const auto regions = named(function);
        if (regions.empty()) continue;
        report_.parts.push_back(
            row(part.name, both([&](bound::Regions& in) { return in.most(regions); })));
        add_without_huge_angles(part.name, regions);
        if (part.name == std::string_view("step")) step_ = regions;
        break;
      }
    }
  }

  /// The same part without huge angles, where it reduces some: a bound under a condition.
  void add_without_huge_angles(const std::string& name, const std::vector<Region>& regions) {
    std::set<bound::Address> functions;
    for (const auto& [at, mangled] : image_.functions()) {
      if (std::ranges::find(kOfHugeAngles, function_name(mangled)) != kOfHugeAngles.end())
        functions.insert(at);
    }
    const auto most =
        both([&](bound::Regions& in) { return in.most_without_calls(regions, functions); });
    std::string condition;
    if (most.instructions.most != report_.parts.back().most) {
      condition = kWithoutHugeAngles;
      report_.parts.push_back(row(fmt::format("{}, {}", name, condition), most));
    }
    add_without_denormals(name, condition, regions, functions);
  }

  /// Where software computes with numbers, also without those that it must shift bit by bit.
  void add_without_denormals(const std::string& name, const std::string& condition,
                             const std::vector<Region>& regions,
                             const std::set<bound::Address>& functions) {
    std::set<bound::Address> loops;
    for (const auto& [header, loop] : analysis_.library()) {
      if (loop.is_of_denormal) loops.insert(header);
    }
    const auto most =
        both([&](bound::Regions& in) { return in.most_without_calls(regions, functions, loops); });
    if (most.instructions.most == report_.parts.back().most) return;
    report_.parts.push_back(row(fmt::format("{}, {}{}{}", name, condition,
                                            condition.empty() ? "" : ", ", kWithoutDenormals),
                                most));
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
    std::map<std::optional<std::uint64_t>, std::set<std::uint32_t>> functions;
    for (std::uint32_t i = 0; i < names_.size(); ++i) {
      if (std::ranges::find(kHalves, names_[i]) != kHalves.end())
        functions[due_in(places_.functions()[i])].insert(i);
    }
    std::vector<bound::SlotCode> code;
    for (const auto& [due, of_slot] : functions) {
      for (const std::string_view half : kHalves)
        code.push_back(
            {due, half == kHalves.back(), find([&, &of_slot = of_slot](std::uint32_t function) {
               return names_[function] == half && of_slot.contains(function);
             })});
    }
    const std::set<bound::Address> of_all = bound::share(analysis_, code);
    std::vector<Region> all;
    for (std::size_t i = 0; i < code.size(); i += kHalves.size()) {
      Both sum;
      std::vector<SlotBound::Half> halves;
      for (std::size_t half = i; half < i + kHalves.size(); ++half) {
        const auto& regions = code[half].regions;
        const Both most = both([&](bound::Regions& in) { return in.most(regions); });
        sum.add(most);
        halves.push_back({most.instructions.most, most.cycles.most});
        all.insert(all.end(), regions.begin(), regions.end());
      }
      const auto due = code[i].due;
      report_.slots.push_back({row(slot_name(due), sum), due, halves.front(), halves.back(),
                               nodes_in({code[i].regions, code[i + 1].regions})});
    }
    if (!step_.empty() && !all.empty())
      report_.parts.push_back(row("schedule", both([&](bound::Regions& in) {
                                    return in.most_without(step_, all, of_all);
                                  })));
  }

  /// Which instructions each node of the graph has.
  void find_nodes(const ProgramMap& map) {
    std::map<std::string_view, std::uint32_t> numbers;
    for (const auto& [node, type] : map.type_of_node) {
      numbers.emplace(node, static_cast<std::uint32_t>(nodes_.size()));
      nodes_.push_back(node);
    }
    const auto no_node = static_cast<std::uint32_t>(nodes_.size());
    for (const std::string* node : places_.nodes(map)) {
      const auto found = node == nullptr ? numbers.end() : numbers.find(*node);
      owners_.push_back(found == numbers.end() ? no_node : found->second);
    }
    regions_.set_owners(owners_);
    if (timed_) timed_->set_owners(owners_);
  }

  /// The nodes of parts of the program that run one after the other.
  std::vector<InstructionBound> nodes_in(const std::vector<std::vector<Region>>& parts) {
    std::vector<InstructionBound> rows;
    for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
      Both sum;
      for (const auto& regions : parts)
        sum.add(both([&](bound::Regions& in) { return in.most_of(regions, node); }));
      if (sum.instructions.most > 0) rows.push_back(row(nodes_[node], sum));
    }
    return rows;
  }

  /// Copies of one loop, which the compiler made, and all loops of one library function are one.
  void add_missing() {
    for (const auto& [obstacle, of] : obstacles_) {
      const NoBound missing = bound::no_bound(obstacle, roots_, analysis_, places_, names_);
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
    bound::Wholes wholes;
    for (const auto& [at, name] : image_.functions()) {
      bound::LongestPath path(bound::Weight::all(), wholes);
      const std::uint64_t most = path.of(analysis_.of(at));
      if (path.obstacles().empty() && most > 0)
        report_.functions.push_back({function_name(name), at, most});
    }
  }

  /// Handlers that the board's manifest gives a rate. One without a bound is an error like that of
  /// a part.
  void add_interrupts(const Machine* machine) {
    if (!report_.time) return;
    bound::Wholes wholes;
    for (const Machine::Interrupt& interrupt : machine->interrupts) {
      const auto found = image_.addresses().find(interrupt.handler);
      if (found == image_.addresses().end()) continue;
      bound::LongestPath path(bound::Weight::all(*cycles_), wholes);
      const bound::Analysed& handler = analysis_.of(found->second);
      roots_.insert(found->second);
      const std::uint64_t most = path.of(handler);
      for (const Obstacle& obstacle : path.obstacles())
        obstacles_[obstacle].insert(interrupt.handler);
      report_.time->interrupts.push_back(
          {interrupt.handler, cycles_->exception(most, uses_floats(handler)), interrupt.most_hz});
    }
  }

  static bool uses_floats(const bound::Analysed& function) {
    const auto is_float = [](const bound::Instruction* i) { return i->name.starts_with("v"); };
    for (const bound::Block& block : function.flow->blocks) {
      if (std::ranges::any_of(block.code, is_float)) return true;
    }
    return std::ranges::any_of(function.calls,
                               [](const auto& call) { return uses_floats(*call.second); });
  }

  const bound::Image& image_;
  const std::vector<std::string>& rates_;
  const Machine* machine_ = nullptr;
  bound::Places places_;
  bound::Analysis analysis_;
  bound::Regions regions_;
  std::optional<bound::Cycles> cycles_;
  std::optional<bound::Regions> timed_;  // by cycles
  std::vector<std::string> names_;       // of places_.functions(), as users write them
  std::vector<std::string> nodes_;       // of the graph
  std::vector<std::uint32_t> owners_;  // [instructions] the number of a node; of none, their count
  std::vector<Region> step_;
  std::set<bound::Address> roots_;  // functions with what is bounded
  std::map<Obstacle, std::set<std::string>> obstacles_;
  BoundReport report_;
};

}  // namespace

bool has_cycles(const Machine& machine) {
  return bound::core_of(machine.cpu) && machine.clock_hz > 0;
}

std::optional<BoundReport> bound_instructions(const std::string& image,
                                              const std::vector<std::string>& rates,
                                              const Machine* machine, Diagnostics& diagnostics) {
  const auto prefix = tool_prefix(image);
  if (!prefix || *prefix != "arm-none-eabi-") {
    diagnostics
        .io_error(
            "E0911", {},
            fmt::format("instructions of `{}` have no bound: it is not an image for a Cortex-M",
                        image))
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
  auto report = Report(*read, rates, machine).make(image, diagnostics);
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

}  // namespace eagerx::gen
