#include "generator/tools/campaign/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "generator/support/diagnostics/join.hpp"
#include "generator/tools/trace/axis.hpp"
#include "generator/tools/trace/svg.hpp"

namespace eagerx::gen::campaign {
namespace {

constexpr int kWidth = 760, kLeft = 70, kRight = 690, kTitle = 44;
// A panel: its title, the plot, numbers and name of its x axis.
constexpr int kPanel = 200, kAbove = 26, kBelow = 44;
constexpr std::size_t kBins = 40, kTenths = 10, kMostPanels = 32;
constexpr std::size_t kGood = 2, kBad = 1;  // colours

/// A panel with axes of its own.
class Panel {
 public:
  Panel(int top, PlotRange x, PlotRange y) : top_(top), x_(x), y_(y) {}

  double x(double value) const { return kLeft + (kRight - kLeft) * x_.share(value); }
  double y(double value) const { return bottom() - (bottom() - top()) * y_.share(value); }
  double top() const { return top_ + kAbove; }
  double bottom() const { return top_ + kPanel - kBelow; }

  std::string axes(const std::string& title, const std::string& under, bool percent) const {
    std::string text = svg_label(kLeft, top_ + 16, "start", title, "name");
    for (const PlotMark& mark : marks_of(y_, 4)) {
      text +=
          fmt::format("<path class=\"grid\" d=\"M{} {:.1f}H{}\"/>\n", kLeft, y(mark.value), kRight);
      text += svg_label(kLeft - 6, y(mark.value) + 4, "end",
                        percent ? fmt::format("{:.6g} %", 100.0 * mark.value) : mark.text, "");
    }
    for (const PlotMark& mark : marks_of(x_, 8)) {
      text += fmt::format("<path class=\"grid\" d=\"M{0:.1f} {1:.1f}V{2:.1f}\"/>\n", x(mark.value),
                          top(), bottom());
      text += svg_label(x(mark.value), bottom() + 16, "middle", mark.text, "");
    }
    return text + svg_label(kRight, bottom() + 32, "end", under, "");
  }

  std::string bar(double from, double to, double low, double high, std::size_t colour) const {
    if (!(high > low)) return {};
    return fmt::format(
        "<rect class=\"t{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
        colour, x(from), y(high), std::max(x(to) - x(from) - 0.5, 0.5), y(low) - y(high));
  }
  /// An upright line with a dot: a share with its interval.
  std::string share(double at, double low, double value, double high, std::size_t colour) const {
    return fmt::format(
        "<path class=\"line l{0}\" d=\"M{1:.1f} {2:.1f}V{3:.1f}\"/>\n"
        "<circle class=\"t{0}\" cx=\"{1:.1f}\" cy=\"{4:.1f}\" r=\"3\"/>\n",
        colour, x(at), y(low), y(high), y(value));
  }
  std::string stroke(const std::string& points, std::size_t colour) const {
    return fmt::format("<polyline class=\"line l{}\" points=\"{}\"/>\n", colour, points);
  }

 private:
  int top_;
  PlotRange x_, y_;
};

std::string legend(int top, const std::vector<std::pair<std::size_t, std::string>>& entries) {
  std::string text;
  double at = kRight;
  for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) {
    constexpr double kCharacter = 6.7;
    text += svg_label(at, top + 16, "end", entry->second, "");
    at -= kCharacter * static_cast<double>(entry->second.size()) + 16;
    text += fmt::format("<rect class=\"t{}\" x=\"{:.1f}\" y=\"{}\" width=\"10\" height=\"10\"/>\n",
                        entry->first, at, top + 7);
    at -= 14;
  }
  return text;
}

/// The range of the finite ones.
PlotRange range_of(const std::vector<const std::vector<double>*>& lists) {
  PlotPanel panel;
  for (const auto* list : lists) {
    PlotLine line;
    std::ranges::copy_if(*list, std::back_inserter(line.value),
                         [](double value) { return std::isfinite(value); });
    panel.lines.push_back(std::move(line));
  }
  return value_range(panel);
}

/// How many of the values that `wanted` takes lie in each of the bins of the range.
template <class Wanted>
std::vector<double> counts_of(const std::vector<double>& values, const PlotRange& range,
                              Wanted&& wanted) {
  std::vector<double> counts(kBins);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i]) || !wanted(i)) continue;
    const auto bin = static_cast<std::size_t>(range.share(values[i]) * kBins);
    counts[std::min(bin, kBins - 1)] += 1.0;
  }
  return counts;
}

double edge(const PlotRange& range, std::size_t bin) {
  return range.low + (range.high - range.low) * static_cast<double>(bin) / kBins;
}

double most_of(const std::vector<double>& counts) {
  return std::max(1.0, std::ranges::max(counts));
}

/// Wilson's interval of 95 % (1927), as in the report of a campaign.
struct Share {
  double low, value, high;
};
Share share_of(std::size_t successes, std::size_t runs) {
  constexpr double kZ = 1.959963984540054;
  const auto n = static_cast<double>(runs);
  const double p = static_cast<double>(successes) / n;
  const double middle = (p + kZ * kZ / (2 * n)) / (1 + kZ * kZ / n);
  const double half = kZ / (1 + kZ * kZ / n) * std::sqrt(p * (1 - p) / n + kZ * kZ / (4 * n * n));
  return {std::max(middle - half, 0.0), p, std::min(middle + half, 1.0)};
}

std::size_t successes_of(const CampaignTable& table) {
  return static_cast<std::size_t>(std::ranges::count(table.successes, true));
}

std::string success_text(const CampaignTable& table) {
  const Share share = share_of(successes_of(table), table.returns.size());
  return fmt::format("{} of {} succeed ({:.4g} %, 95 %: {:.4g} to {:.4g} %)", successes_of(table),
                     table.returns.size(), 100 * share.value, 100 * share.low, 100 * share.high);
}

/// Runs with a value in this column, from the lowest to the highest, in parts of equal numbers.
struct Part {
  double from = 0.0, to = 0.0, mean = 0.0;
  std::size_t successes = 0, runs = 0;
};
std::vector<Part> parts_of(const std::vector<double>& values, const CampaignTable& table) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(values[i])) order.push_back(i);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[i]; });
  const std::size_t count = std::min(kTenths, order.size());
  std::vector<Part> parts;
  for (std::size_t p = 0; p < count; ++p) {
    const std::size_t begin = p * order.size() / count, end = (p + 1) * order.size() / count;
    Part part{values[order[begin]], values[order[end - 1]], 0.0, 0, end - begin};
    for (std::size_t i = begin; i < end; ++i) {
      part.mean += values[order[i]] / static_cast<double>(part.runs);
      part.successes += table.successes[order[i]] ? 1U : 0U;
    }
    parts.push_back(part);
  }
  return parts;
}

/// The share that succeeds over a column, for each table that has it.
std::string success_panel(int top, const std::string& name,
                          const std::vector<const CampaignTable*>& tables) {
  std::vector<const std::vector<double>*> values;
  std::vector<std::size_t> of;
  for (std::size_t t = 0; t < tables.size(); ++t) {
    for (const CampaignColumn& column : tables[t]->sampled) {
      if (column.name != name) continue;
      values.push_back(&column.values);
      of.push_back(t);
    }
  }
  const Panel panel(top, range_of(values), {0.0, 1.0});
  std::string text =
      panel.axes("success over " + name, name + ", in parts of equally many runs", true);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t colour = tables.size() == 1 ? kGood : of[i];
    for (const Part& part : parts_of(*values[i], *tables[of[i]])) {
      const Share share = share_of(part.successes, part.runs);
      text += panel.share(part.mean, share.low, share.value, share.high, colour);
      text +=
          panel.stroke(fmt::format("{:.1f},{:.1f} {:.1f},{:.1f}", panel.x(part.from),
                                   panel.y(share.value), panel.x(part.to), panel.y(share.value)),
                       colour);
    }
  }
  return text;
}

/// Names of columns, those of the first table first.
std::vector<std::string> columns_of(const std::vector<const CampaignTable*>& tables) {
  std::vector<std::string> names;
  for (const CampaignTable* table : tables) {
    for (const CampaignColumn& column : table->sampled)
      if (std::ranges::find(names, column.name) == names.end()) names.push_back(column.name);
  }
  if (names.size() > kMostPanels) names.resize(kMostPanels);
  return names;
}

std::string not_finite_text(const CampaignTable& table) {
  const auto count =
      std::ranges::count_if(table.returns, [](double r) { return !std::isfinite(r); });
  return count == 0 ? "" : fmt::format("; {} not finite", count);
}

std::string returns_panel(int top, const CampaignTable& table) {
  const PlotRange range = range_of({&table.returns});
  const auto all = counts_of(table.returns, range, [](std::size_t) { return true; });
  const auto good =
      counts_of(table.returns, range, [&](std::size_t i) { return table.successes[i]; });
  const Panel panel(top, range, {0.0, most_of(all)});
  std::string text = panel.axes("runs with a return", "return" + not_finite_text(table), false);
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    text += panel.bar(edge(range, bin), edge(range, bin + 1), 0.0, good[bin], kGood);
    text += panel.bar(edge(range, bin), edge(range, bin + 1), good[bin], all[bin], kBad);
  }
  return text + legend(top, {{kGood, "success"}, {kBad, "none"}});
}

/// The outlines of both histograms.
std::string both_panel(int top, const std::vector<const CampaignTable*>& tables) {
  const PlotRange range = range_of({&tables[0]->returns, &tables[1]->returns});
  std::vector<std::vector<double>> counts;
  for (const CampaignTable* table : tables)
    counts.push_back(counts_of(table->returns, range, [](std::size_t) { return true; }));
  const Panel panel(top, range, {0.0, std::max(most_of(counts[0]), most_of(counts[1]))});
  std::string text = panel.axes("runs with a return", "return", false);
  for (std::size_t t = 0; t < tables.size(); ++t) {
    std::string points = fmt::format("{:.1f},{:.1f}", panel.x(range.low), panel.y(0.0));
    for (std::size_t bin = 0; bin < kBins; ++bin)
      points += fmt::format(" {:.1f},{:.1f} {:.1f},{:.1f}", panel.x(edge(range, bin)),
                            panel.y(counts[t][bin]), panel.x(edge(range, bin + 1)),
                            panel.y(counts[t][bin]));
    points += fmt::format(" {:.1f},{:.1f}", panel.x(range.high), panel.y(0.0));
    text += panel.stroke(points, t);
  }
  return text + legend(top, {{0, tables[0]->name}, {1, tables[1]->name}});
}

/// How much better the second is, pair by pair.
std::string pairs_panel(int top, const CampaignTable& first, const CampaignTable& second) {
  const std::size_t runs = std::min(first.returns.size(), second.returns.size());
  std::vector<double> more(runs);
  for (std::size_t i = 0; i < runs; ++i) more[i] = second.returns[i] - first.returns[i];
  std::vector<double> finite;
  std::ranges::copy_if(more, std::back_inserter(finite), [](double d) { return std::isfinite(d); });
  const auto n = static_cast<double>(finite.size());
  const double mean = finite.empty() ? 0.0 : std::accumulate(finite.begin(), finite.end(), 0.0) / n;
  double squares = 0.0;
  for (const double value : finite) squares += (value - mean) * (value - mean);
  constexpr double kZ = 1.959963984540054;
  const double half = n > 1.0 ? kZ * std::sqrt(squares / (n - 1.0) / n) : 0.0;
  const PlotRange range = range_of({&finite});
  const auto worse = counts_of(more, range, [&](std::size_t i) { return more[i] < 0.0; });
  const auto all = counts_of(more, range, [](std::size_t) { return true; });
  const Panel panel(top, range, {0.0, most_of(all)});
  std::string text =
      panel.axes(fmt::format("return of {} minus {}, {} pairs: mean {:.4g} ± {:.2g} (95 %)",
                             second.name, first.name, finite.size(), mean, half),
                 "difference of the returns of a pair", false);
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    text += panel.bar(edge(range, bin), edge(range, bin + 1), 0.0, worse[bin], 0);
    text += panel.bar(edge(range, bin), edge(range, bin + 1), worse[bin], all[bin], 1);
  }
  return text + panel.stroke(fmt::format("{0:.1f},{1:.1f} {0:.1f},{2:.1f}", panel.x(mean),
                                         panel.top(), panel.bottom()),
                             3);
}

/// "both succeed 90, only plain 3, only steps 7, neither 0"
std::string pairs_text(const CampaignTable& first, const CampaignTable& second) {
  std::size_t counts[2][2] = {};
  const std::size_t runs = std::min(first.returns.size(), second.returns.size());
  for (std::size_t i = 0; i < runs; ++i)
    ++counts[first.successes[i] ? 1 : 0][second.successes[i] ? 1 : 0];
  return fmt::format("success of a pair: both {}, only {} {}, only {} {}, neither {}", counts[1][1],
                     first.name, counts[1][0], second.name, counts[0][1], counts[0][0]);
}

/// The name of a column that differs between the runs of a pair; empty if all are the same.
std::string other_sample(const CampaignTable& first, const CampaignTable& second) {
  for (const CampaignColumn& a : first.sampled) {
    const auto b = std::ranges::find(second.sampled, a.name, &CampaignColumn::name);
    if (b == second.sampled.end()) continue;
    for (std::size_t i = 0; i < std::min(a.values.size(), b->values.size()); ++i) {
      const bool both_empty = std::isnan(a.values[i]) && std::isnan(b->values[i]);
      if (a.values[i] != b->values[i] && !both_empty) return a.name;
    }
  }
  return {};
}

}  // namespace

std::string campaign_svg(const CampaignTable& table) {
  const std::vector<std::string> names = columns_of({&table});
  const int height = kTitle + kPanel * static_cast<int>(1 + names.size());
  std::string text = svg_begin(kWidth, height);
  text += svg_label(kLeft, 22, "start", table.name + ": " + success_text(table), "name");
  int top = kTitle;
  text += returns_panel(top, table);
  for (const std::string& name : names) text += success_panel(top += kPanel, name, {&table});
  return text + "</svg>\n";
}

std::string comparison_svg(const CampaignTable& first, const CampaignTable& second) {
  constexpr int kLines = 40;  // of the title, more
  const std::vector<const CampaignTable*> tables = {&first, &second};
  const std::vector<std::string> names = columns_of(tables);
  const int height = kTitle + kLines + kPanel * static_cast<int>(2 + names.size());
  std::string text = svg_begin(kWidth, height);
  int line = 22;
  text += svg_label(kLeft, line, "start", first.name + ": " + success_text(first), "name");
  text += svg_label(kLeft, line += 18, "start", second.name + ": " + success_text(second), "name");
  text += svg_label(kLeft, line + 18, "start", pairs_text(first, second), "");
  int top = kTitle + kLines;
  text += both_panel(top, tables);
  text += pairs_panel(top += kPanel, first, second);
  for (const std::string& name : names) text += success_panel(top += kPanel, name, tables);
  return text + "</svg>\n";
}

TraceResult plot_campaigns(const std::vector<std::string>& paths) {
  TraceResult result;
  std::vector<CampaignTable> tables;
  for (const std::string& path : paths) {
    auto table = read_campaign(path, result.problem);
    if (!table) return result;
    tables.push_back(std::move(*table));
  }
  result.readable = true;
  result.summary = counted(tables[0].returns.size(), "run");
  if (tables.size() == 1) {
    result.bytes = campaign_svg(tables[0]);
    return result;
  }
  if (tables[0].name == tables[1].name) tables[1].name += " (2)";
  if (const std::string name = other_sample(tables[0], tables[1]); !name.empty())
    result.note = fmt::format(
        "`{}` differs within pairs: give both campaigns the same `--seed` and the same `--vary`",
        name);
  result.bytes = comparison_svg(tables[0], tables[1]);
  return result;
}

}  // namespace eagerx::gen::campaign
