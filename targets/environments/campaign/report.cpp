#include "targets/environments/campaign/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <runtime/host/base/counted.hpp>

#include "targets/environments/campaign/statistics.hpp"

namespace eagerx::campaign {
namespace {

using nlohmann::ordered_json;

constexpr double kPercent = 100.0;

/// 1234567 as "1,234,567"
std::string grouped(std::uint64_t number) {
  std::string digits = fmt::format("{}", number);
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, ",");
  return digits;
}

/// How the result depends on a number of the states.
struct Sensitivity {
  std::string name;
  double correlation = 0.0;  // of ranks, with the return
  std::array<Tenth, kTenths> tenths;
};

struct Statistics {
  std::uint64_t successes = 0, terminated = 0, truncated = 0, not_finite = 0, steps = 0;
  std::uint32_t first_not_finite = 0;  // run
  Interval interval;
  std::array<double, kPercentages.size()> returns{}, lengths{};
  double mean_return = 0.0;  // of those that are finite
  std::vector<Sensitivity> sensitivities;
  std::vector<std::uint32_t> worst;
};

std::vector<double> sorted(std::vector<double> values) {
  std::ranges::sort(values);
  return values;
}

std::vector<double> column_of(const Results& results, std::size_t column) {
  std::vector<double> values(results.size());
  for (std::size_t run = 0; run < values.size(); ++run)
    values[run] = results.states[run * results.width + column];
  return values;
}

/// The state that each column belongs to.
std::vector<const client::Space*> spaces_of(const client::Description& description) {
  std::vector<const client::Space*> spaces;
  for (const client::Space& state : description.states)
    spaces.insert(spaces.end(), state.size, &state);
  return spaces;
}

/// Whether a larger value means nothing: a whole number that is called so, or has a type's range.
bool is_seed(const client::Space& state) {
  constexpr double kWide = 2147483646.0;  // of an int32 that is not negative
  if (!state.is_whole()) return false;
  if (state.name.ends_with(".seed") || state.name.ends_with("_seed")) return true;
  const double width = state.low.empty() ? 0.0 : state.high.front() - state.low.front();
  return std::isfinite(width) && width >= kWide;
}

/// As the state's type writes it.
std::string text_of(const client::Space& state, double value) {
  if (state.is_whole()) return fmt::format("{:.0f}", value);
  if (state.dtype == "float32") return fmt::format("{}", static_cast<float>(value));
  return fmt::format("{}", value);
}

/// Of all numbers of the states that differ between runs, varied or sampled by the graph.
std::vector<Sensitivity> sensitivities_of(const client::Description& description, const Plan& plan,
                                          const Results& results,
                                          const std::vector<double>& returns) {
  const std::vector<const client::Space*> spaces = spaces_of(description);
  std::vector<Sensitivity> all;
  for (std::size_t column = 0; column < plan.width(); ++column) {
    if (column < spaces.size() && is_seed(*spaces[column])) continue;
    const std::vector<double> values = column_of(results, column);
    const auto is_nan = [](double x) { return std::isnan(x); };
    const auto differs = [&](double x) { return x != values.front(); };
    if (std::ranges::any_of(values, is_nan) || std::ranges::none_of(values, differs)) continue;
    all.push_back({plan.name_of(column) + (column < plan.columns.size() ? "" : " begins"),
                   rank_correlation(values, returns), tenths(values, results)});
  }
  return all;
}

Statistics statistics_of(const Report& report) {
  const Results& results = report.results;
  Statistics all;
  std::vector<double> lengths;
  for (std::size_t run = 0; run < results.size(); ++run) {
    const bool is_finite = std::isfinite(results.returns[run]);
    all.successes += results.succeeded(run) ? 1U : 0U;
    all.terminated += (results.flags[run] & kTerminated) != 0 ? 1U : 0U;
    all.truncated += (results.flags[run] & kTruncated) != 0 ? 1U : 0U;
    if (!is_finite && all.not_finite++ == 0) all.first_not_finite = static_cast<std::uint32_t>(run);
    all.steps += results.steps[run];
    if (is_finite) all.mean_return += results.returns[run];
    lengths.push_back(results.steps[run]);
  }
  all.mean_return /= static_cast<double>(results.size() - all.not_finite);
  all.interval = wilson(all.successes, results.size());
  const std::vector<double> returns = comparable(results.returns);
  all.returns = percentiles(sorted(returns));
  all.lengths = percentiles(sorted(std::move(lengths)));
  all.sensitivities = sensitivities_of(report.description, report.plan, results, returns);
  all.worst = worst_runs(results, report.worst);
  return all;
}

void add_percentiles(std::string& text, const char* name,
                     const std::array<double, kPercentages.size()>& values) {
  text += fmt::format("{:12}", name);
  for (const double value : values) text += fmt::format("{:>12.6g}", value);
  text += "\n";
}

void add_sensitivities(std::string& text, const Statistics& all) {
  if (all.sensitivities.empty()) return;
  std::size_t width = 0;
  for (const Sensitivity& one : all.sensitivities) width = std::max(width, one.name.size());
  text +=
      "\nrank correlation (Spearman) with the return; success in % in each tenth of the runs, "
      "from the lowest values to the highest\n";
  for (const Sensitivity& one : all.sensitivities) {
    text += std::isnan(one.correlation)
                ? fmt::format("{:{}}      -  ", one.name, width)
                : fmt::format("{:{}}  {:+.3f}  ", one.name, width, one.correlation);
    for (const Tenth& tenth : one.tenths) {
      text += tenth.runs == 0
                  ? fmt::format("{:>7}", "-")
                  : fmt::format("{:7.1f}", kPercent * static_cast<double>(tenth.successes) /
                                               static_cast<double>(tenth.runs));
    }
    text +=
        fmt::format("  from {:.4g} to {:.4g}\n", one.tenths.front().low, one.tenths.back().high);
  }
}

/// "succeeded", "failed, terminated"
std::string verdict(const Results& results, std::uint32_t run) {
  return std::string(results.succeeded(run) ? "succeeded" : "failed") +
         ((results.flags[run] & kTerminated) != 0 ? ", terminated" : "");
}

ordered_json number_or_null(double x) {
  return std::isfinite(x) ? ordered_json(x) : ordered_json(nullptr);
}

ordered_json json_of(const std::array<double, kPercentages.size()>& values) {
  ordered_json result = ordered_json::object();
  for (std::size_t i = 0; i < values.size(); ++i)
    result[fmt::format("{}", kPercentages[i])] = number_or_null(values[i]);
  return result;
}

ordered_json json_of(const Sensitivity& one) {
  ordered_json result{{"name", one.name}, {"rank_correlation", number_or_null(one.correlation)}};
  for (const Tenth& tenth : one.tenths) {
    result["tenths"].push_back({{"low", tenth.low},
                                {"high", tenth.high},
                                {"runs", tenth.runs},
                                {"successes", tenth.successes}});
  }
  return result;
}

}  // namespace

std::string Report::command(std::uint32_t run) const {
  std::string text = fmt::format("{} --seed {} --environment {}", replay, plan.seed, run);
  if (says_steps) text += fmt::format(" --steps {}", plan.longest);
  std::size_t column = 0;
  for (const client::Space& state : description.states) {
    const std::size_t first = column;
    column += state.size;
    const bool is_varied = std::ranges::any_of(plan.sampled, [&](const Sampled& sampled) {
      return sampled.column >= first && sampled.column < column;
    });
    if (!is_varied) continue;
    // Also the elements that the graph has sampled: they are what they were.
    text += " --set " + state.name;
    for (std::size_t i = first; i < column; ++i) {
      text += i == first ? "=" : ",";
      text += text_of(state, results.states[run * results.width + i]);
    }
  }
  // In quotes, because brackets are patterns of a shell.
  for (const target::PlacedFault& one : plan.faults_of(run))
    text += fmt::format(" --fault '{}'", text_of(one.fault));
  return text;
}

std::string Report::text() const {
  const Statistics all = statistics_of(*this);
  std::string text = fmt::format("campaign of {}: {} {} of seed {}, agent {}\n", description.graph,
                                 grouped(results.size()), host::noun(results.size(), "run"),
                                 plan.seed, description.agent);
  for (const Variation& one : plan.variations)
    text += fmt::format("varied: {} from {} to {}\n", one.name, one.low, one.high);
  for (const target::PlacedFault& one : plan.faults)
    text += fmt::format("fault: {}\n", text_of(one.fault));
  text += fmt::format(
      "success: {} of {}, {:.3f} %; 95 % interval {:.3f} to {:.3f} % (Wilson)\n",
      grouped(all.successes), grouped(results.size()),
      kPercent * static_cast<double>(all.successes) / static_cast<double>(results.size()),
      kPercent * all.interval.low, kPercent * all.interval.high);
  text += fmt::format("terminated: {}, truncated: {}, steps: {}\n", grouped(all.terminated),
                      grouped(all.truncated), grouped(all.steps));
  if (all.not_finite != 0) {
    text += fmt::format(
        "{} a return that is not finite: it counts as the lowest. The first is run {}; "
        "this says which term, and when\n  {}\n",
        grouped(all.not_finite) + (all.not_finite == 1 ? " run has" : " runs have"),
        all.first_not_finite, command(all.first_not_finite));
  }
  for (const auto& [name, count] : results.counts)
    text += fmt::format("counted: {} {}\n", name, grouped(count));
  text += fmt::format("mean return: {:.6g}\n\n{:12}", all.mean_return, "percentile");
  for (const unsigned one : kPercentages) text += fmt::format("{:>12}", one);
  text += "\n";
  add_percentiles(text, "return", all.returns);
  add_percentiles(text, "steps", all.lengths);
  add_sensitivities(text, all);
  if (!all.worst.empty()) text += "\nthe worst runs, and what repeats each\n";
  for (const std::uint32_t run : all.worst) {
    text +=
        fmt::format("run {}: {}, return {:.6g}, {}\n  {} --summary\n", run, verdict(results, run),
                    results.returns[run], host::counted(results.steps[run], "step"), command(run));
  }
  return text;
}

std::string Report::json() const {
  const Statistics all = statistics_of(*this);
  ordered_json report{{"graph", description.graph},
                      {"agent", description.agent},
                      {"runs", results.size()},
                      {"seed", plan.seed},
                      {"successes", all.successes},
                      {"success_95_percent", {all.interval.low, all.interval.high}},
                      {"terminated", all.terminated},
                      {"truncated", all.truncated},
                      {"not_finite", all.not_finite},
                      {"steps", all.steps},
                      {"mean_return", number_or_null(all.mean_return)},
                      {"return_percentiles", json_of(all.returns)},
                      {"steps_percentiles", json_of(all.lengths)},
                      {"counts", results.counts},
                      {"varied", ordered_json::array()},
                      {"faults", ordered_json::array()},
                      {"sensitivities", ordered_json::array()},
                      {"worst", ordered_json::array()}};
  if (all.not_finite != 0) {
    report["first_not_finite"] = {{"run", all.first_not_finite},
                                  {"command", command(all.first_not_finite)}};
  }
  for (const Variation& one : plan.variations)
    report["varied"].push_back({{"name", one.name}, {"low", one.low}, {"high", one.high}});
  for (const target::PlacedFault& one : plan.faults) report["faults"].push_back(text_of(one.fault));
  for (const Sensitivity& one : all.sensitivities) report["sensitivities"].push_back(json_of(one));
  for (const std::uint32_t run : all.worst) {
    report["worst"].push_back({{"run", run},
                               {"success", results.succeeded(run)},
                               {"return", number_or_null(results.returns[run])},
                               {"steps", results.steps[run]},
                               {"command", command(run)}});
  }
  return report.dump(2) + "\n";
}

std::string Report::csv() const {
  std::string text = "run,return,steps,success,terminated,truncated";
  for (const std::string& name : plan.columns) text += ",state:" + name;
  for (const target::PlacedFault& one : plan.faults) text += ",fault:" + text_of(one.fault);
  text += "\n";
  auto out = std::back_inserter(text);
  const std::vector<const client::Space*> spaces = spaces_of(description);
  for (std::size_t run = 0; run < results.size(); ++run) {
    const auto flag = [&](Flags one) { return (results.flags[run] & one) != 0 ? 1 : 0; };
    fmt::format_to(out, "{},{},{},{},{},{}", run, results.returns[run], results.steps[run],
                   flag(kSuccess), flag(kTerminated), flag(kTruncated));
    for (std::size_t i = 0; i < results.width; ++i) {
      const double x = results.states[run * results.width + i];
      text += ",";
      if (std::isnan(x)) continue;  // empty: nothing has set it
      text += i < spaces.size() ? text_of(*spaces[i], x) : fmt::format("{}", x);
    }
    text += "\n";
  }
  return text;
}

}  // namespace eagerx::campaign
