// A library's description of its graph.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::client {

/// An observation, an action or a state.
struct Space {
  std::string name;
  std::string dtype;
  std::size_t size = 1;  // numbers, all messages of a window together
  std::vector<double> low,
      high;                // [size], infinite where there is no bound; as one if all are equal
  bool is_scalar = false;  // shape []

  /// Whether its numbers are whole.
  bool is_whole() const;
};

/// A part of a training, before the graph as written.
struct Stage {
  std::string name;
  double success, mean_return;  // that must be reached in it; negative infinity: nothing is asked
};

struct Description {
  std::string graph;
  std::string hash;     // of observations and actions
  std::string program;  // of all that the library was generated from; empty: an old library
  double rate_hz = 0.0;
  bool has_threads = true;  // whether several environments may be stepped at once
  std::vector<Space> observations, actions, states;  // in the order of the columns
  std::string agent;  // what eagerx_act() does; empty: an old library
  bool has_task = false;
  std::vector<std::string> terms;  // of the reward
  bool has_success = false;
  std::uint32_t episode_steps = 0;  // 0: no limit
  std::vector<Stage> stages;        // of the task
  std::vector<Space> critic;        // what the critic of a training sees besides observations

  std::size_t observation_numbers() const;
  std::size_t action_numbers() const;
  std::size_t critic_numbers() const;
  /// Whether all actions are whole numbers, each one of a few.
  bool chooses() const;
};

/// The name of each number of some states: "pendulum.mass", "arm.angles[1]".
std::vector<std::string> column_names(const std::vector<Space>& states);

/// Reads the JSON of eagerx_describe(). Throws Problem if it is not understood.
Description read_description(std::string_view json);

}  // namespace eagerx::client
