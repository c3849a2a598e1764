// Writes a stream into a file, or forwards it.
#pragma once

#include <memory>
#include <runtime/host/foxglove/server.hpp>
#include <string>
#include <vector>

#include "generator/tools/monitor/expected.hpp"
#include "generator/tools/monitor/stream.hpp"

namespace eagerx::gen {

/// Destinations of a stream. Everything that a stream tells goes through here after it was
/// accepted.
class Recording final : public StreamListener {
 public:
  /// `expected`: null: no graph is known.
  explicit Recording(const Expected* expected);
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
  ~Recording() override;

  /// `path` ends in .mcap (Foxglove), .trace or .log (a trace, as programs write it).
  void record(const std::string& path);
  /// `udp:HOST:PORT`, `teleplot:HOST:PORT`, `foxglove:[HOST:]PORT` or `dds[:DOMAIN][@INTERFACE]`.
  void forward(const std::string& destination);
  /// Serves the messages of the graph and a page of this machine from now on, with topics of its
  /// own; the server is null and `problem` says why if it cannot. Only with a known graph.
  foxglove::Server* serve(foxglove::Site site, std::vector<foxglove::Topic> topics,
                          std::string& problem);

  bool begin(const StreamFacts& facts) override;
  void message(const StreamMessage& message) override;
  void step(const StreamStep& step) override;
  void fault(StreamFault /*fault*/, std::uint64_t /*count*/) override {}
  void scene(const StreamScene& scene) override;
  [[nodiscard]] bool wants_scenes() const override;

  /// Notes for the user since the last call, a line each.
  std::string take_notes();
  /// Called often, and every few milliseconds where has_clients().
  void idle();
  [[nodiscard]] bool has_clients() const;
  /// Empty, or the problem.
  std::string finish();
  /// The problem so far; empty: none.
  [[nodiscard]] const std::string& problem() const { return problem_; }
  /// Messages that could not be kept: of no known type, or too long.
  [[nodiscard]] std::uint64_t left_out() const { return left_out_; }

 private:
  class Destinations;
  std::unique_ptr<Destinations> destinations_;
  const Expected* expected_;
  std::string problem_;
  std::uint64_t left_out_ = 0;
};

}  // namespace eagerx::gen
