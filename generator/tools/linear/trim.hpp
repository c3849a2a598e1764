// The search for an operating point: a state and inputs for which a hyperperiod ends where it
// began.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "generator/tools/linear/hyperperiod.hpp"

namespace eagerx::gen {

/// A number of the program, or an input: where the search begins, and what it may do.
struct TrimNumber {
  double value = 0.0;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool fixed = false;    // it keeps its value, and must be at rest
  bool moving = false;   // it need not be at rest, nor what depends on it
  bool settled = false;  // it rests, whatever the others are: it keeps its value
};

/// An output that has to have a value.
struct WantedOutput {
  std::size_t output = 0;
  double value = 0.0;
};

struct TrimQuestion {
  std::vector<TrimNumber> words, inputs;  // of Hyperperiod::system
  std::vector<WantedOutput> wanted;
};

/// A hyperperiod from these numbers and inputs; nothing if it diverges.
using Evaluate = std::function<std::optional<Hyperperiod>(const std::vector<double>& words,
                                                          const std::vector<double>& inputs)>;

/// A number, or an input, at a bound that keeps the residual from becoming smaller.
struct ReachedBound {
  bool is_input = false;
  std::size_t index = 0;
  double bound = 0.0;
};

/// The best point that was found.
struct TrimAnswer {
  bool found = false;            // no residual above the tolerance, nor in the next hyperperiod
  bool depends_on_time = false;  // only in the next one: a source of signals, a counter
  std::size_t evaluations = 0;   // hyperperiods with derivatives
  std::vector<double> words, inputs;
  Hyperperiod there;             // from it
  std::vector<bool> moves;       // by word: one that may move, or depends on one
  std::vector<double> residual;  // by word: its change in the hyperperiod; 0 of one that moves
  std::vector<ReachedBound> bounds;
  // Words and inputs that may change together while all stays at rest: more of them can be fixed.
  std::vector<std::size_t> free_words, free_inputs;
  std::size_t freedoms = 0;
};

/// Levenberg-Marquardt steps with exact derivatives, as Gauss-Newton steps of least norm wherever
/// those reduce the residual; bounds by an active set (Nocedal, Wright: Numerical Optimization, 2nd
/// edition, 2006, sections 10.3 and 16.7). At most 200 hyperperiods. Nothing if not even the first
/// could be evaluated.
std::optional<TrimAnswer> find_operating_point(const TrimQuestion& question,
                                               const Evaluate& evaluate);

}  // namespace eagerx::gen
