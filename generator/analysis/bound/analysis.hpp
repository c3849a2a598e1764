// Which paths of a function are possible, and how often its loops turn.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "generator/analysis/bound/flow.hpp"
#include "generator/analysis/bound/image.hpp"
#include "generator/analysis/bound/library.hpp"
#include "generator/analysis/bound/value.hpp"

namespace eagerx::gen::bound {

enum class Reason : std::uint8_t {
  loop,  // how often it turns is not known
  several_entries,
  recursion,
  pointer_call,
  lost,  // a jump to where nothing is known
};

/// Why a function has no bound.
struct Obstacle {
  Reason reason = Reason::loop;
  Address at = 0;  // the loop's header, the call, the jump
  auto operator<=>(const Obstacle&) const = default;
};

/// A function with what is known of its arguments.
struct Analysed {
  const Flow* flow = nullptr;
  std::vector<bool> reached;                             // [blocks]
  std::set<std::pair<BlockIndex, BlockIndex>> possible;  // edges
  std::vector<std::optional<std::uint64_t>> most_turns;  // [loops] runs of the header
  std::map<Address, const Analysed*> calls;              // by the call's address
  std::vector<Obstacle> obstacles;                       // its own
  bool returns = false;
};

class Analysis {
 public:
  explicit Analysis(const Image& image) : image_(image), library_(library_loops(image)) {
    find_never_returning();
  }

  /// The function at `entry`, whatever its arguments are.
  const Analysed& of(Address entry);
  [[nodiscard]] const Image& image() const { return image_; }
  /// Loops of libraries, by their headers.
  [[nodiscard]] const std::map<Address, LibraryLoop>& library() const { return library_; }

 private:
  friend class Walk;

  void find_never_returning();
  const Flow& flow(Address entry);
  const Analysed* analyse(Address entry, const State& state);

  const Image& image_;
  Sums sums_;
  std::map<Address, LibraryLoop> library_;
  std::set<Address> never_returns_;
  std::map<Address, Flow> flows_;
  std::map<std::pair<Address, std::string>, std::unique_ptr<Analysed>> known_;
  std::map<Address, std::size_t> contexts_;
  std::set<Address> active_;
};

/// A callee's state at its entry, from the caller's before the call.
State entry_state(Address entry, const State* caller);
/// The difference between this state and any other.
std::string key_of(const State& entry);

}  // namespace eagerx::gen::bound
