// The parts of a program in its image: whole functions, or what the compiler inlined of them.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "generator/analysis/bound/path.hpp"
#include "generator/analysis/bound/places.hpp"

namespace eagerx::gen::bound {

/// A function of the program, once: where it was inlined, or on its own.
struct Region {
  Address function = 0;    // the function that it lies in
  std::set<Address> code;  // empty: all of that function
};

/// Loops that a region is within one turn of: they have all of it, are mostly other code (some of
/// the region's was moved out of them), or other code decides whether they continue.
std::set<LoopIndex> loops_around(const Flow& flow, const std::set<Address>& code);

/// Whether a function of Places::functions() is that of the part that is looked for.
using IsNamed = std::function<bool(std::uint32_t function)>;

class Regions {
 public:
  Regions(Analysis& analysis, const Places& places, const Cost& cost = instruction_cost())
      : analysis_(analysis), places_(places), cost_(cost) {}

  [[nodiscard]] std::vector<Region> find(const IsNamed& is_named) const;
  /// The most that one of the regions takes.
  using Most = Length;
  Most most(const std::vector<Region>& regions);
  /// [instructions] whose each is, as a number.
  void set_owners(const std::vector<std::uint32_t>& owners) { owners_ = &owners; }
  /// The most that one of the regions takes of the instructions of an owner, with what they call.
  Most most_of(const std::vector<Region>& regions, std::uint32_t owner);
  /// The same, all counted, where these functions are not called and these loops not entered.
  Most most_without_calls(const std::vector<Region>& regions, const std::set<Address>& functions,
                          const std::set<Address>& loops = {});
  /// The same without what is in `others`, but with what is in `kept`.
  Most most_without(const std::vector<Region>& regions, const std::vector<Region>& others,
                    const std::set<Address>& kept);

 private:
  Most longest(const Region& region, Weight weight);
  const std::set<std::uint32_t>& owners_in(const Analysed& function);
  const std::set<LoopIndex>& around(const Flow& flow, const Region& region);

  Analysis& analysis_;
  const Places& places_;
  const Cost& cost_;
  Wholes wholes_;
  const std::vector<std::uint32_t>* owners_ = nullptr;
  std::map<const Analysed*, std::set<std::uint32_t>> owners_in_;
  std::map<std::pair<Address, std::set<Address>>, std::set<LoopIndex>> around_;
};

}  // namespace eagerx::gen::bound
