// Source of a stream. Each kind of source has its own file.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "generator/tools/monitor/stream.hpp"

namespace eagerx::gen {

class Source {
 public:
  enum class State : std::uint8_t {
    open,
    more,    // there is more to read at once
    ended,   // nothing more will come
    failed,  // problem() says why
    refused  // the same: it is the stream of another graph
  };

  virtual ~Source() = default;
  /// The file descriptor for poll(); -1: it is polled by a timer.
  [[nodiscard]] virtual int descriptor() const = 0;
  /// Passes on events that have arrived, but limits a flood, so that the screen can be drawn in
  /// between. Never waits. `now_ns`: from a steady clock.
  virtual State read(std::int64_t now_ns, StreamListener& listener) = 0;
  /// "error: …", with a line of help where there is one.
  [[nodiscard]] virtual std::string problem() const = 0;
  /// Notes for the user before the first message, a line each; empty: none.
  [[nodiscard]] virtual std::string warning() const { return {}; }
};

/// Opens the source that the user names: `udp:[HOST:]PORT`, `foxglove:[HOST:]PORT`,
/// `serial:DEVICE`, or the file of a trace or a recording. `layout`: the text of the board's
/// `telemetry.json`, or empty. Null: see `problem`.
std::unique_ptr<Source> open_source(const std::string& name, const std::string& layout,
                                    std::string& problem);

// The kinds.
/// Listens at `[HOST:]PORT`, on the loopback interface unless HOST says another.
std::unique_ptr<Source> open_udp_source(const std::string& name, std::string_view address,
                                        std::string& problem);
/// A client of a program's server of Foxglove's protocol at `[HOST:]PORT`.
std::unique_ptr<Source> open_foxglove_source(const std::string& name, std::string_view address,
                                             std::string& problem);
/// The serial line of a board that sends telemetry, described by `layout` (the text of its
/// `telemetry.json`); also a pipe, or a file with recorded bytes.
std::unique_ptr<Source> open_serial_source(const std::string& path, const std::string& layout,
                                           std::string& problem);
/// The file of a trace, which may grow.
std::unique_ptr<Source> open_log_source(const std::string& path, std::string& problem);
/// A recording in MCAP, which may grow.
std::unique_ptr<Source> open_mcap_source(const std::string& path, std::string& problem);

}  // namespace eagerx::gen
