#include <array>
#include <charconv>
#include <runtime/host/base/hash.hpp>
#include <string_view>
#include <targets/linux-sim/summary.hpp>

namespace eagerx::linux_sim {
namespace {

constexpr double kMsPerSecond = 1e3;

void add(std::string& text, std::string_view name, std::string_view value) {
  text.append(name).append(" ").append(value).append("\n");
}

}  // namespace

std::string fixed(double value, int digits) {
  constexpr std::size_t kLongestFixedDouble = 350;
  std::array<char, kLongestFixedDouble> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value,
                                    std::chars_format::fixed, digits);
  return {text.data(), result.ptr};
}

std::string summary_text(const Summary& summary) {
  const double elapsed_s = summary.elapsed_s > 0.0 ? summary.elapsed_s : 1e-9;
  std::string text;
  add(text, "graph", summary.graph);
  add(text, "engine", summary.engine);
  add(text, "agent", summary.agent);
  add(text, "seed", std::to_string(summary.seed));
  add(text, "episodes", std::to_string(summary.episodes));
  add(text, "steps", std::to_string(summary.steps));
  add(text, "simulated", fixed(summary.simulated_s, 3) + " s");
  add(text, "elapsed", fixed(summary.elapsed_s, 3) + " s");
  add(text, "steps/s", fixed(static_cast<double>(summary.steps) / elapsed_s, 0));
  add(text, "time factor", fixed(summary.simulated_s / elapsed_s, 2));
  if (summary.paced) {
    std::string overruns = std::to_string(summary.overruns);
    if (summary.overruns > 0) {
      overruns += ", at most " + fixed(summary.worst_overrun_s * kMsPerSecond, 3) + " ms late";
    }
    add(text, "overruns", overruns);
  }
  for (const auto& [name, count] : summary.faults) {
    if (count > 0) add(text, name, std::to_string(count));
  }
  for (const auto& [name, value] : summary.states) add(text, "state " + name, value);
  for (const auto& [name, value] : summary.more) add(text, name, value);
  if (summary.interrupted) text += "interrupted\n";
  return text;
}

std::string not_finite_problem(const std::string& first, std::uint64_t seed,
                               std::uint32_t environment) {
  const std::string one = environment == 0 ? "" : " --environment " + std::to_string(environment);
  return "error: " + first + ", with `--seed " + std::to_string(seed) + one +
         "`\nhelp: a training cannot use such a reward. Check what its expression reads in "
         "the "
         "table of `--csv FILE`: log() and sqrt() have no value below 0, a quotient none at 0, and "
         "`max(x, 1e-6)` keeps x away from them; a simulation that breaks down needs `terminated:` "
         "before it does";
}

std::string hash_line(std::uint64_t hash) {
  return "trace hash " + host::hex_text(hash) + "\n";
}

}  // namespace eagerx::linux_sim
