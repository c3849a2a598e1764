// Unknown owners in the ends of connections.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

/// Gathers them before they are said: where an object's own name is mistyped, all of its
/// connections are right, and it is one mistake.
class UnknownOwners {
 public:
  explicit UnknownOwners(UnresolvedGraph& draft) : draft_(draft) {}

  /// Whether the next unknown name is compared with the known ones.
  [[nodiscard]] bool helps() const { return unknown_.size() < kMostHelped; }
  /// Port `port` at `span` has an owner that is none of `known`. Returns the one that is meant, or
  /// nothing.
  std::string add(const PortName& port, Span span, std::vector<std::string> known);
  /// E0309 for each place, or one for all if it is the name of an object or a node that is
  /// mistyped: what follows from that is not said later.
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

  /// The port that `owner.port` is with other separators, or with what is around it; empty if there
  /// is none: `robot.body.v` and `body.v` are `robot/body.v`.
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
