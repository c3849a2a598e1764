// The control flow graph of a function, and its loops.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "generator/analysis/bound/image.hpp"

namespace eagerx::gen::bound {

using BlockIndex = std::size_t;
using LoopIndex = std::size_t;
inline constexpr std::size_t kNone = static_cast<std::size_t>(-1);

struct Block {
  std::vector<const Instruction*> code;
  std::vector<BlockIndex> next;  // in the order: not taken, taken; or those of a table
  std::vector<BlockIndex> before;
  bool returns = false;    // it may end the function
  bool lost = false;       // where it leads is not known
  LoopIndex loop = kNone;  // the innermost one that it lies in
};

/// A natural loop; its header dominates it.
struct Loop {
  BlockIndex header = 0;
  LoopIndex parent = kNone;
  std::vector<bool> has;            // [blocks]
  std::vector<BlockIndex> order;    // its blocks, as in Flow::order
  std::vector<Address> addresses;   // of its instructions, in order
  std::vector<BlockIndex> latches;  // from which it goes back to its header
};

/// From an entry on, along branches: what another function jumps to is part of it, calls are not.
struct Flow {
  Address entry = 0;
  std::vector<Block> blocks;          // [0] is the entry
  std::vector<Loop> loops;            // outer ones first
  std::vector<BlockIndex> order;      // reverse postorder: without going back, first to last
  std::vector<BlockIndex> dominator;  // immediate ones; the entry's is itself
  std::vector<std::pair<BlockIndex, BlockIndex>>
      entered_elsewhere;  // edges into loops with several

  [[nodiscard]] bool dominates(BlockIndex above, BlockIndex below) const;
  [[nodiscard]] bool is_in(BlockIndex block, LoopIndex loop) const {
    return loop == kNone || loops[loop].has[block];
  }
  /// The blocks of a loop, or of the function.
  [[nodiscard]] const std::vector<BlockIndex>& order_in(LoopIndex loop) const {
    return loop == kNone ? order : loops[loop].order;
  }
  /// The loop directly in `outer` that has the block; kNone: it lies in `outer` itself.
  [[nodiscard]] LoopIndex child(LoopIndex outer, BlockIndex block) const;
};

/// `never_returns`: functions whose calls are the end of a path.
Flow flow_of(const Image& image, Address entry, const std::set<Address>& never_returns);
/// Whether a path from the entry comes to a return, or to where it cannot be followed.
bool may_return(const Image& image, Address entry, const std::set<Address>& never_returns);

}  // namespace eagerx::gen::bound
