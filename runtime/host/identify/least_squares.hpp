// Parameters and initial states of many short segments by weighted least squares.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <runtime/host/identify/experiment.hpp>
#include <runtime/host/identify/matrix.hpp>
#include <vector>

namespace eagerx::identification {

/// All samples of a segment.
inline constexpr std::uint32_t kAll = std::numeric_limits<std::uint32_t>::max();
inline constexpr double kTiny = 1e-9;           // keeps what nothing is known of where it is
inline constexpr double kParameterStep = 1e-2;  // of a difference, of half the range
inline constexpr double kDone = 1e-7;           // relative decrease of the cost

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

  /// The last `delays` of the ranges are delays.
  LeastSquares(const Experiment& experiment, std::vector<Range> ranges, std::size_t delays,
               Run run);

  /// Fits states, then parameters too, roughly, from the parameters of `trial` on. False if the
  /// program gives no numbers.
  bool fit(Trial& trial);
  /// The rest of the way.
  bool refine(Trial& trial);

  /// Minus twice the logarithm of the likelihood of the last fit, but for a constant.
  double deviance() const;
  /// Standard deviations of the parameters after the last fit.
  ///
  /// With delays held: the sandwich H⁻¹ S H⁻¹ (White, Maximum likelihood estimation of misspecified
  /// models, Econometrica 50, 1982). H is the curvature of the cost with the first states fitted
  /// again. Noise in first states adds to JᵀJ, which then says more than the log knows (Fuller,
  /// Measurement error models, 1987), so H is measured by differences. S is the larger one of JᵀJ
  /// and of the scatter of the segments' scores, which sees correlated errors, too.
  ///
  /// Of a delay: the profile of the likelihood (Venzon and Moolgavkar, Applied Statistics 37,
  /// 1988), because the cost has walls where a sensor reads the input. The other parameters get
  /// what they move along it. The range is known before, so a parameter that the log does not
  /// determine keeps the deviation of its range.
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

  /// Equations of the parameters alone: first states are eliminated.
  struct Reduced {
    Matrix information;         // [p, p], JᵀJ
    Matrix scatter;             // [p, p], of the segments' scores
    std::vector<double> score;  // [p]
  };
  /// How far a parameter can go to one side.
  struct Reach {
    double deviation = 0.0;     // in its unit
    std::vector<double> moves;  // of all parameters for one deviation, in half ranges
  };

  bool repeat(Trial& trial, int rounds, int steps);
  void start_again(Trial& trial, bool anywhere);
  bool take_better_states(Trial& trial, Trial& tried);
  bool descend(Trial& trial, int iterations);
  bool descend_states(Trial& trial, std::uint32_t window, int iterations);
  bool settle_delays(Trial& trial);
  bool settle(Trial& trial, std::size_t delay, double step);
  double cost_of_delay(Trial& trial, std::size_t delay, double value);
  void move_state(Trial& trial, const Equations::Segment& segment, std::size_t index,
                  double damping) const;
  bool differentiate(const Trial& trial, bool with_parameters);
  bool reduce(const Trial& trial, Reduced& reduced);
  void add_range(const Trial& trial, std::vector<double>& score) const;
  Matrix curvature(const Trial& trial, const Reduced& here);
  std::vector<double> with_delays_held(const Trial& trial, const Reduced& here,
                                       const Matrix& curvature) const;
  Reach reach(const Trial& trial, std::size_t parameter, double side, double guess);
  void hold(Matrix& equations, std::vector<double>& step) const;
  void assemble(Equations& equations, const std::vector<double>& residuals, std::uint32_t window,
                std::size_t parameters) const;
  double cost(const Trial& trial, const std::vector<double>& residuals) const;
  std::vector<double> costs(const std::vector<double>& residuals, std::uint32_t window) const;
  Trial moved(const Trial& trial, const Equations& equations, double damping, bool& solved) const;
  void weigh(const std::vector<double>& residuals);
  void find_repetitions(const std::vector<double>& residuals);
  std::size_t unknown_states() const { return scale_.size(); }
  /// Weight of the middle of the range. A parameter is probably there. A delay is not: the middle
  /// only keeps the equations regular.
  double known_before(std::size_t parameter) const {
    constexpr double kOfDelays = 1e-6;
    return parameter < first_delay_ ? 1.0 : kOfDelays;
  }
  double half(std::size_t parameter) const {
    return (ranges_[parameter].high - ranges_[parameter].low) / 2;
  }

  const Experiment& experiment_;
  std::vector<Range> ranges_;
  std::size_t first_delay_;    // of the parameters
  std::vector<bool> is_held_;  // of each parameter, while the others are fitted
  Run run_;
  std::vector<double> scale_;      // of each state
  std::vector<double> deviation_;  // of each group
  std::vector<double> scale_of_groups_;
  std::vector<double> least_;                 // smallest deviation of each group: its resolution
  std::vector<bool> counts_;                  // of each group
  std::vector<std::vector<double>> columns_;  // derivatives: states, then parameters
  bool has_fitted_ = false;                   // so that states are not first guesses
  std::vector<double> last_;                  // residuals
};

}  // namespace eagerx::identification
