#include "generator/analysis/bound/slot_code.hpp"

#include <algorithm>
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
        if (region.code.empty()) functions_[region.function] = slot.due;
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
  /// Of the function that it calls or jumps to.
  [[nodiscard]] const Due* of_callee(const Instruction& instruction) const {
    const auto found = functions_.find(instruction.target);
    return instruction.target == 0 || found == functions_.end() ? nullptr : &found->second;
  }

 private:
  std::unordered_map<Address, Due> code_;
  std::map<Address, Due> functions_;
  std::set<Address> mixed_;
};

bool differ(const Due* a, const Due* b) {
  return a != nullptr && b != nullptr && *a != *b;
}

class SharedCode {
 public:
  SharedCode(const Flow& flow, const Owners& owners) : flow_(flow), owners_(owners) {}

  [[nodiscard]] bool any() const {
    for (BlockIndex b = 0; b < flow_.blocks.size(); ++b) {
      if (is_mixed(flow_.blocks[b]) || is_joined(b) || is_moved_up(b)) return true;
    }
    return false;
  }

 private:
  [[nodiscard]] const Due* first(BlockIndex b) const {
    for (const Instruction* instruction : flow_.blocks[b].code) {
      if (const Due* kind = owners_.of(*instruction)) return kind;
    }
    return nullptr;
  }

  [[nodiscard]] bool is_mixed(const Block& block) const {
    const Due* before = nullptr;
    for (const Instruction* instruction : block.code) {
      const Due* here = owners_.of(*instruction);
      if (differ(before, here) || differ(here, owners_.of_callee(*instruction))) return true;
      if (here != nullptr) before = here;
    }
    return false;
  }

  /// Whether it continues at once in another kind's code.
  [[nodiscard]] bool is_joined(BlockIndex b) const {
    const auto& code = flow_.blocks[b].code;
    if (code.empty()) return false;
    return std::ranges::any_of(flow_.blocks[b].next, [&](BlockIndex next) {
      const auto& after = flow_.blocks[next].code;
      return !after.empty() && differ(owners_.of(*code.back()), owners_.of(*after.front()));
    });
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
bool may_share_function(const std::vector<SlotCode>& slots, bool is_after) {
  bool has_function = false, has_none = false;
  for (const SlotCode& slot : slots) {
    if (slot.is_after != is_after) continue;
    has_none |= slot.regions.empty();
    has_function |=
        std::ranges::any_of(slot.regions, [](const Region& region) { return region.code.empty(); });
  }
  return has_function && has_none;
}

}  // namespace

bool is_shared(Analysis& analysis, const std::vector<SlotCode>& slots) {
  if (may_share_function(slots, false) || may_share_function(slots, true)) return true;
  const Owners owners(slots);
  return std::ranges::any_of(owners.mixed(), [&](Address function) {
    return SharedCode(*analysis.of(function).flow, owners).any();
  });
}

}  // namespace eagerx::gen::bound
