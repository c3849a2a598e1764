// The ages that `budget:` limits.
#include <fmt/format.h>

#include <map>

#include "generator/analysis/info/info.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// An entry of `age` as it is written; the number for all is one without names.
struct Entry {
  AgeLimit limit;
  Span name;  // of what it names, else of the limit
};

/// How exactly it says which pairs it is about.
int exactness(const AgeLimit& limit) {
  return (limit.from.empty() ? 0 : 1) + (limit.to.empty() ? 0 : 1);
}

bool is_about(const AgeLimit& limit, const DataAge& age) {
  return (limit.from.empty() || limit.from == age.from) && (limit.to.empty() || limit.to == age.to);
}

const char* kind_of_source(const PathEnds& ends) {
  return ends.from_actions ? "an action" : "a sensor";
}
const char* kind_of_destination(const PathEnds& ends) {
  return ends.to_observations ? "an observation" : "an actuator";
}

class AgeBudget {
 public:
  AgeBudget(const Plan& plan, Diagnostics& diagnostics)
      : plan_(plan), graph_(*plan.graph), diagnostics_(diagnostics) {}

  std::vector<AgeComparison> run(const std::vector<AgeBudgetSpec>& written) {
    std::vector<Entry> entries;
    for (const AgeBudgetSpec& item : written) {
      if (auto entry = read(item)) entries.push_back(std::move(*entry));
    }
    std::vector<AgeComparison> result;
    for (const Entry& entry : entries) {
      const DataAges& all = ages(entry.limit.ends);
      AgeComparison compared{entry.limit, {}, all.unknown(entry.limit.from, entry.limit.to)};
      bool any = false;
      for (const DataAge& age : all.known()) {
        if (!is_about(entry.limit, age)) continue;
        any = true;
        if (!has_own(entries, entry.limit, age)) compared.ages.push_back(age);
      }
      if (!any && compared.unknown.empty()) no_pair(entry);
      result.push_back(std::move(compared));
    }
    return result;
  }

 private:
  const DataAges& ages(const PathEnds& ends) {
    return ages_.try_emplace(ends, plan_, ends).first->second;
  }

  /// Whether an entry that says it more exactly limits the same paths.
  static bool has_own(const std::vector<Entry>& entries, const AgeLimit& limit,
                      const DataAge& age) {
    return ranges::any_of(entries, [&](const Entry& other) {
      return other.limit.ends == limit.ends && exactness(other.limit) > exactness(limit) &&
             is_about(other.limit, age);
    });
  }

  std::optional<Entry> read(const AgeBudgetSpec& item) {
    Entry entry;
    AgeLimit& limit = entry.limit;
    limit.at_most_s = item.at_most_s.value;
    limit.span = entry.name = item.at_most_s.span;
    limit.ends = usual_ends(graph_);
    bool good = true;
    if (item.to) {
      limit.to = item.to->value;
      limit.ends.to_observations = limit.to.starts_with("observations.");
      entry.name = item.to->span;
      good = check_end(*item.to, false, limit.ends.to_observations);
    }
    if (item.from) {
      limit.from = item.from->value;
      limit.ends.from_actions = limit.from.starts_with("actions.");
      entry.name = item.from->span;
      good = check_end(*item.from, true, limit.ends.from_actions) && good;
    }
    limit.ends.through_agent = !limit.ends.from_actions && (!item.agent || item.agent->value);
    if (good && item.agent && limit.ends.from_actions) {
      diagnostics_.error("E0208", item.agent->span, "`agent` does nothing for data of an action")
          .help = "leave it out: their paths never lead through the agent";
      good = false;
    }
    return good ? std::optional(std::move(entry)) : std::nullopt;
  }

  /// `environment`: an action, or an observation.
  bool check_end(const Spanned<std::string>& end, bool source, bool environment) {
    const auto known =
        source ? names_of_sources(graph_, environment) : names_of_destinations(graph_, environment);
    if (contains(known, end.value)) return true;
    auto& problem = diagnostics_.error(
        "E0424", end.span,
        fmt::format("there is no {} `{}`", source ? "sensor or action" : "actuator or observation",
                    end.value));
    const auto all = all_ends(source);
    const std::string near = nearest(end.value, all);
    if (contains(all_ends(!source), end.value)) {
      problem.help =
          source ? "data arrive there: write it as `to:`" : "data begin there: write it as `from:`";
    } else if (!near.empty()) {
      problem.help = meaning(near);
    } else {
      problem.help = all.empty() ? std::string("the graph has none")
                                 : fmt::format("available: {}", join(all, ", "));
    }
    return false;
  }

  std::vector<std::string> all_ends(bool sources) const {
    const auto names = sources ? names_of_sources : names_of_destinations;
    auto all = names(graph_, false);
    const auto more = names(graph_, true);
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  /// No data go where the entry says.
  void no_pair(const Entry& entry) {
    const AgeLimit& limit = entry.limit;
    const std::string from =
        limit.from.empty() ? kind_of_source(limit.ends) : "`" + limit.from + "`";
    const std::string to =
        limit.to.empty() ? kind_of_destination(limit.ends) : "`" + limit.to + "`";
    const PathEnds with_agent{limit.ends.from_actions, limit.ends.to_observations,
                              !limit.ends.from_actions};
    const auto& around = ages(with_agent).known();
    const bool through_agent =
        limit.ends != with_agent &&
        ranges::any_of(around, [&](const DataAge& age) { return is_about(limit, age); });
    const bool named = exactness(limit) > 0;
    auto& problem = named
                        ? diagnostics_.error("E0425", entry.name,
                                             fmt::format("no data of {} reach {}", from, to))
                        : diagnostics_.warning(
                              "W0120", entry.name,
                              fmt::format("this limits nothing: no data of {} reach {}", from, to));
    if (through_agent) {
      problem.help = "they do through the agent: leave out `agent: false`";
      return;
    }
    std::vector<std::string> reached;
    for (const DataAge& age : ages(limit.ends).known()) {
      if (!limit.from.empty() && age.from == limit.from) reached.push_back("`" + age.to + "`");
    }
    if (!reached.empty()) {
      problem.help = fmt::format("they reach {}", join(reached, ", "));
    } else if (limit.ends.from_actions && limit.ends.to_observations && graph_.has_engine()) {
      problem.help = "what is measured behind the engine is no longer data of an action";
    } else {
      problem.help = named ? "connect them, or leave out this entry" : "leave out `age`";
    }
  }

  const Plan& plan_;
  const Graph& graph_;
  Diagnostics& diagnostics_;
  std::map<PathEnds, DataAges> ages_;
};

}  // namespace

std::string nodes_on_path(const DataAge& age) {
  std::string text;
  for (std::size_t i = 0; i + 1 < age.path.size(); ++i) {
    const std::string& input = age.path[i].input;
    const std::string node = input.substr(0, input.find('.'));
    text += (i == 0 ? "" : ", ") + (node == "observations" ? "agent" : node);
  }
  return text;
}

std::vector<AgeComparison> compare_ages(const Plan& plan, const std::vector<AgeBudgetSpec>& ages,
                                        Diagnostics& diagnostics) {
  return AgeBudget(plan, diagnostics).run(ages);
}

}  // namespace eagerx::gen
