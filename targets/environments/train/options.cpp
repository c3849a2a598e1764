#include "targets/environments/train/options.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>
#include <string_view>

#include "targets/environments/train/client.hpp"

namespace eagerx::train {
namespace {

using Set = std::function<void(Options&, const std::string&)>;

[[noreturn]] void refuse(const std::string& what) {
  throw Problem(kUsage, what, "`eagerx-gen train --help` lists the options");
}

template <class T>
T number(std::string_view text, T low, T high) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() ||
      !(value >= low && value <= high)) {
    refuse("`" + std::string(text) + "` is not a number in its range");
  }
  return value;
}

std::vector<std::size_t> widths(const std::string& text) {
  constexpr std::size_t kWidest = 1024, kMostLayers = 8;
  std::vector<std::size_t> result;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    result.push_back(
        number<std::size_t>(std::string_view(text).substr(at, comma - at), 1, kWidest));
    at = comma + 1;
  }
  if (result.size() > kMostLayers) refuse("--hidden takes at most 8 layers");
  return result;
}

struct Option {
  const char* name;
  const char* value;
  const char* about;
  Set set;
};

const auto& table() {
  constexpr std::uint64_t kMostSteps = 1'000'000'000'000;
  constexpr std::uint64_t kMostSeed = (std::uint64_t{1} << 62U) - 1;  // above: evaluation
  constexpr double kMostReturn = 1e30;
  static const std::array kTable = {
      Option{"-o", "FILE", "the policy (default: policy.safetensors)",
             [](Options& o, const std::string& v) { o.output = v; }},
      Option{"--algorithm", "NAME", "ppo (default); there is no other",
             [](Options&, const std::string& v) {
               if (v != "ppo") refuse("there is no algorithm `" + v + "`, only ppo");
             }},
      Option{"--steps", "N", "steps of all environments, at most (default: 5000000)",
             [](Options& o, const std::string& v) {
               o.steps = number<std::uint64_t>(v, 1, kMostSteps);
             }},
      Option{"--until-return", "X", "do not end before the mean return of 100 episodes is X",
             [](Options& o, const std::string& v) {
               o.settings.until_return = number<double>(v, -kMostReturn, kMostReturn);
             }},
      Option{"--seed", "N", "another one is another training (default: 1)",
             [](Options& o, const std::string& v) {
               o.settings.seed = number<std::uint64_t>(v, 0, kMostSeed);
             }},
      Option{"--threads", "N", "the policy does not depend on it (default: one for each core)",
             [](Options& o, const std::string& v) { o.threads = number<unsigned>(v, 1, 1024); }},
      Option{"--hidden", "N,N", "widths of the hidden layers (default: 64,64)",
             [](Options& o, const std::string& v) { o.settings.hidden = widths(v); }},
      Option{"--discount", "X", "weight of a reward one step later (default: 0.99)",
             [](Options& o, const std::string& v) {
               o.settings.discount = number<float>(v, 0.0F, 0.99999F);
             }},
      Option{"--checkpoint", "FILE", "write here, every few seconds, what --resume and --from need",
             [](Options& o, const std::string& v) { o.checkpoint = v; }},
      Option{"--resume", "FILE", "go on from a checkpoint: the policy is that of one long run",
             [](Options& o, const std::string& v) { o.resume = v; }},
      Option{"--from", "FILE", "begin with what another training has learnt: its checkpoint",
             [](Options& o, const std::string& v) { o.from = v; }},
      Option{"--csv", "FILE", "write the learning curve as a table",
             [](Options& o, const std::string& v) { o.csv = v; }},
      Option{"--curve", "FILE", "write the learning curve as a picture (SVG)",
             [](Options& o, const std::string& v) { o.curve = v; }},
      Option{"--isa", "NAME", "plain, avx2 or avx512; the bits are the same (default: the fastest)",
             [](Options& o, const std::string& v) { o.kernels = v; }},
  };
  return kTable;
}

const Option* find(std::string_view name) {
  if (name == "--output") name = "-o";
  for (const Option& option : table()) {
    if (name == option.name) return &option;
  }
  return nullptr;
}

}  // namespace

Options parse_options(int argc, const char* const* argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--help" || word == "-h") {
      options.wants_help = true;
      return options;
    }
    if (word == "-q" || word == "--quiet") {
      options.is_quiet = true;
      continue;
    }
    if (word == "--check") {
      options.only_checks = true;
      continue;
    }
    if (!word.starts_with('-')) {
      if (!options.library.empty()) refuse("there is one LIBRARY only, `" + word + "` is another");
      options.library = word;
      continue;
    }
    const std::size_t equals = word.starts_with("--") ? word.find('=') : std::string::npos;
    const Option* option = find(std::string_view(word).substr(0, equals));
    if (option == nullptr) refuse("there is no option `" + word + "`");
    if (equals == std::string::npos && i + 1 == argc) refuse("`" + word + "` needs a value");
    option->set(options, equals == std::string::npos ? argv[++i] : word.substr(equals + 1));
  }
  if (!options.resume.empty() && !options.from.empty())
    refuse("--resume goes on with one training and --from begins another: give one of them");
  if (options.library.empty() && !options.only_checks) refuse("LIBRARY is missing");
  return options;
}

std::string help_text() {
  constexpr std::size_t kColumn = 22;
  std::string text =
      "usage: eagerx-train LIBRARY [options]\n"
      "Trains a policy on the environments of LIBRARY, which `eagerx-gen generate GRAPH.yaml "
      "--target environments` makes.\n"
      "`eagerx-gen train GRAPH.yaml` does both.\n\n";
  for (const Option& option : table()) {
    std::string name = std::string("  ") + option.name + " " + option.value;
    name.resize(std::max(kColumn, name.size() + 1), ' ');
    text += name + option.about + "\n";
  }
  return text +
         "  -q, --quiet         print problems only\n"
         "  --check             only look whether the options are right and the files can be "
         "written\n"
         "Exit codes: 0 done, 1 not successful or a problem of the graph, 2 wrong usage, 3 "
         "cannot read or write, 130 interrupted.\n";
}

}  // namespace eagerx::train
