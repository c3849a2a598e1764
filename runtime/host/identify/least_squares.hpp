// Parameters and initial states of many short segments by weighted least squares.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <runtime/host/identify/experiment.hpp>
#include <runtime/host/identify/matrix.hpp>
#include <vector>

namespace eagerx::identification {

/// A parameter that lies somewhere in [low, high].
struct Range {
  double low = 0.0, high = 0.0;
};

/// The method of Gauss and Newton with Levenberg's and Marquardt's damping. Each segment's initial
/// state is an unknown of its own and is eliminated (Schur's complement), so that the equations
/// have the size of the parameters. Derivatives are differences; one pair of runs serves a state of
/// all segments at once. Every group of samples has a standard deviation that is estimated from
/// what is left over; groups that repeat another one do not count.
class LeastSquares {
 public:
  using Run = std::function<const std::vector<double>&(const Trial&)>;

  LeastSquares(const Experiment& experiment, std::vector<Range> ranges, Run run);

  /// Fits states, then parameters too, roughly, from the parameters of `trial` on. False if the
  /// program gives no numbers.
  bool fit(Trial& trial);
  /// The rest of the way.
  bool refine(Trial& trial);

  /// Minus twice the logarithm of the likelihood of the last fit, but for a constant.
  double deviance() const;
  /// Standard deviations of the parameters after the last fit: the larger one of what the noise
  /// says, and of what the scatter of the segments says, which also sees errors of the model; and
  /// the step that the descent did not take, where the rounding of float stopped it. A parameter
  /// that the log does not determine keeps that of its range.
  std::vector<double> deviations(const Trial& trial);
  /// Root mean square of what is left over, of each group.
  std::vector<double> leftover() const;
  /// Whether a group says anything that another one does not.
  bool counts(std::size_t group) const { return counts_[group]; }

 private:
  /// Normal equations in units of scale_ and of half the ranges.
  struct Equations {
    struct Segment {
      Matrix states, mixed;          // [n, n], [parameters, n]
      std::vector<double> gradient;  // [n]
      std::vector<double> parameter_gradient;
    };
    Matrix parameters;  // [p, p]
    std::vector<double> gradient;
    std::vector<Segment> segments;
  };

  bool repeat(Trial& trial, int rounds, int steps);
  bool descend(Trial& trial, int iterations);
  bool descend_states(Trial& trial, std::uint32_t window, int iterations);
  void move_state(Trial& trial, const Equations::Segment& segment, std::size_t index,
                  double damping) const;
  bool differentiate(const Trial& trial, bool with_parameters);
  void take_gentler_sides(const Trial& trial, const std::vector<double>& residuals);
  void assemble(Equations& equations, const std::vector<double>& residuals, std::uint32_t window,
                std::size_t parameters) const;
  double cost(const Trial& trial, const std::vector<double>& residuals) const;
  std::vector<double> costs(const std::vector<double>& residuals, std::uint32_t window) const;
  Trial moved(const Trial& trial, const Equations& equations, double damping, bool& solved) const;
  void weigh(const std::vector<double>& residuals);
  void find_repetitions(const std::vector<double>& residuals);
  std::size_t unknown_states() const { return scale_.size(); }
  double half(std::size_t parameter) const {
    return (ranges_[parameter].high - ranges_[parameter].low) / 2;
  }

  const Experiment& experiment_;
  std::vector<Range> ranges_;
  Run run_;
  std::vector<double> scale_;      // of each state
  std::vector<double> deviation_;  // of each group
  std::vector<double> scale_of_groups_;
  std::vector<double> least_;                 // smallest deviation of each group: its resolution
  std::vector<bool> counts_;                  // of each group
  std::vector<std::vector<double>> columns_;  // derivatives: states, then parameters
  std::vector<double> last_;                  // residuals
};

}  // namespace eagerx::identification
