// An operating point as text or JSON.
#pragma once

#include <string>
#include <vector>

#include "generator/support/json/json.hpp"
#include "generator/tools/linear/trim.hpp"

namespace eagerx::gen {

/// All that was found, and what was asked.
struct TrimReport {
  TrimQuestion question;
  TrimAnswer answer;
  std::string graph;               // its name
  std::string command;             // that linearizes there
  std::string program_options;     // that begin an episode there; empty: nothing does
  std::vector<std::string> reset;  // the program's options that set its reset
};

/// The name of a number of the program: that of the state which a reset sets, if it is one.
std::string name_of_word(const Hyperperiod& hyperperiod, std::size_t word);
/// "pendulum.model_state[0] <= 3.14"
std::vector<std::string> bounds_text(const TrimReport& report);
/// The largest residuals in words, of their numbers: at most `most`.
std::vector<std::string> residuals_text(const TrimReport& report, std::size_t most);
/// Numbers that move whatever the others are: clocks.
std::vector<std::string> clocks_in(const TrimReport& report);

std::string trim_text(const TrimReport& report);
Json trim_json(const TrimReport& report);

}  // namespace eagerx::gen
