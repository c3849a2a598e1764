// What the commands `policy` take.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include "generator/cli/arguments.hpp"

namespace eagerx::gen {
namespace {

/// What may be said of a weight file besides it.
struct Saying {
  const char* names;
  const char* about;
  const char* type;
  std::string PolicyFile::*member;
  FileUse use = FileUse::none;
};
constexpr Saying kSayings[] = {
    {"--normalize", "statistics of the observations: VecNormalize.save, npz or JSON", "FILE",
     &PolicyFile::normalize, FileUse::reads},
    {"--activation", "activation of the hidden layers, if the file does not say it", "NAME",
     &PolicyFile::activation},
    {"--output-activation",
     "what follows the last layer (such as none or tanh), if the file does not say it", "NAME",
     &PolicyFile::output_activation},
    {"--actor", "of a file with several actors: how the names of its tensors begin", "NAME",
     &PolicyFile::actor},
    {"--output", "which output of an ONNX file is the action", "NAME", &PolicyFile::output_name},
};

Arguments one_policy(Options& options) {
  Arguments all = {required(reads(text("file", options.policy.file, "the weight file", "FILE")))};
  for (const Saying& saying : kSayings) {
    all.push_back(text(saying.names, options.policy.*saying.member, saying.about, saying.type));
    all.back().use = saying.use;
  }
  return gen::joined({std::move(all), diagnostics(options)});
}

/// Once for both files; twice, first for the first; `-` for nothing.
Argument for_both(Options& options, const Saying& saying) {
  Argument argument{saying.names, std::string(saying.about) + "; twice: one for each, - for none",
                    saying.type,
                    [&options, member = saying.member](const std::vector<std::string>& values) {
                      const auto said = [](const std::string& value) {
                        return value == "-" ? std::string() : value;
                      };
                      options.policy.*member = said(values.front());
                      options.second_policy.*member = said(values.back());
                      options.said_too_often |= values.size() > 2;
                    }};
  argument.repeated = true;
  argument.use = saying.use;
  return argument;
}

Arguments two_policies(Options& options) {
  Arguments all = {required(reads(text("first", options.policy.file, "the weight file", "FIRST"))),
                   reads(text("second", options.second_policy.file,
                              "the other one (default, with --int8: the first)", "SECOND")),
                   flag("--int8", options.int8,
                        "round the weights of the second to eight bits, as `weights: int8` does")};
  for (const Saying& saying : kSayings) all.push_back(for_both(options, saying));
  return gen::joined({std::move(all), diagnostics(options)});
}

Argument whole_number(std::string names, std::string about, std::uint64_t lowest,
                      std::uint64_t highest, std::function<void(std::uint64_t)> take) {
  const auto parsed = [lowest, highest](const std::string& text) -> std::optional<std::uint64_t> {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc{} || result.ptr != end || value < lowest || value > highest) {
      return std::nullopt;
    }
    return value;
  };
  Argument argument{std::move(names), std::move(about), "N",
                    [parsed, take = std::move(take)](const std::vector<std::string>& values) {
                      take(parsed(values.front()).value_or(0));
                    }};
  argument.check = [parsed, lowest, highest](const std::string& text) {
    return parsed(text) ? std::string()
                        : text + " is no whole number from " + std::to_string(lowest) + " to " +
                              std::to_string(highest);
  };
  return argument;
}

Arguments asked(Options& options) {
  constexpr std::uint64_t kMostRows = 1'000'000;
  constexpr std::uint64_t kMostSeed = 0xFFFFFFFF;
  return {whole_number("--rows", "how many observations to draw (default: 1000)", 1, kMostRows,
                       [&options](std::uint64_t rows) { options.rows = rows; }),
          whole_number(
              "--seed", "where random numbers start (default: 1)", 0, kMostSeed,
              [&options](std::uint64_t seed) { options.seed = static_cast<std::uint32_t>(seed); }),
          reads(text(
              "--observations", options.observations,
              "take these instead of drawn ones: columns obs0, obs1 …, of a policy with a memory "
              "also episode_start",
              "FILE.csv|npz"))};
}

std::string check_asked(const Options& options) {
  if (options.observations.empty() || (options.rows == 0 && !options.seed)) return {};
  return "--rows and --seed are for drawn observations, not for --observations";
}

std::string check_two(const Options& options) {
  if (options.said_too_often) return "an option is there more than twice: there are two files";
  if (options.second_policy.file.empty() && !options.int8) {
    return "a second file is missing, or --int8";
  }
  return check_asked(options);
}

Argument tolerance(Options& options) {
  const auto parsed = [](const std::string& text) -> std::optional<double> {
    double value = 0.0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc{} || result.ptr != end || !std::isfinite(value) || value < 0.0) {
      return std::nullopt;
    }
    return value;
  };
  Argument argument{"--tolerance",
                    "what an output may be off (default: 1e-5 of its range, and at least 1e-5)",
                    "X", [&options, parsed](const std::vector<std::string>& values) {
                      options.tolerance = parsed(values.front());
                    }};
  argument.check = [parsed](const std::string& text) {
    return parsed(text) ? std::string() : text + " is no number from 0 on";
  };
  return argument;
}

Command golden(Options& options) {
  Argument output = required(
      writes(text("-o,--output-file", options.output, "the table to write", "GOLDEN.csv")));
  return {.name = "golden",
          .about = "write observations with its answers, computed in float64",
          .examples = {{"1000 drawn observations; the same for the same seed",
                        "eagerx-gen policy golden swing_up.onnx --rows 1000 -o golden.csv"},
                       {"observations of a run",
                        "eagerx-gen policy golden sac.zip --observations run.csv -o golden.csv"}},
          .arguments = gen::joined({one_policy(options), asked(options), {std::move(output)}}),
          .check = [&options] { return check_asked(options); },
          .run = [&options] { return policy_golden_command(options); }};
}

Command compare(Options& options) {
  return {.name = "compare",
          .about = "how far the answers of two policies are apart: exit code 1 if too far",
          .examples = {{"what was trained and what was exported",
                        "eagerx-gen policy compare sac.zip sac.onnx"},
                       {"with statistics for the first one only",
                        "eagerx-gen policy compare ppo.zip ppo.onnx --normalize stats.pkl "
                        "--normalize -"},
                       {"what weights of eight bits cost",
                        "eagerx-gen policy compare sac.zip --int8 --tolerance 0.05"}},
          .arguments = gen::joined({two_policies(options),
                                    asked(options),
                                    {tolerance(options), flag("--json", options.json_output,
                                                              "print the differences as JSON")}}),
          .check = [&options] { return check_two(options); },
          .run = [&options] { return policy_compare_command(options); }};
}

}  // namespace

Command policy_commands(Options& options) {
  const auto run = [&options] { return policy_command(options); };
  return {
      .name = "policy",
      .about = "look into a trained policy",
      .examples = {{"layers, size and what it expects", "eagerx-gen policy info swing_up.onnx"},
                   {"its error on known answers",
                    "eagerx-gen policy test swing_up.onnx answers.csv"}},
      .commands = {
          {.name = "info",
           .about = "layers, size and what it expects of a graph",
           .examples = {{"an ONNX file", "eagerx-gen policy info swing_up.onnx"},
                        {"a model of Stable-Baselines3 with its statistics",
                         "eagerx-gen policy info sac.zip --normalize vec_normalize.pkl"}},
           .arguments = one_policy(options),
           .run = run},
          {.name = "test",
           .about = "compare its answers with known answers",
           .examples = {{"rows of a CSV file", "eagerx-gen policy test swing_up.onnx answers.csv"}},
           .arguments = gen::joined({one_policy(options),
                                     {required(reads(text("golden", options.golden,
                                                          "rows of observations and known answers",
                                                          "GOLDEN.csv|npz")))}}),
           .run = run},
          golden(options),
          compare(options)}};
}

}  // namespace eagerx::gen
