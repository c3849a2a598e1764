// The longest path through a function: blocks weigh, loops multiply.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>

#include "generator/analysis/bound/analysis.hpp"
#include "generator/analysis/bound/cost.hpp"

namespace eagerx::gen::bound {

/// The weight of a function whose path is sought, and of those that it calls.
struct Weight {
  /// How much of a call's callee is.
  enum class Callee : std::uint8_t { nothing, by_weight, whole };
  /// Whether an instruction is. `is_first`: it is one of that function itself. Empty: all are.
  std::function<bool(const Instruction&, bool is_first)> counts;
  std::function<Callee(const Instruction& call, bool is_first)> callee;  // empty: whole
  /// Whether a callee that is `by_weight` has anything that counts. Empty: it may.
  std::function<bool(const Analysed&)> may_count = {};
  /// Loops of that function that count once: what is asked for is within a turn.
  std::set<LoopIndex> once = {};
  std::set<Address> never = {};            // headers of loops that are not entered, by a condition
  const Cost* cost = &instruction_cost();  // of what counts

  static Weight all(const Cost& cost = instruction_cost());
};

/// The longest path of a function, and why it is none.
struct Length {
  std::uint64_t most = 0;
  std::set<Obstacle> obstacles;
};
/// Those of functions by all that they have. With one cost.
using Wholes = std::map<const Analysed*, Length>;

/// The longest path by weight; its loops must have bounds only where something in them weighs.
class LongestPath {
 public:
  explicit LongestPath(Weight weight) : weight_(std::move(weight)), whole_(own_) {}
  /// `wholes`: kept from path to path.
  LongestPath(Weight weight, Wholes& wholes) : weight_(std::move(weight)), whole_(wholes) {}

  /// Only a bound if there are no obstacles().
  std::uint64_t of(const Analysed& function);
  [[nodiscard]] const std::set<Obstacle>& obstacles() const { return obstacles_; }

 private:
  using Edge = std::pair<BlockIndex, BlockIndex>;
  struct Part {
    std::optional<std::uint64_t> turn;     // the longest way from the header back to it
    std::map<Edge, std::uint64_t> leaves;  // to each exit
    std::uint64_t returns = 0;             // to a return
    bool weighs = false;
  };

  std::uint64_t length(const Analysed& function);
  Part part(const Analysed& function, LoopIndex loop);
  std::uint64_t block(const Analysed& function, BlockIndex b);
  [[nodiscard]] std::uint64_t jump(const Analysed& function, BlockIndex b, BlockIndex next) const;
  void leave(const Analysed& function, LoopIndex loop, Edge edge, std::uint64_t length, Part& part,
             std::map<BlockIndex, std::uint64_t>& open);
  Part turned(const Analysed& function, LoopIndex loop);
  std::uint64_t call(const Analysed& function, const Instruction& instruction);
  [[nodiscard]] bool counts(const Analysed& function, const Instruction& instruction) const {
    return !weight_.counts || weight_.counts(instruction, &function == first_);
  }

  Weight weight_;
  const Analysed* first_ = nullptr;
  Wholes own_;
  Wholes& whole_;
  std::map<const Analysed*, std::uint64_t> known_;
  std::set<Obstacle> obstacles_;
};

}  // namespace eagerx::gen::bound
