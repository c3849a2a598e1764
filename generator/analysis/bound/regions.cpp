#include "generator/analysis/bound/regions.hpp"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace eagerx::gen::bound {
namespace {

/// The function of the image that an instruction lies in.
Address function_at(const Image& image, Address at) {
  const auto after = image.functions().upper_bound(at);
  return after == image.functions().begin() ? at : std::prev(after)->first;
}

/// Whether a test in every turn, whether to continue, is other code: a loop of the region tests for
/// itself.
bool is_led_by_others(const Flow& flow, LoopIndex l, const std::set<Address>& code) {
  const Loop& loop = flow.loops[l];
  for (BlockIndex b = 0; b < flow.blocks.size(); ++b) {
    const Block& block = flow.blocks[b];
    if (block.loop != l || block.code.empty() || code.contains(block.code.back()->at)) continue;
    const bool may_leave =
        std::ranges::any_of(block.next, [&](BlockIndex next) { return !loop.has[next]; });
    const bool is_in_every_turn = std::ranges::all_of(
        loop.latches, [&](BlockIndex latch) { return flow.dominates(b, latch); });
    if (may_leave && is_in_every_turn) return true;
  }
  return false;
}

/// Whether an instruction is of a region: of the function that the region lies in, its code only.
class IsIn {
 public:
  explicit IsIn(const Region& region) : region_(region) {}
  bool operator()(const Instruction& i, bool is_first) const {
    return !is_first || region_.code.empty() || region_.code.contains(i.at);
  }

 private:
  const Region& region_;
};

}  // namespace

std::set<LoopIndex> loops_around(const Flow& flow, const std::set<Address>& code) {
  std::set<LoopIndex> around;
  for (LoopIndex l = 0; l < flow.loops.size(); ++l) {
    bool has_all = true;
    std::size_t own = 0, all = 0;
    for (BlockIndex b = 0; b < flow.blocks.size(); ++b) {
      const auto here = static_cast<std::size_t>(std::ranges::count_if(
          flow.blocks[b].code,
          [&](const Instruction* instruction) { return code.contains(instruction->at); }));
      if (!flow.loops[l].has[b]) {
        has_all &= here == 0;
        continue;
      }
      own += here;
      all += flow.blocks[b].code.size();
    }
    if (has_all || 2 * own < all || is_led_by_others(flow, l, code)) around.insert(l);
  }
  return around;
}

std::vector<Region> Regions::find(const IsNamed& is_named) const {
  std::vector<Places::Occurrence> all;
  for (std::uint32_t i = 0; i < places_.functions().size(); ++i) {
    if (!is_named(i)) continue;
    const auto& own = places_.occurrences()[i];
    all.insert(all.end(), own.begin(), own.end());
  }
  std::ranges::sort(all);
  // By the function and, where it is inlined, the files and lines of all its callers.
  using Lines = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  std::map<std::tuple<Address, bool, Lines>, Region> found;
  for (std::size_t n = 0; n < all.size(); ++n) {
    // The outermost one of an instruction.
    if (n + 1 < all.size() && all[n + 1].instruction == all[n].instruction) continue;
    const Instruction& instruction = analysis_.image().instructions()[all[n].instruction];
    const auto& frames = places_.of(instruction);
    const bool is_whole = all[n].frame + 1 == frames.size();
    const Address function = function_at(analysis_.image(), instruction.at);
    Lines callers;
    for (std::size_t k = all[n].frame + 1; k < frames.size(); ++k)
      callers.emplace_back(frames[k].file, frames[k].line);
    Region& region = found[{function, is_whole, std::move(callers)}];
    region.function = function;
    if (!is_whole) region.code.insert(region.code.end(), instruction.at);
  }
  std::vector<Region> regions;
  for (auto& [where, region] : found) regions.push_back(std::move(region));
  return regions;
}

/// The same for each node.
const std::set<LoopIndex>& Regions::around(const Flow& flow, const Region& region) {
  const auto [known, is_new] = around_.try_emplace({region.function, region.code});
  if (is_new) known->second = loops_around(flow, region.code);
  return known->second;
}

Regions::Most Regions::longest(const Region& region, Weight weight) {
  const Analysed& function = analysis_.of(region.function);
  if (!region.code.empty()) weight.once = around(*function.flow, region);
  weight.cost = &cost_;
  LongestPath path(std::move(weight), wholes_);
  const std::uint64_t most = path.of(function);
  return {most, path.obstacles()};
}

Regions::Most Regions::most(const std::vector<Region>& regions) {
  return most_without_calls(regions, {});
}

/// Of a function and all that it calls.
const std::set<std::uint32_t>& Regions::owners_in(const Analysed& function) {
  const auto [known, is_new] = owners_in_.try_emplace(&function);
  std::set<std::uint32_t>& owners = known->second;
  if (!is_new) return owners;
  for (const Block& block : function.flow->blocks) {
    for (const Instruction* instruction : block.code) owners.insert((*owners_)[instruction->index]);
  }
  for (const auto& [at, callee] : function.calls) {
    const std::set<std::uint32_t>& others = owners_in(*callee);
    owners.insert(others.begin(), others.end());
  }
  return owners;
}

Regions::Most Regions::most_of(const std::vector<Region>& regions, std::uint32_t owner) {
  Most result;
  for (const Region& region : regions) {
    if (!owners_in(analysis_.of(region.function)).contains(owner)) continue;
    const IsIn is_in(region);
    const auto counts = [&](const Instruction& i, bool is_first) {
      return (*owners_)[i.index] == owner && is_in(i, is_first);
    };
    Weight weight;
    weight.counts = counts;
    weight.callee = [&](const Instruction& call, bool is_first) {
      if (!is_in(call, is_first)) return Weight::Callee::nothing;
      return counts(call, is_first) ? Weight::Callee::whole : Weight::Callee::by_weight;
    };
    weight.may_count = [&](const Analysed& function) {
      return owners_in(function).contains(owner);
    };
    const Most one = longest(region, std::move(weight));
    result.most = std::max(result.most, one.most);
    result.obstacles.insert(one.obstacles.begin(), one.obstacles.end());
  }
  return result;
}

Regions::Most Regions::most_without_calls(const std::vector<Region>& regions,
                                          const std::set<Address>& functions,
                                          const std::set<Address>& loops) {
  const bool has_condition = !functions.empty() || !loops.empty();
  Most result;
  for (const Region& region : regions) {
    const IsIn is_in(region);
    Weight weight;
    weight.never = loops;
    weight.counts = is_in;
    weight.callee = [&](const Instruction& call, bool is_first) {
      const bool is_left_out = !is_in(call, is_first) || functions.contains(call.target);
      if (is_left_out) return Weight::Callee::nothing;
      return has_condition ? Weight::Callee::by_weight : Weight::Callee::whole;
    };
    const Most one = longest(region, std::move(weight));
    result.most = std::max(result.most, one.most);
    result.obstacles.insert(one.obstacles.begin(), one.obstacles.end());
  }
  return result;
}

Regions::Most Regions::most_without(const std::vector<Region>& regions,
                                    const std::vector<Region>& others,
                                    const std::set<Address>& kept) {
  std::set<Address> left_out, functions;
  for (const Region& other : others) {
    left_out.insert(other.code.begin(), other.code.end());
    if (other.code.empty()) functions.insert(other.function);
  }
  for (const Address at : kept) left_out.erase(at);
  Most result;
  for (const Region& region : regions) {
    Weight weight;
    const auto is_in = [&](const Instruction& i, bool is_first) {
      return !left_out.contains(i.at) &&
             (!is_first || region.code.empty() || region.code.contains(i.at));
    };
    weight.counts = is_in;
    weight.callee = [&](const Instruction& call, bool is_first) {
      if (!is_in(call, is_first) || functions.contains(call.target)) return Weight::Callee::nothing;
      return Weight::Callee::by_weight;
    };
    const Most one = longest(region, std::move(weight));
    result.most = std::max(result.most, one.most);
    result.obstacles.insert(one.obstacles.begin(), one.obstacles.end());
  }
  return result;
}

}  // namespace eagerx::gen::bound
