// What of a run has a name and a value that others can set.
#pragma once

#include <cstdint>
#include <string>
#include <targets/linux-sim/fields.hpp>
#include <targets/linux-sim/publish/foxglove/client_message.hpp>
#include <targets/linux-sim/publish/foxglove/server_text.hpp>
#include <targets/linux-sim/publish/foxglove/web_socket.hpp>
#include <targets/linux-sim/publish/remote.hpp>
#include <vector>

namespace eagerx::linux_sim {

/// States have the names of `--set`, such as `pendulum.theta`: what is set holds for all resets
/// from the next one on. Actions have those of their channels, such as `environment/voltage`: what
/// is set takes the place of the agent's, until it is set to nothing or who has set it is gone.
class Parameters {
 public:
  Parameters(const Fields& fields, Remote& remote);

  /// Of these names, or of all, if there are none. A state that is not set has the value that the
  /// latest episode began with, if it began with one.
  std::vector<ParameterValue> values(const std::vector<std::string>& names);
  bool has(const std::string& name) const;
  /// Empty, or what is wrong.
  std::string set(ClientId client, const ClientMessage::Parameter& wanted);
  /// Actions of a client that is gone are the agent's again. True: there were some. If there is no
  /// room for it now, they are kNobody's.
  bool release(ClientId client);
  static constexpr ClientId kNobody = ~ClientId{0};

 private:
  struct Known {
    std::string name;
    const Field* field;
    Remote::Wish wish;          // what sets it
    std::uint32_t index;        // among states, or actions
    std::size_t at = 0;         // of a state: its first number in Remote::read_states()
    std::vector<double> value;  // none: it is not set
    ClientId client = 0;        // who has set it
  };

  void add(const std::vector<Field>& fields, Remote::Wish wish);
  static std::string problem_with(const Known& known, const std::vector<double>& numbers);

  Remote& remote_;
  std::vector<Known> known_;
  std::vector<double> numbers_;  // of states
  std::vector<bool> has_value_;
};

}  // namespace eagerx::linux_sim
