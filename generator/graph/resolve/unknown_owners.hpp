// Unknown owners in the ends of connections.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

/// Collects them before reporting: if an object's own name is mistyped, all of its connections are
/// right, and there is only one mistake.
class UnknownOwners {
 public:
  explicit UnknownOwners(UnresolvedGraph& draft) : draft_(draft) {}

  /// Whether the next unknown name is compared with the known ones.
  [[nodiscard]] bool helps() const { return unknown_.size() < kMostHelped; }
  /// Adds a port `port` at `span` whose owner is not in `known`. Returns the owner that is probably
  /// meant, or an empty text.
  std::string add(const PortName& port, Span span, std::vector<std::string> known);
  /// Reports E0309 for each place, or once for all if the name of the object or node itself is
  /// mistyped: consequences are not reported later.
  void report();

 private:
  static constexpr std::size_t kMostHelped = 100;  // more is of no use

  struct Place {
    std::string port;
    Span span;
    std::string written;  // with what is between owner and port
  };
  struct Unknown {
    std::string owner;
    std::vector<Place> places;       // where it is used
    std::vector<std::string> known;  // what it could be
    std::size_t elements;            // if it is an array
    std::string near;
  };

  /// The port that `owner.port` means with other separators, or with a prefix; empty if there is
  /// none: `robot.body.v` and `body.v` are `robot/body.v`.
  static std::string spelled(const Unknown& unknown, const Place& place);
  [[nodiscard]] bool is_used(std::string_view owner) const;
  void report_declared(const Unknown& unknown, Span declared);
  void report_used(const Unknown& unknown, const Place& place);
  Diagnostic& error(const Unknown& unknown, const Place& place);

  UnresolvedGraph& draft_;
  std::vector<Unknown> unknown_;
  std::map<std::string, std::size_t> index_of_;  // in `unknown_`, by owner
  std::size_t helped_ = 0;
};

}  // namespace eagerx::gen
