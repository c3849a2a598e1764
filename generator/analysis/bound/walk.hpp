// Goes over a function's blocks, inner loops before what follows them, with what is known of
// values.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "generator/analysis/bound/analysis.hpp"
#include "generator/analysis/bound/trips.hpp"

namespace eagerx::gen::bound {

using Edge = std::pair<BlockIndex, BlockIndex>;

/// Locations in order, in one block of memory: sets of them are made for each pass.
class Locations {
 public:
  Locations() = default;
  explicit Locations(const Location& one) : all_{one} {}
  void insert(const Location& one) {
    const auto at = std::ranges::lower_bound(all_, one);
    if (at == all_.end() || *at != one) all_.insert(at, one);
  }
  [[nodiscard]] bool contains(const Location& one) const {
    return std::ranges::binary_search(all_, one);
  }
  [[nodiscard]] auto begin() const { return all_.begin(); }
  [[nodiscard]] auto end() const { return all_.end(); }

 private:
  std::vector<Location> all_;
};

/// Calls are analysed, and results are written, in `record` mode only: once for each block.
class Walk {
 public:
  Walk(Analysis& analysis, const Flow& flow, Analysed& result)
      : analysis_(analysis), image_(analysis.image_), flow_(flow), result_(result) {}

  void function(const State& entry);

 private:
  /// Results of one pass over a loop, or the function.
  struct Pass {
    std::optional<State> latch;   // at its end, before it goes back to the header
    std::map<Edge, State> exits;  // that leave it
    std::map<BlockIndex, Comparison> tests;
    // Whether the way is known at one of the branches that leave; whether it is not known at one.
    bool decides = false, hesitates = false;
  };
  /// Changes of the places that a loop writes.
  struct Changes {
    Locations fixed;
    FlatMap<Location, Value> steps;
  };
  /// What a loop changes if nothing is known of values.
  struct FirstTrial {
    Changes found;
    bool turns_back = false;
    unsigned unbounded = 0;  // loops in it without a number of turns
    // What it depends on.
    State header;
    bool is_in_turns = false;
    unsigned escapes = 0;
    [[nodiscard]] bool is_of(const State& other) const;
  };

  Pass pass(LoopIndex loop, const State& header, bool record);
  void block(LoopIndex loop, BlockIndex b, State&& state, bool record, Pass& to,
             std::map<BlockIndex, State>& open);
  void deliver(LoopIndex loop, Edge edge, State&& state, bool record, Pass& to,
               std::map<BlockIndex, State>& open);
  struct Branch {
    Condition condition = Condition::always;  // when it is taken
    Comparison comparison;
    std::optional<bool> is_taken;
  };
  static std::optional<Branch> branch_of(const Block& block, const State& state);

  /// What a loop's header has in all turns.
  struct Enumerated {
    std::optional<Turns> count;       // until it leaves; nullopt: that is not known
    FlatMap<Location, Value> ranges;  // of numbers that are known in each of these turns
  };
  using Counts = std::map<LoopIndex, std::optional<std::uint64_t>>;
  Enumerated one_by_one(LoopIndex l, const State& in, std::optional<Turns> known);
  static void widen(FlatMap<Location, Value>& ranges, const State& header, bool is_first);
  Pass trial(LoopIndex l, const State& header);
  FirstTrial first_trial(LoopIndex l, const State& in);
  std::map<Edge, State> loop(LoopIndex l, const State& in, bool record);
  void count_inner(LoopIndex l, bool record, std::optional<Turns>& count);
  State open_header(LoopIndex l, const State& in, const Locations& fixed);
  /// [location] another one, from which it stays as far as it is at first.
  using Ties = FlatMap<Location, Location>;
  void tie(LoopIndex l, const State& in, const Ties& ties, State& header) const;
  [[nodiscard]] Ties likely_ties(const State& in, const Locations& fixed) const;
  [[nodiscard]] static Ties kept_ties(const Ties& ties, const State& in, const State& latch);
  [[nodiscard]] static bool hold(const Ties& ties, const State& in, const State& latch);
  void forget_limits(LoopIndex l, State& state) const;
  [[nodiscard]] bool separates(LoopIndex l, const std::set<BlockIndex>& tests) const;
  [[nodiscard]] Changes changes(LoopIndex l, const State& in, const State& header,
                                const State& latch, const Locations& fixed) const;
  std::optional<Turns> turns(LoopIndex l, const State& in, const Pass& pass,
                             const Changes& changes);
  [[nodiscard]] std::optional<Progress> progress(LoopIndex l, const State& in,
                                                 const Changes& changes, const Value& value) const;
  [[nodiscard]] bool is_made_in(LoopIndex l, Base base) const;
  [[nodiscard]] std::optional<std::uint64_t> noted(LoopIndex l) const;
  [[nodiscard]] std::optional<std::uint64_t> of_library(LoopIndex l) const;
  State running_header(LoopIndex l, const State& in, const Changes& changes, const Ties& ties,
                       const Enumerated& turns, bool last);
  [[nodiscard]] Address address(BlockIndex b) const {
    return flow_.blocks[b].code.empty() ? 0 : flow_.blocks[b].code.front()->at;
  }

  Analysis& analysis_;
  const Image& image_;
  const Flow& flow_;
  Analysed& result_;
  std::map<LoopIndex, std::pair<std::int64_t, bool>> escapes_;  // of a loop: what escapes in it
  unsigned escape_changes_ = 0;
  std::map<LoopIndex, std::vector<FirstTrial>> first_trials_;
  State entry_;
  unsigned depth_ = 0;      // of loops that are gone through one by one
  unsigned trials_ = 0;     // of passes that are trials
  Counts inner_;            // of loops in a loop that was, in each of its turns
  unsigned unbounded_ = 0;  // loops without a number of turns so far
};

}  // namespace eagerx::gen::bound
