#include "generator/emit/schedule_view.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/emit/reset_view.hpp"

namespace eagerx::gen {
namespace {

class ScheduleView {
 public:
  ScheduleView(const Plan& plan, const ProgramNames& names) : plan_(plan), names_(names) {}

  void add(View& view) const {
    const Schedule& schedule = plan_.schedule;
    const bool constants = schedule.form == ScheduleForm::constants;
    const bool table = schedule.form == ScheduleForm::table;
    view.set("is_constants", constants);
    view.set("is_table", table);
    view.set("is_countdown", schedule.form == ScheduleForm::countdown);
    const bool dispatch = table && is_dispatched();
    view.set("is_dispatch", dispatch);
    view.set("is_runtime", !constants && !dispatch);
    view.set("schedule",
             constants
                 ? (schedule.masks.size() == 1
                        ? std::string("a step is one slot")
                        : fmt::format("a step is {} slots, written out", schedule.masks.size()))
                 : (table ? fmt::format("the {} slots of the hyperperiod are a table of {}",
                                        schedule.masks.size(),
                                        dispatch ? "which of them are alike" : "masks")
                          : std::string("the next slot is found by a countdown of every rate")));
    view.set("all", constants || dispatch ? constant(schedule.masks.front()) : "");
    view.set("observed", constants || dispatch ? constant(schedule.masks.front()) : "due_");
    add_runs(view, constants, dispatch);
    add_table(view, table, dispatch);
    add_kinds(view, dispatch);
    std::vector<std::string> periods;
    for (const auto& rate : plan_.rates) periods.push_back(fmt::format("{}", rate.period));
    view.set("periods", "{" + joined(periods) + "}");
  }

 private:
  std::string mask_names(std::uint64_t mask) const {
    std::vector<std::string> bits;
    for (std::size_t r = 0; r < plan_.rates.size(); ++r) {
      if ((mask >> r & 1U) != 0) bits.push_back(names_.due[r]);
    }
    return fmt::format("{}", fmt::join(bits, " | "));
  }
  std::string constant(std::uint64_t mask) const {
    return fmt::format("eagerx::Constant<{}>{{}}", mask_names(mask));
  }

  /// The slots after the environment's own, equal neighbours as one loop.
  void add_runs(View& view, bool constants, bool dispatch) const {
    View runs = list();
    const auto& masks = plan_.schedule.masks;
    for (std::size_t i = 1; constants && i < masks.size();) {
      std::size_t end = i;
      while (end < masks.size() && masks[end] == masks[i]) ++end;
      View run = object();
      run.set("due", constant(masks[i]));
      run.set("once", end - i == 1);
      run.set("loop", end - i > 1);
      run.set("count", fmt::format("{}", end - i));
      runs.push_back(run);
      i = end;
    }
    view.set("has_slot", dispatch || (constants && masks.size() > 1));
    view["runs"] = std::move(runs);
  }

  /// A step that is no hyperperiod may begin at any of its slots. With few kinds of slots each has
  /// a specialisation all the same, chosen at run time: 45 instructions a slot on a Cortex-M4F
  /// besides the callbacks, instead of 73 with masks (tests/bench/scheduler). A routine of reset
  /// nodes takes masks.
  bool is_dispatched() const {
    constexpr std::size_t kMostSpecialisations = 600;  // nodes times kinds: text and compile time
    constexpr std::size_t kMostKinds = 32;
    const std::size_t kinds = kinds_of_slots().size();
    return !plan_.graph->has_reset_nodes() && !plan_.graph->asynchronous && kinds <= kMostKinds &&
           kinds * plan_.graph->nodes.size() <= kMostSpecialisations;
  }

  /// The distinct masks; the first is that of an episode's beginning, when everything is due.
  std::vector<std::uint64_t> kinds_of_slots() const {
    std::vector<std::uint64_t> kinds;
    for (const std::uint64_t mask : plan_.schedule.masks) {
      if (std::find(kinds.begin(), kinds.end(), mask) == kinds.end()) kinds.push_back(mask);
    }
    return kinds;
  }

  void add_kinds(View& view, bool dispatch) const {
    View kinds = list();
    const auto masks = dispatch ? kinds_of_slots() : std::vector<std::uint64_t>{};
    const std::uint64_t environment = std::uint64_t{1} << plan_.nodes[Graph::kEnvironment].rate;
    for (std::size_t i = 0; i < masks.size(); ++i) {
      View kind = object();
      kind.set("index", fmt::format("{}", i));
      kind.set("due", constant(masks[i]));
      kind.set("observes", (masks[i] & environment) != 0);
      kind.set("passes", (masks[i] & environment) == 0);
      kinds.push_back(kind);
    }
    view["kinds"] = std::move(kinds);
  }

  void add_table(View& view, bool table, bool dispatch) const {
    auto masks = plan_.schedule.masks;
    const std::size_t bits = dispatch ? 1 : plan_.rates.size();
    view.set("mask_type", bits <= 8
                              ? "std::uint8_t"
                              : (bits <= 16 ? "std::uint16_t"
                                            : (bits <= 32 ? "std::uint32_t" : "std::uint64_t")));
    view.set("slots", fmt::format("{}", masks.size()));
    if (dispatch) {
      const auto kinds = kinds_of_slots();
      for (auto& mask : masks)
        mask =
            static_cast<std::uint64_t>(std::find(kinds.begin(), kinds.end(), mask) - kinds.begin());
    }
    view.set("table_of",
             dispatch ? "The kind of every slot" : "The rates that are due, slot by slot");
    View lines = list();
    constexpr std::size_t kInLine = 16;
    for (std::size_t i = 0; table && i < masks.size(); i += kInLine) {
      std::string text;
      for (std::size_t k = i; k < std::min(i + kInLine, masks.size()); ++k)
        text += fmt::format("{}{},", k == i ? "" : " ", masks[k]);
      View line = object();
      line.set("line", text);
      lines.push_back(line);
    }
    view["mask_lines"] = std::move(lines);
  }

  const Plan& plan_;
  const ProgramNames& names_;
};

}  // namespace

void add_schedule(const Plan& plan, const ProgramNames& names, View& view) {
  ScheduleView(plan, names).add(view);
}

}  // namespace eagerx::gen
