// The command line of linux-sim programs.
#include "targets/linux-sim/options.hpp"

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

namespace eagerx::linux_sim {
namespace {

std::variant<Options, UsageError> parse(const std::vector<const char*>& arguments) {
  return parse_options(static_cast<int>(arguments.size()), arguments.data(), {});
}

Options options_of(const std::vector<const char*>& arguments) {
  const auto parsed = parse(arguments);
  EXPECT_TRUE(std::holds_alternative<Options>(parsed));
  return std::holds_alternative<Options>(parsed) ? std::get<Options>(parsed) : Options{};
}

/// "problem / help"
std::string error_of(const std::vector<const char*>& arguments) {
  const auto parsed = parse(arguments);
  const auto* error = std::get_if<UsageError>(&parsed);
  return error == nullptr ? "no error" : error->problem + " / " + error->help;
}

TEST(LinuxSimOptions, Defaults) {
  const Options options = options_of({});
  EXPECT_EQ(options.plan.episodes, 1U);
  EXPECT_EQ(options.plan.steps, 300U);
  EXPECT_EQ(options.plan.seed, 1U);
  EXPECT_EQ(options.real_time_factor, 0.0);
  EXPECT_FALSE(options.hash);
}

TEST(LinuxSimOptions, AllOptions) {
  const Options options = options_of(
      {"--episodes", "3", "--steps=450", "--seed", "18446744073709551615", "--agent", "random",
       "--csv", "a.csv", "--trace", "-", "--hash", "--real-time-factor", "0.5", "--quiet"});
  EXPECT_EQ(options.plan.episodes, 3U);
  EXPECT_EQ(options.plan.steps, 450U);
  EXPECT_EQ(options.plan.seed, 18446744073709551615U);
  EXPECT_EQ(options.agent, target::Agent::random);
  EXPECT_EQ(options.csv, "a.csv");
  EXPECT_EQ(options.trace, "-");
  EXPECT_TRUE(options.hash);
  EXPECT_EQ(options.real_time_factor, 0.5);
  EXPECT_TRUE(options.quiet);
}

TEST(LinuxSimOptions, AgentFromAFile) {
  const Options options = options_of({"--agent", "runs/actions.csv"});
  EXPECT_EQ(options.agent, target::Agent::csv);
  EXPECT_EQ(options.action_file, "runs/actions.csv");
}

TEST(LinuxSimOptions, AgentInAnotherProcess) {
  const Options options = options_of({"--agent", "dds:7", "--agent-timeout", "0.5"});
  EXPECT_EQ(options.agent, kDdsAgent);
  EXPECT_EQ(options.agent_domain, 7U);
  EXPECT_EQ(options.agent_timeout_s, 0.5);
  EXPECT_EQ(agent_name(options), "dds");
  EXPECT_EQ(options_of({"--agent", "dds"}).agent_domain, 0U);
  EXPECT_NE(error_of({"--agent", "dds:7@eth0"}), "no error");
  EXPECT_EQ(error_of({"--agent", "zero", "--agent-timeout", "1"}),
            "`--agent-timeout` does nothing without `--agent dds` / leave it out");
}

TEST(LinuxSimOptions, TheLastOneCounts) {
  EXPECT_EQ(options_of({"--steps", "1", "--steps", "2"}).plan.steps, 2U);
}

TEST(LinuxSimOptions, NumbersAreReadStrictly) {
  for (const char* text :
       {"-1", "1e99", "abc", "", " 1", "1 ", "0x10", "0", "1.5", "+1", "18446744073709551616"}) {
    EXPECT_EQ(error_of({"--steps", text}),
              "`" + std::string(text) +
                  "` is not a value of `--steps` / it is a whole number from 1 to "
                  "18446744073709551615");
  }
  EXPECT_NE(error_of({"--episodes", "4294967296"}), "no error");
  for (const char* text : {"-0.5", "nan", "inf", "1e999", "1,5", ""}) {
    EXPECT_NE(error_of({"--real-time-factor", text}), "no error") << text;
  }
}

TEST(LinuxSimOptions, MistakesComeWithHelp) {
  EXPECT_EQ(error_of({"--stpes", "3"}), "unknown option `--stpes` / did you mean `--steps`?");
  EXPECT_EQ(error_of({"--frobnicate"}),
            "unknown option `--frobnicate` / `--help` lists all options");
  EXPECT_EQ(error_of({"graph.yaml"}),
            "unexpected argument `graph.yaml` / `--help` lists all options");
  EXPECT_EQ(error_of({"--hash=1"}), "`--hash` takes no value / leave it out");
  EXPECT_EQ(error_of({"--csv"}), "`--csv` needs a value / it is a file name or `-`");
  EXPECT_EQ(
      error_of({"--agent", "csv"}),
      "`csv` is not a value of `--agent` / it is `policy`, `zero`, `random`, a file ending in "
      "`.csv`, `fd:N`, or `dds[:DOMAIN]` with a domain from 0 to 232");
  EXPECT_EQ(error_of({"--csv", "-", "--trace", "-"}),
            "both `--csv` and `--trace` want the standard output / give one of them a file");
}

TEST(LinuxSimOptions, AnEnvironmentIsANumber) {
  EXPECT_EQ(error_of({"--environment", "-1"}),
            "`-1` is not a value of `--environment` / it is a whole number from 0 to 4294967295");
}

TEST(LinuxSimOptions, HelpNamesEveryOption) {
  const std::string help = options_help({});
  for (const char* option :
       {"--episodes N", "--steps N", "--seed N", "--environment K", "--agent AGENT", "--csv FILE",
        "--trace FILE", "--trace-time", "--trace-scenes", "--replay LOG", "--replay-given LIST",
        "--identify LOG", "--hash", "--real-time-factor X", "--quiet", "--help", "--version",
        "Exit codes: 0"}) {
    EXPECT_NE(help.find(option), std::string::npos) << option;
  }
}

TEST(LinuxSimOptions, RefusesWhatWouldDoNothing) {
  EXPECT_EQ(error_of({"--trace-time"}),
            "`--trace-time` does nothing without `--trace` / leave it out");
  EXPECT_EQ(error_of({"--trace-scenes"}),
            "`--trace-scenes` does nothing without `--trace` / leave it out");
  EXPECT_EQ(error_of({"--identify-delay", "0.1"}),
            "`--identify-delay` does nothing without `--identify` / leave it out");
  EXPECT_EQ(error_of({"--replay", "a", "--csv", "b"}),
            "`--csv` does nothing with `--replay` / leave it out");
  EXPECT_EQ(error_of({"--replay", "a", "--identify", "b"}),
            "`--replay` and `--identify` are two things to do / give one of them");
  options_of({"--replay", "a", "--replay-given", "none", "--agent", "a.csv", "--steps", "5"});
}

TEST(LinuxSimOptions, RealTimeFactorsHaveDeadlines) {
  EXPECT_EQ(options_of({"--real-time-factor", "0"}).real_time_factor, 0.0);
  EXPECT_EQ(options_of({"--real-time-factor", "1e6"}).real_time_factor, 1e6);
  for (const char* factor : {"1e-12", "1e7", "inf", "nan", "-1"})
    EXPECT_NE(error_of({"--real-time-factor", factor}), "no error") << factor;
}

}  // namespace
}  // namespace eagerx::linux_sim
