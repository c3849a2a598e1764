#include "targets/environments/train/sweep_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "targets/environments/client/intervals.hpp"
#include "targets/environments/client/words.hpp"

namespace eagerx::train {
namespace {

using Named = std::vector<std::pair<std::string, std::string>>;  // name, value

/// "a=1 b=2,3"
Named named(const std::string& settings) {
  Named all;
  for (std::size_t at = 0; at < settings.size();) {
    const std::size_t end = std::min(settings.find(' ', at), settings.size());
    const std::string one = settings.substr(at, end - at);
    const std::size_t equals = std::min(one.find('='), one.size());
    all.emplace_back(one.substr(0, equals), one.substr(std::min(equals + 1, one.size())));
    at = end + 1;
  }
  return all;
}

/// The figures of a setting, over its seeds.
struct Figures {
  Named settings;
  std::uint64_t seeds = 0, good = 0, broken = 0;
  std::uint64_t successes = 0, episodes = 0;
  client::Interval of_good, of_success;
  client::Mean mean_return, steps, processor_s;

  double success() const {
    return episodes == 0 ? 0.0 : static_cast<double>(successes) / static_cast<double>(episodes);
  }
  bool is_better_than(const Figures& other) const {
    if (broken != other.broken) return broken < other.broken;
    if (good != other.good) return good * other.seeds > other.good * seeds;
    if (success() != other.success()) return success() > other.success();
    return mean_return.mean > other.mean_return.mean;
  }
};

Figures figures_of(const SweepCase& one) {
  Figures all;
  all.settings = named(one.settings);
  std::vector<double> returns, steps, times;
  for (const SweepRow* row : one.rows) {
    ++all.seeds;
    all.good += row->succeeds ? 1 : 0;
    if (!row->problem.empty()) {
      ++all.broken;
      continue;
    }
    all.successes += row->successes;
    all.episodes += row->episodes;
    returns.push_back(row->mean_return);
    steps.push_back(static_cast<double>(row->steps));
    times.push_back(row->processor_s);
  }
  all.of_good = client::wilson(all.good, all.seeds);
  all.of_success = client::wilson(all.successes, all.episodes);
  all.mean_return = client::mean_of(returns);
  all.steps = client::mean_of(steps);
  all.processor_s = client::mean_of(times);
  return all;
}

std::vector<Figures> ranked(const std::vector<SweepCase>& cases) {
  std::vector<Figures> all;
  for (const SweepCase& one : cases) {
    if (!one.rows.empty()) all.push_back(figures_of(one));
  }
  std::ranges::stable_sort(all,
                           [](const Figures& a, const Figures& b) { return a.is_better_than(b); });
  return all;
}

/// The names whose values differ.
std::vector<std::string> varied(const std::vector<Figures>& all) {
  std::vector<std::string> names;
  if (all.empty()) return names;
  for (std::size_t i = 0; i < all.front().settings.size(); ++i) {
    const auto differs = [&](const Figures& one) {
      return one.settings[i].second != all.front().settings[i].second;
    };
    if (std::ranges::any_of(all, differs)) names.push_back(all.front().settings[i].first);
  }
  return names;
}

std::string value_of(const Figures& one, const std::string& name) {
  const auto found = std::ranges::find(one.settings, name, &Named::value_type::first);
  return found == one.settings.end() ? "" : found->second;
}

using Line = std::vector<std::string>;

std::string aligned(const std::vector<Line>& lines) {
  std::vector<std::size_t> widths(lines.front().size());
  for (const Line& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  }
  std::string text;
  for (const Line& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i)
      text += fmt::format("{}{:>{}}", i == 0 ? "" : "  ", line[i], widths[i]);
    text += "\n";
  }
  return text;
}

/// "99.25 (98.6 to 99.6)"
std::string percent(double share, client::Interval interval) {
  return fmt::format("{:.2f} ({:.1f} to {:.1f})", 100.0 * share, 100.0 * interval.low,
                     100.0 * interval.high);
}

Line line_of(const Figures& one, bool has_success) {
  Line line;
  const std::string good = fmt::format("{} of {}", one.good, one.seeds);
  line.push_back(one.broken == 0 ? good : good + fmt::format(", {} broke", one.broken));
  if (has_success) line.push_back(percent(one.success(), one.of_success));
  line.push_back(one.seeds - one.broken < 2 ? fmt::format("{:.4g}", one.mean_return.mean)
                                            : client::text_of(one.mean_return));
  line.push_back(client::rounded(one.steps.mean));
  line.push_back(fmt::format("{:.3g} s", one.processor_s.mean));
  return line;
}

}  // namespace

std::string sweep_text(const std::vector<SweepCase>& cases, bool has_success) {
  const std::vector<Figures> all = ranked(cases);
  if (all.empty()) return {};
  const std::vector<std::string> names = varied(all);
  Line head = names;
  head.emplace_back("seeds");
  if (has_success) head.emplace_back("success in %");
  for (const char* name : {"return", "steps", "processor"}) head.emplace_back(name);
  std::vector<Line> lines = {head};
  for (const Figures& one : all) {
    Line line;
    for (const std::string& name : names) line.push_back(value_of(one, name));
    for (std::string& cell : line_of(one, has_success)) line.push_back(std::move(cell));
    lines.push_back(std::move(line));
  }
  return aligned(lines);
}

std::string sweep_csv(const std::vector<SweepCase>& cases) {
  const std::vector<Figures> all = ranked(cases);
  std::string text;
  if (all.empty()) return text;
  for (const auto& [name, value] : all.front().settings) text += name + ",";
  text +=
      "seeds,good,good_low,good_high,broken,success,success_low,success_high,return,return_half,"
      "steps,processor_s\n";
  for (const Figures& one : all) {
    for (const auto& [name, value] : one.settings)
      text += value.find(',') == std::string::npos ? value + "," : '"' + value + "\",";
    text +=
        fmt::format("{},{},{:.6g},{:.6g},{},{:.6g},{:.6g},{:.6g},{},{},{:.0f},{:.6g}\n", one.seeds,
                    one.good, one.of_good.low, one.of_good.high, one.broken, one.success(),
                    one.of_success.low, one.of_success.high, one.mean_return.mean,
                    one.mean_return.half, one.steps.mean, one.processor_s.mean);
  }
  return text;
}

}  // namespace eagerx::train
