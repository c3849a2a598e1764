// Parameters of a run that clients can set.
#pragma once

#include <cstdint>
#include <runtime/host/foxglove/steering.hpp>
#include <string>
#include <targets/linux-sim/fields.hpp>
#include <targets/linux-sim/publish/remote.hpp>
#include <vector>

namespace eagerx::linux_sim {

/// States have the names of `--set`, such as `pendulum.theta`: a value applies from the next reset
/// on. Actions have the names of their channels, such as `environment/voltage`: a value replaces
/// the agent's, until it is removed or its client disconnects.
class Parameters final : public foxglove::Steering {
 public:
  using ClientId = web_socket::ClientId;
  Parameters(const Fields& fields, Remote& remote, bool is_real);

  /// A state that is not set has the value that the latest episode began with, if it began with
  /// one.
  std::vector<foxglove::ParameterValue> values(const std::vector<std::string>& names) override;
  bool has(const std::string& name) const override;
  std::string set(ClientId client, const foxglove::ClientMessage::Parameter& wanted) override;
  /// Actions of a client that is gone are the agent's again. If there is no room for it now, they
  /// are kNoClient's.
  bool release(ClientId client) override;
  std::uint64_t version() const override { return remote_.version(); }
  bool has_services() const override { return !is_real_; }
  std::uint64_t ask(foxglove::Service service, std::uint32_t steps) override;
  std::uint64_t done() const override { return remote_.done(); }

 private:
  struct Known {
    std::string name;
    const Field* field;
    Remote::Wish wish;          // what sets it
    std::uint32_t index;        // among states, or actions
    std::size_t at = 0;         // of a state: its first number in Remote::read_states()
    std::vector<double> value;  // none: it is not set
    ClientId client = 0;        // that has set it
  };

  void add(const std::vector<Field>& fields, Remote::Wish wish);
  static std::string problem_with(const Known& known, const std::vector<double>& numbers);

  Remote& remote_;
  const bool is_real_;
  std::vector<Known> known_;
  std::vector<double> numbers_;  // of states
  std::vector<bool> has_value_;
};

}  // namespace eagerx::linux_sim
