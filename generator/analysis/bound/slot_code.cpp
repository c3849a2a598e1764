#include "generator/analysis/bound/slot_code.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <unordered_map>

namespace eagerx::gen::bound {
namespace {

using Due = std::optional<std::uint64_t>;

/// The kinds that lines of the program name for instructions and whole functions.
class Owners {
 public:
  explicit Owners(const std::vector<SlotCode>& slots) {
    for (const SlotCode& slot : slots) {
      for (const Region& region : slot.regions) {
        for (const Address at : region.code) code_[at] = slot.due;
        if (!region.code.empty()) mixed_.insert(region.function);
      }
    }
  }
  /// Functions that have more than one half of one slot, perhaps.
  [[nodiscard]] const std::set<Address>& mixed() const { return mixed_; }
  /// nullptr: it is of no slot.
  [[nodiscard]] const Due* of(const Instruction& instruction) const {
    const auto found = code_.find(instruction.at);
    return found == code_.end() ? nullptr : &found->second;
  }

 private:
  std::unordered_map<Address, Due> code_;
  std::set<Address> mixed_;
};

class SharedCode {
 public:
  SharedCode(const Flow& flow, const Owners& owners) : flow_(flow), owners_(owners) {}

  /// Adds what other kinds have of the blocks that a kind's code lies in, and of those where it
  /// continues at once.
  void extend(Region& region, const Due& kind) const {
    std::vector<bool> seen(flow_.blocks.size());
    std::vector<BlockIndex> open;
    for (BlockIndex b = 0; b < flow_.blocks.size(); ++b) {
      seen[b] = has_any(flow_.blocks[b], region.code);
      if (seen[b]) open.push_back(b);
    }
    while (!open.empty()) {
      const Block& block = flow_.blocks[open.back()];
      open.pop_back();
      for (const Instruction* instruction : block.code) {
        const Due* owner = owners_.of(*instruction);
        if (owner != nullptr && *owner != kind) region.code.insert(instruction->at);
      }
      if (!region.code.contains(block.code.back()->at)) continue;
      for (const BlockIndex next : block.next) {
        const auto& after = flow_.blocks[next].code;
        const Due* owner = after.empty() ? nullptr : owners_.of(*after.front());
        if (seen[next] || owner == nullptr || *owner == kind) continue;
        seen[next] = true;
        open.push_back(next);
      }
    }
  }

  /// What lies before the choice among kinds.
  void add_moved_up(std::set<Address>& to) const {
    for (BlockIndex b = 0; b < flow_.blocks.size(); ++b) {
      if (!is_moved_up(b)) continue;
      for (const Instruction* instruction : flow_.blocks[b].code) to.insert(instruction->at);
    }
  }

  /// What compilers moved out of the loops in which the rest of a region is: no calls and no
  /// branches, which are in a copy of the region, run when its kind is due.
  void add_moved_out(const Region& region, const std::set<LoopIndex>& loops,
                     std::set<Address>& to) const {
    for (const LoopIndex l : loops) {
      if (!has_any_of(l, region.code)) continue;
      for (BlockIndex b = 0; b < flow_.blocks.size(); ++b) {
        if (flow_.loops[l].has[b] || turns_in(b, region.code)) continue;
        for (const Instruction* instruction : flow_.blocks[b].code) {
          if (region.code.contains(instruction->at)) to.insert(instruction->at);
        }
      }
    }
  }

 private:
  /// Whether these instructions call or branch in a block.
  [[nodiscard]] bool turns_in(BlockIndex b, const std::set<Address>& code) const {
    return std::ranges::any_of(flow_.blocks[b].code, [&](const Instruction* instruction) {
      return instruction->turn != Turn::none && code.contains(instruction->at);
    });
  }

  [[nodiscard]] static bool has_any(const Block& block, const std::set<Address>& code) {
    return std::ranges::any_of(
        block.code, [&](const Instruction* instruction) { return code.contains(instruction->at); });
  }
  [[nodiscard]] bool has_any_of(LoopIndex loop, const std::set<Address>& code) const {
    for (BlockIndex b = 0; b < flow_.blocks.size(); ++b) {
      if (flow_.loops[loop].has[b] && has_any(flow_.blocks[b], code)) return true;
    }
    return false;
  }

  [[nodiscard]] const Due* first(BlockIndex b) const {
    for (const Instruction* instruction : flow_.blocks[b].code) {
      if (const Due* kind = owners_.of(*instruction)) return kind;
    }
    return nullptr;
  }

  /// Whether it is of one kind, and the choice among several follows.
  [[nodiscard]] bool is_moved_up(BlockIndex b) const {
    const Due* own = first(b);
    if (own == nullptr) return false;
    std::set<Due> chosen;
    std::set<BlockIndex> seen;
    std::vector<BlockIndex> open(flow_.blocks[b].next);
    while (!open.empty()) {
      const BlockIndex next = open.back();
      open.pop_back();
      if (is_header(next) || !seen.insert(next).second) continue;
      if (const Due* kind = first(next))
        chosen.insert(*kind);
      else
        open.insert(open.end(), flow_.blocks[next].next.begin(), flow_.blocks[next].next.end());
    }
    const std::size_t others = chosen.size() - chosen.count(*own);
    return others > 1 || (others == 1 && chosen.contains(*own));
  }

  [[nodiscard]] bool is_header(BlockIndex b) const {
    return std::ranges::any_of(flow_.loops, [b](const Loop& loop) { return loop.header == b; });
  }

  const Flow& flow_;
  const Owners& owners_;
};

/// A half that only some kinds have as a function of its own may be the same function for others.
void share_functions(std::vector<SlotCode>& slots, bool is_after) {
  std::vector<Region> functions;
  for (const SlotCode& slot : slots) {
    if (slot.is_after != is_after) continue;
    std::ranges::copy_if(slot.regions, std::back_inserter(functions),
                         [](const Region& region) { return region.code.empty(); });
  }
  for (SlotCode& slot : slots) {
    if (slot.is_after == is_after && slot.regions.empty()) slot.regions = functions;
  }
}

}  // namespace

std::set<Address> share(Analysis& analysis, std::vector<SlotCode>& slots) {
  share_functions(slots, false);
  share_functions(slots, true);
  const Owners owners(slots);
  std::set<Address> of_all;
  for (const Address function : owners.mixed())
    SharedCode(*analysis.of(function).flow, owners).add_moved_up(of_all);
  for (SlotCode& slot : slots) {
    for (Region& region : slot.regions) {
      if (region.code.empty()) continue;
      const Flow& flow = *analysis.of(region.function).flow;
      const SharedCode shared(flow, owners);
      shared.add_moved_out(region, loops_around(flow, region.code), of_all);
      shared.extend(region, slot.due);
    }
  }
  return of_all;
}

}  // namespace eagerx::gen::bound
