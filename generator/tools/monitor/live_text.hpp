// Data for the live page besides the messages of a stream. Inside monitor/ only.
#pragma once

#include <cstdint>
#include <map>
#include <runtime/host/foxglove/server_text.hpp>
#include <string>
#include <vector>

#include "generator/tools/monitor/model.hpp"

namespace eagerx::gen {

/// When messages came, against the graph's clock: the newest ones of each channel.
class Arrivals {
 public:
  void add(const StreamMessage& message, std::int64_t late_ns);
  void clear() { channels_.clear(); }

  struct Channel {
    std::uint64_t first = 0;            // tick of the first one
    std::vector<std::int64_t> late_ns;  // of this tick and those that follow
  };
  [[nodiscard]] const Channel* find(const std::string& channel) const;

 private:
  static constexpr std::size_t kMost = 500;  // of a channel; older ones are left out

  std::map<std::string, Channel, std::less<>> channels_;
};

/// The topic `/monitor`.
foxglove::Topic monitor_topic();
/// A message with everything that `eagerx-gen monitor` shows. `note`: the end of the source; empty:
/// it continues.
std::string monitor_text(const Model& model, const Arrivals& arrivals, const std::string& note);

}  // namespace eagerx::gen
