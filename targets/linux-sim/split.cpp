#include <unistd.h>

#include <charconv>
#include <string_view>
#include <targets/common/partner.hpp>
#include <targets/linux-sim/split.hpp>

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
    "\nhelp: build and load both programs of one run of `eagerx-gen --split`";

}  // namespace

bool board_knows(const GraphFacts& facts, target::Agent agent) {
  if (!facts.board_decides) return true;
  if (agent == target::Agent::random) return facts.board_knows_random;
  return agent < target::Agent::csv;
}

std::string problem_of(SplitLink& link) {
  using link::Problem;
  const link::Greeting& board = link.board();
  const link::Statistics& statistics = link.statistics();
  const std::string repeated = "after " + std::to_string(statistics.exchanges) + " exchanges, " +
                               std::to_string(statistics.repeated) + " frames sent again and " +
                               std::to_string(statistics.ignored) + " ignored";
  switch (link.problem()) {
    case Problem::none:
      break;
    case Problem::no_answer:
      return "error: the board does not answer, " + repeated +
             "\nhelp: is it connected and running its part of this graph? `--link-timeout` sets "
             "how "
             "long to wait";
    case Problem::closed:
      return "error: the line to the board is closed, " + repeated + ": " + link.port().error();
    case Problem::other_protocol:
      return "error: the board speaks version " + std::to_string(board.protocol) +
             " of the link, this program version " + std::to_string(link::kProtocol) +
             std::string(kLoadAnew);
    case Problem::other_runtime:
      return "error: the board has runtime " + version(board.runtime) + ", this program " +
             version(link.identity().runtime) + std::string(kLoadAnew);
    case Problem::other_graph:
      return "error: the board runs another graph, or another version of it: " + hex(board.graph) +
             ", this program " + hex(link.identity().graph) + std::string(kLoadAnew);
    case Problem::refused:
      if (board.status == target::kFloatsDiffer)
        return "error: the board takes denormal numbers for zero, or rounds otherwise\n"
               "help: leave its floating-point unit as it is after a reset, and link without "
               "`-ffast-math`";
      return "error: the board's answers of the policy differ from the generator's\n"
             "help: build with the flags of the runtime: no fast-math, no contraction";
    case Problem::out_of_step:
      return "error: the board sends what is not due, " + repeated;
  }
  return {};
}

void describe_link(Summary& summary, const char* board, const link::Statistics& statistics,
                   const link::Report& report) {
  constexpr double kNsPerMs = 1e6;
  const double steps = summary.steps > 0 ? static_cast<double>(summary.steps) : 1.0;
  const auto per_step = [&](std::uint64_t count) {
    return fixed(static_cast<double>(count) / steps, 2);
  };
  const auto add = [&](const char* name, const std::string& value) {
    summary.more.emplace_back(name, value);
  };
  add("board", board);
  add("exchanges a step", per_step(statistics.exchanges));
  add("bytes a step",
      per_step(statistics.bytes_out) + " to the board, " + per_step(statistics.bytes_in) + " back");
  add("frames sent again", std::to_string(statistics.repeated));
  add("frames ignored", std::to_string(statistics.ignored) + " here, " +
                            std::to_string(report.damaged) + " on the board");
  add("slowest exchange", fixed(static_cast<double>(statistics.slowest_ns) / kNsPerMs, 3) + " ms");
  if (report.stack_bytes > 0)
    add("stack of the board", std::to_string(report.stack_bytes) + " bytes");
}

namespace {

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

std::string connect(SplitLink& link, const Options& options) {
  constexpr double kNsPerSecond = 1e9;
  if (!link.port().open(options.link, options.baud))
    return "error: cannot open `" + options.link + "`: " + link.port().error();
  link.set_time_limit(static_cast<std::uint64_t>(options.link_timeout_s * kNsPerSecond));
  return link.open(new_session()) ? std::string() : problem_of(link);
}

}  // namespace eagerx::linux_sim
