#include "generator/analysis/bound/flow.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <string_view>

namespace eagerx::gen::bound {
namespace {

/// The last entry of a table, by the comparison before a jump through it: `cmp r3, #4`, `bhi`,
/// `tbb [pc, r3]`. Without one: as many as there can be.
Address last_entry(const Image& image, const Instruction& jump) {
  constexpr std::uint32_t kFar = 12;
  constexpr Address kAny = 0xffff;
  if (jump.operands.empty()) return kAny;
  const std::string_view text = jump.operands[0];
  const auto begin = std::min(text.find(", ") + 2, text.size());
  const std::string_view index = text.substr(begin, text.find_first_of(",]", begin) - begin);
  bool is_checked = false;
  for (std::uint32_t i = 1; i <= kFar && i <= jump.index; ++i) {
    const Instruction& before = image.instructions()[jump.index - i];
    is_checked |= before.name == "b" && before.condition == Condition::hi;
    if (before.operands.empty() || before.operands[0] != index) continue;
    if (before.name != "cmp" || !is_checked || before.operands.size() != 2) return kAny;
    return static_cast<Address>(std::strtoul(before.operands[1].c_str() + 1, nullptr, 10));
  }
  return kAny;
}

/// The entries of tbb and tbh lie behind them, as halves of offsets. Where their number is not
/// known: up to the first that leads to no instruction, or lies behind where one leads.
std::vector<Address> table_targets(const Image& image, const Instruction& instruction) {
  const bool is_byte = instruction.name == "tbb";
  const unsigned size = is_byte ? 1 : 2;
  const Address begin = instruction.at + 4;
  const Address last = begin + last_entry(image, instruction) * size;
  std::vector<Address> targets;
  Address least = static_cast<Address>(-1);
  for (Address at = begin; at < least && at <= last; at += size) {
    const auto entry = image.constant(at, size);
    if (!entry || image.instruction(at) != nullptr) break;
    const Address target = begin + 2 * *entry;
    if (target < at || image.instruction(target) == nullptr) break;
    least = std::min(least, target);
    targets.push_back(target);
  }
  return targets;
}

class Builder {
 public:
  Builder(const Image& image, Flow& flow, const std::set<Address>& never_returns)
      : image_(image), flow_(flow), never_returns_(never_returns) {}

  [[nodiscard]] bool may_return() const {
    std::vector<Address> open = {flow_.entry};
    std::vector<bool> seen(image_.instructions().size());
    while (!open.empty()) {
      Address at = open.back();
      open.pop_back();
      for (;;) {
        const Instruction* i = image_.instruction(at);
        if (i == nullptr) return true;
        if (seen[i->index]) break;
        seen[i->index] = true;
        const Exit exit = exit_of(*i);
        if (exit.returns || exit.lost) return true;
        open.insert(open.end(), exit.targets.begin(), exit.targets.end());
        if (!exit.falls) break;
        at = i->next;
      }
    }
    return false;
  }

  void build() {
    find_starts();
    std::map<Address, BlockIndex> index;
    add_block(index, flow_.entry);
    for (const Address start : starts_) add_block(index, start);
    for (const auto& [start, block] : index) fill(block, start, index);
    for (BlockIndex b = 0; b < flow_.blocks.size(); ++b) {
      for (const BlockIndex n : flow_.blocks[b].next) flow_.blocks[n].before.push_back(b);
    }
  }

 private:
  struct Exit {
    std::vector<Address> targets;
    bool falls = false, returns = false, lost = false, ends = false;
  };

  void add_block(std::map<Address, BlockIndex>& index, Address start) {
    if (index.emplace(start, flow_.blocks.size()).second) flow_.blocks.emplace_back();
  }

  Exit exit_of(const Instruction& instruction) const {
    const bool is_conditional = instruction.is_conditional();
    Exit exit;
    switch (instruction.turn) {
      case Turn::none:
      case Turn::call_pointer:
        exit.falls = true;
        return exit;
      case Turn::call:
        exit.falls = is_conditional || !never_returns_.contains(instruction.target);
        exit.ends = !exit.falls;
        return exit;
      case Turn::branch:
        exit.targets = {instruction.target};
        exit.falls = is_conditional || instruction.name.starts_with("cb");
        exit.lost = image_.instruction(instruction.target) == nullptr;
        if (exit.lost) exit.targets.clear();
        break;
      case Turn::back:
        exit.returns = true;
        exit.falls = is_conditional;
        break;
      case Turn::table:
        exit.targets = table_targets(image_, instruction);
        exit.lost = exit.targets.empty();
        break;
      case Turn::halt:
        break;
      case Turn::unknown:
        exit.lost = true;
        break;
    }
    exit.ends = true;
    return exit;
  }

  /// All addresses at which blocks begin.
  void find_starts() {
    std::vector<Address> open = {flow_.entry};
    std::vector<bool> seen(image_.instructions().size());
    while (!open.empty()) {
      Address at = open.back();
      open.pop_back();
      for (const Instruction* i = image_.instruction(at); i != nullptr && !seen[i->index];
           i = image_.instruction(at)) {
        seen[i->index] = true;
        const Exit exit = exit_of(*i);
        for (const Address target : exit.targets) {
          starts_.insert(target);
          open.push_back(target);
        }
        at = i->next;
        if (!exit.falls) break;
        if (exit.ends) starts_.insert(at);
      }
    }
  }

  void fill(BlockIndex block, Address at, const std::map<Address, BlockIndex>& index) {
    Block& filled = flow_.blocks[block];
    while (const Instruction* instruction = image_.instruction(at)) {
      filled.code.push_back(instruction);
      const Exit exit = exit_of(*instruction);
      filled.returns = exit.returns;
      filled.lost = exit.lost;
      at = instruction->next;
      const auto next = index.find(at);
      if (exit.falls && next != index.end()) filled.next.push_back(next->second);
      for (const Address target : exit.targets) {
        const BlockIndex to = index.at(target);
        if (std::ranges::find(filled.next, to) == filled.next.end() || !exit.falls)
          filled.next.push_back(to);
      }
      if (!exit.falls || exit.ends || next != index.end()) return;
    }
    filled.lost = true;  // it runs into data
  }

  const Image& image_;
  Flow& flow_;
  const std::set<Address>& never_returns_;
  std::set<Address> starts_;
};

/// Reverse postorder, and dominators after Cooper, Harvey and Kennedy, "A Simple, Fast Dominance
/// Algorithm" (2001).
class Dominance {
 public:
  explicit Dominance(Flow& flow) : flow_(flow), number_(flow.blocks.size(), kNone) {}

  void find() {
    visit_all();
    flow_.dominator.assign(flow_.blocks.size(), kNone);
    flow_.dominator[0] = 0;
    for (bool changed = true; changed;) {
      changed = false;
      for (const BlockIndex block : flow_.order) changed |= block != 0 && update(block);
    }
  }

 private:
  void visit_all() {
    std::vector<std::pair<BlockIndex, std::size_t>> stack = {{0, 0}};
    std::vector<bool> seen(flow_.blocks.size());
    seen[0] = true;
    while (!stack.empty()) {
      auto& [block, next] = stack.back();
      if (next == flow_.blocks[block].next.size()) {
        flow_.order.push_back(block);
        stack.pop_back();
        continue;
      }
      const BlockIndex to = flow_.blocks[block].next[next++];
      if (!seen[to]) stack.emplace_back(to, 0);
      seen[to] = true;
    }
    std::ranges::reverse(flow_.order);
    for (std::size_t i = 0; i < flow_.order.size(); ++i) number_[flow_.order[i]] = i;
  }

  bool update(BlockIndex block) {
    BlockIndex found = kNone;
    for (const BlockIndex before : flow_.blocks[block].before) {
      if (number_[before] == kNone || flow_.dominator[before] == kNone) continue;
      found = found == kNone ? before : common(found, before);
    }
    const bool changed = flow_.dominator[block] != found;
    flow_.dominator[block] = found;
    return changed;
  }

  BlockIndex common(BlockIndex a, BlockIndex b) const {
    while (a != b) {
      while (number_[a] > number_[b]) a = flow_.dominator[a];
      while (number_[b] > number_[a]) b = flow_.dominator[b];
    }
    return a;
  }

  Flow& flow_;
  std::vector<std::size_t> number_;
};

/// All blocks from which a latch is reached without the header.
void grow(const Flow& flow, Loop& loop) {
  std::vector<BlockIndex> open = loop.latches;
  loop.has.assign(flow.blocks.size(), false);
  loop.has[loop.header] = true;
  while (!open.empty()) {
    const BlockIndex block = open.back();
    open.pop_back();
    if (loop.has[block]) continue;
    loop.has[block] = true;
    for (const BlockIndex before : flow.blocks[block].before) open.push_back(before);
  }
}

void list_code(const Flow& flow, Loop& loop) {
  std::ranges::copy_if(flow.order, std::back_inserter(loop.order),
                       [&](BlockIndex block) { return loop.has[block]; });
  for (BlockIndex b = 0; b < flow.blocks.size(); ++b) {
    if (!loop.has[b]) continue;
    for (const Instruction* instruction : flow.blocks[b].code)
      loop.addresses.push_back(instruction->at);
  }
  std::ranges::sort(loop.addresses);
}

void find_loops(Flow& flow) {
  std::vector<std::size_t> number(flow.blocks.size(), kNone);
  for (std::size_t i = 0; i < flow.order.size(); ++i) number[flow.order[i]] = i;
  for (const BlockIndex header : flow.order) {
    Loop loop;
    loop.header = header;
    for (const BlockIndex before : flow.blocks[header].before) {
      if (number[before] == kNone || number[before] < number[header]) continue;
      if (flow.dominates(header, before))
        loop.latches.push_back(before);
      else
        flow.entered_elsewhere.emplace_back(before, header);
    }
    if (loop.latches.empty()) continue;
    grow(flow, loop);
    list_code(flow, loop);
    flow.loops.push_back(std::move(loop));
  }
  // Headers come in their order, so an outer loop comes before those in it.
  for (LoopIndex l = 0; l < flow.loops.size(); ++l) {
    for (LoopIndex outer = 0; outer < l; ++outer) {
      if (flow.loops[outer].has[flow.loops[l].header]) flow.loops[l].parent = outer;
    }
    for (BlockIndex b = 0; b < flow.blocks.size(); ++b) {
      if (flow.loops[l].has[b]) flow.blocks[b].loop = l;
    }
  }
}

}  // namespace

bool Flow::dominates(BlockIndex above, BlockIndex below) const {
  while (below != above && below != 0 && dominator[below] != kNone) below = dominator[below];
  return below == above;
}

LoopIndex Flow::child(LoopIndex outer, BlockIndex block) const {
  LoopIndex loop = blocks[block].loop;
  if (loop == outer) return kNone;
  while (loop != kNone && loops[loop].parent != outer) loop = loops[loop].parent;
  return loop;
}

Flow flow_of(const Image& image, Address entry, const std::set<Address>& never_returns) {
  Flow flow;
  flow.entry = entry;
  Builder(image, flow, never_returns).build();
  Dominance(flow).find();
  find_loops(flow);
  return flow;
}

bool may_return(const Image& image, Address entry, const std::set<Address>& never_returns) {
  Flow flow;
  flow.entry = entry;
  return Builder(image, flow, never_returns).may_return();
}

}  // namespace eagerx::gen::bound
