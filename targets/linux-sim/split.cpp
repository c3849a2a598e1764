#include <unistd.h>

#include <charconv>
#include <string>
#include <string_view>
#include <targets/common/partner.hpp>
#include <targets/linux-sim/keys.hpp>
#include <targets/linux-sim/split.hpp>
#include <vector>

namespace eagerx::linux_sim {
namespace {

std::string hex(std::uint64_t value) {
  constexpr unsigned kBase = 16;
  char text[kBase];
  const auto result = std::to_chars(text, text + sizeof text, value, kBase);
  return "0x" + std::string(text, result.ptr);
}

std::string version(std::uint16_t runtime) {
  return std::to_string(runtime >> 8U) + "." + std::to_string(runtime & 0xffU);
}

constexpr std::string_view kLoadAnew =
    "\nhelp: build and load all programs of one run of `eagerx-gen build`";

/// A part without a name.
bool is_board(const link::PartFacts& part) {
  return std::string_view(part.name) == "board";
}

/// "`--link PART=LINE`, where PART is `left` or `right`"
std::string names(const GraphFacts& facts) {
  std::string text = "`--link PART=LINE`, where PART is ";
  for (std::size_t part = 0; part < facts.part_count; ++part)
    text += (part == 0                     ? "`"
             : part + 1 < facts.part_count ? ", `"
                                           : " or `") +
            std::string(facts.parts[part].name) + "`";
  return text;
}

std::string no_line(const GraphFacts& facts, const link::PartFacts& part) {
  const bool is_one = facts.part_count == 1;
  std::string text = is_one ? "error: " + parts_elsewhere(facts)
                            : "error: " + name_of_part(part) + " of this graph runs on " +
                                  std::string(*part.machine != '\0' ? part.machine : part.target);
  return text + "\nhelp: say where that is, `--link" +
         (is_one ? std::string() : " " + std::string(part.name) + "=LINE") +
         "` with a serial line, HOST:PORT or unix:PATH";
}

std::string other_graph(SplitLink& link, const GraphFacts& facts) {
  const std::uint64_t found = link.greeting().graph;
  for (std::size_t part = 0; part < facts.part_count; ++part)
    if (facts.parts[part].graph == found)
      return "error: the line to " + name_of_part(link.part()) + " leads to " +
             name_of_part(facts.parts[part]) +
             "\nhelp: two lines are interchanged: " + names(facts);
  return "error: " + name_of_part(link.part()) +
         " runs another graph, or another version of it: " + hex(found) + ", this program " +
         hex(link.part().graph) + std::string(kLoadAnew);
}

/// "its last message was `smooth/filtered`, and `smooth/filtered` is due"
std::string messages_of(const GraphFacts& facts, const link::PartProgress& progress) {
  const auto name = [&](std::uint32_t channel) {
    return "`" + std::string(facts.channels[channel].name) + "`";
  };
  std::string text = progress.last < facts.channel_count
                         ? "its last message was " + name(progress.last)
                         : std::string("no message of it has come");
  if (progress.awaited < facts.channel_count) text += ", and " + name(progress.awaited) + " is due";
  return text;
}

}  // namespace

std::string why_over(SplitLink& link, const GraphFacts& facts) {
  using link::Problem;
  const link::Greeting& other = link.greeting();
  const link::Statistics& statistics = link.statistics();
  const std::string who = "error: " + name_of_part(link.part());
  const std::string repeated = "after " + std::to_string(statistics.exchanges) + " exchanges, " +
                               std::to_string(statistics.repeated) + " frames sent again and " +
                               std::to_string(statistics.ignored) + " ignored";
  const std::string behind = "\nnote: " + messages_of(facts, link.progress());
  switch (link.problem()) {
    case Problem::none:
      break;
    case Problem::no_answer:
      return who + " does not answer, " + repeated + behind +
             "\nhelp: check that it is connected and runs its part of this graph; `--link-timeout` "
             "sets "
             "how long to wait";
    case Problem::closed:
      return "error: the line to " + name_of_part(link.part()) + " is closed, " + repeated + ": " +
             link.port().error() + behind +
             "\nhelp: check whether it ended; its last messages are where it was started";
    case Problem::other_protocol:
      return who + " speaks version " + std::to_string(other.protocol) +
             " of the link, this program version " + std::to_string(link::kProtocol) +
             std::string(kLoadAnew);
    case Problem::other_runtime:
      return who + " has runtime " + version(other.runtime) + ", this program " +
             version(target::kRuntimeVersion) + std::string(kLoadAnew);
    case Problem::other_graph:
      return other_graph(link, facts);
    case Problem::refused:
      if (other.status == target::kFloatsDiffer)
        return who +
               " flushes denormal numbers to zero, or does not round to nearest\n"
               "help: leave its floating-point unit as it is after a reset, and link without "
               "`-ffast-math`";
      return who +
             "'s answers of the policy differ from the generator's\n"
             "help: build with the flags of the runtime: no fast-math, no contraction";
    case Problem::out_of_step:
      return who + " sends what is not due, " + repeated + behind;
  }
  return {};
}

namespace {

/// `PART=LINE`, or what a graph with one part takes, LINE alone.
std::string find_lines(const std::vector<std::string>& given, const GraphFacts& facts,
                       std::vector<std::string>& lines) {
  lines.assign(facts.part_count, "");
  for (const std::string& text : given) {
    const std::string name = text.substr(0, text.find('='));
    const bool is_named = name.size() < text.size();
    std::size_t part = 0;
    while (part < facts.part_count && (!is_named || name != facts.parts[part].name)) ++part;
    std::string line = part < facts.part_count ? text.substr(name.size() + 1) : text;
    if (part == facts.part_count && facts.part_count == 1) part = 0;
    if (part == facts.part_count)
      return "error: `--link " + text + "` names no part of this graph\nhelp: " + names(facts);
    if (!lines[part].empty())
      return "error: two lines to " + name_of_part(facts.parts[part]) + "\nhelp: give one `--link`";
    lines[part] = std::move(line);
  }
  for (std::size_t part = 0; part < facts.part_count; ++part)
    if (lines[part].empty()) return no_line(facts, facts.parts[part]);
  return {};
}

/// Where the part is, for what is said of one part alone or of each by its name.
std::string at_part(const link::PartFacts& part) {
  return is_board(part) ? std::string("on the board") : "in " + name_of_part(part);
}

void describe_link(Summary& summary, SplitLink& link, const link::Report& report, bool is_one) {
  constexpr double kNanosecondsPerMs = 1e6;
  const link::Statistics& statistics = link.statistics();
  const link::PartFacts& part = link.part();
  const std::string prefix = is_one ? "" : std::string(part.name) + ": ";
  const double steps = summary.steps > 0 ? static_cast<double>(summary.steps) : 1.0;
  const auto per_step = [&](std::uint64_t count) {
    return fixed(static_cast<double>(count) / steps, 2);
  };
  const auto add = [&](const std::string& name, const std::string& value) {
    summary.more.emplace_back(prefix + name, value);
  };
  add(!is_one          ? std::string("target")
      : is_board(part) ? std::string("board")
                       : name_of_part(part),
      part.target);
  add("exchanges a step", per_step(statistics.exchanges));
  add("bytes a step", per_step(statistics.bytes_out) + " to " +
                          (is_one ? name_of_part(part) : std::string("it")) + ", " +
                          per_step(statistics.bytes_in) + " back");
  add("frames sent again", std::to_string(statistics.repeated));
  add("frames ignored", std::to_string(statistics.ignored) + " here, " +
                            std::to_string(report.damaged) + " " +
                            (is_one ? at_part(part) : std::string("there")));
  add("slowest exchange",
      fixed(static_cast<double>(statistics.slowest_ns) / kNanosecondsPerMs, 3) + " ms");
  if (report.stack_bytes > 0)
    add(is_one ? "stack of " + name_of_part(part) : std::string("stack"),
        std::to_string(report.stack_bytes) + " bytes");
}

/// Counters of a part, besides messages.
struct PartFaults final : CountListener {
  PartFaults(Summary& of_run, std::string where) : summary(of_run), behind(std::move(where)) {}
  void count(const char* name, std::uint64_t count) override {
    summary.faults.emplace_back(name + behind, count);
  }
  Summary& summary;
  const std::string behind;
};

/// A number that no earlier session had.
std::uint32_t new_session() {
  // A Weyl step spreads the low bits of two runs that begin in the same millisecond.
  constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15U;
  constexpr unsigned kHigh = 32;
  const std::uint64_t mixed =
      (LinkPort::now_ns() ^ static_cast<std::uint64_t>(getpid()) << kHigh) * kGolden;
  return static_cast<std::uint32_t>(mixed >> kHigh);
}

}  // namespace

std::string connect_part(SplitLink& link, const std::string& line, const std::string& key_file,
                         const GraphFacts& facts, const Options& options, double most_s) {
  const std::string problem =
      key_file.empty() ? std::string() : use_key_of(key_file, line, link.port());
  if (!problem.empty()) return problem;
  if (!link.port().open(line, options.baud))
    return "error: cannot open `" + line + "`: " + link.port().error() +
           (facts.part_count == 1 ? "" : "\nnote: of " + name_of_part(link.part()));
  link.set_pipelined(!options.lockstep);
  return greet_part(link, facts, most_s);
}

std::string greet_part(SplitLink& link, const GraphFacts& facts, double most_s) {
  constexpr double kNanosecondsPerSecond = 1e9;
  link.set_time_limit(static_cast<std::uint64_t>(most_s * kNanosecondsPerSecond));
  return link.open(new_session()) ? std::string() : why_over(link, facts);
}

std::string name_of_part(const link::PartFacts& part) {
  return is_board(part) ? std::string("the board") : "part `" + std::string(part.name) + "`";
}

std::string parts_elsewhere(const GraphFacts& facts) {
  if (facts.part_count > 1) return "parts of this graph are programs of their own";
  const link::PartFacts& part = facts.parts[0];
  if (!is_board(part)) return name_of_part(part) + " of this graph is a program of its own";
  return "a part of this graph runs on " + std::string(part.target);
}

bool part_knows(const GraphFacts& facts, target::Agent agent) {
  if (!facts.part_decides) return true;
  if (agent == target::Agent::random) return facts.part_knows_random;
  return agent < target::Agent::csv;
}

std::string find_parts(const GraphFacts& facts, const Options& options, PartLines& found) {
  const std::string problem = find_lines(options.links, facts, found.lines);
  return problem.empty() ? find_keys(options.keys, facts, found.lines, found.keys) : problem;
}

std::string connect_parts(GraphProgram& program, const Options& options) {
  const GraphFacts& facts = program.facts();
  PartLines found;
  std::string problem = find_parts(facts, options, found);
  for (std::size_t part = 0; problem.empty() && part < facts.part_count; ++part)
    problem = connect_part(*program.link(part), found.lines[part], found.keys[part], facts, options,
                           options.link_timeout_s);
  return problem;
}

bool links_are_whole(GraphProgram& program) {
  for (std::size_t part = 0; SplitLink* const link = program.link(part); ++part)
    if (!link->ok()) return false;
  return true;
}

std::string end_links(GraphProgram& program, Summary& summary) {
  const GraphFacts& facts = program.facts();
  std::string broken;
  for (std::size_t part = 0; SplitLink* const link = program.link(part); ++part) {
    const std::string name = facts.parts[part].name;
    const bool is_one = facts.part_count == 1;
    link::Report report;
    PartFaults faults(summary, " " + (is_one ? at_part(facts.parts[part]) : "in `" + name + "`"));
    link->forget_silence();  // the engine has stopped, and its hardware is given back
    // If one is gone, the hub does not wait for the counts of the others.
    if (link->ok() && links_are_whole(program)) link->finish(report, faults);
    if (broken.empty() && !link->ok()) broken = why_over(*link, facts);
    describe_link(summary, *link, report, is_one);
  }
  return broken;
}

}  // namespace eagerx::linux_sim
