// Order of datagrams: finds late ones, those of another run, and how many are missing.
#pragma once

#include <cstdint>
#include <optional>

#include "generator/tools/monitor/datagram.hpp"

namespace eagerx::gen {

class StepOrder {
 public:
  enum class Place : std::uint8_t {
    first,   // of a run
    next,    // a later step
    same,    // more of the same step: what did not fit into the datagram before
    late,    // an earlier step
    foreign  // of another graph, while that of the run still speaks
  };

  /// `now_ns`: when it came, by a steady clock.
  Place place(const Datagram& datagram, std::int64_t now_ns);
  /// Steps that were missing before the last datagram, as far as their numbers say.
  [[nodiscard]] std::uint64_t lost() const { return lost_; }

 private:
  Place begin(const Datagram& datagram);
  Place follow(const Datagram& datagram);

  bool running_ = false;
  std::optional<std::uint64_t> hash_;
  double time_s_ = 0.0;
  std::uint32_t episode_ = 0;
  std::uint64_t step_ = 0;
  std::uint64_t stride_ = 0;  // between steps that are published; 0: not known
  std::uint64_t lost_ = 0;
  std::int64_t came_ns_ = 0;
};

}  // namespace eagerx::gen
