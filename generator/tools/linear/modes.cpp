#include "generator/tools/linear/modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "generator/tools/linear/matrices.hpp"

namespace eagerx::gen {
namespace {

using Eigen::Index;
constexpr double kZero = 1e-6;  // a pole that is at most this is one at zero, but for rounding
constexpr std::size_t kMostShares = 3;

Index nearest(const Eigen::VectorXcd& values, std::complex<double> wanted) {
  Index best = 0;
  for (Index i = 1; i < values.size(); ++i) {
    if (std::abs(values[i] - wanted) < std::abs(values[best] - wanted)) best = i;
  }
  return best;
}

std::vector<Participation> participation_of(const Eigen::VectorXcd& right,
                                            const Eigen::VectorXcd& left) {
  const Eigen::VectorXd product = right.cwiseProduct(left).cwiseAbs();
  const double sum = product.sum();
  std::vector<Participation> all;
  for (Index i = 0; i < product.size(); ++i)
    all.push_back({static_cast<std::size_t>(i), sum > 0.0 ? product[i] / sum : 0.0});
  std::ranges::stable_sort(all, std::greater<>(), &Participation::share);
  all.resize(std::min(all.size(), kMostShares));
  std::erase_if(all, [](const Participation& each) { return each.share < 0.05; });
  return all;
}

Pole pole_of(std::complex<double> z, double period_s) {
  const std::complex<double> s = std::log(z) / period_s;
  Pole pole;
  pole.z = z;
  pole.frequency_hz = std::abs(s) / (2.0 * std::numbers::pi);
  pole.damping = std::abs(s) > 0.0 ? -s.real() / std::abs(s) : 0.0;
  pole.time_constant_s = -1.0 / s.real();
  return pole;
}

}  // namespace

Modes modes_of(const SampledSystem& system) {
  Modes modes;
  if (system.state.empty()) return modes;
  const Eigen::MatrixXd a = matrix_of(system.a, system.state.size());
  const Eigen::EigenSolver<Eigen::MatrixXd> right(a), left(a.transpose());
  const Eigen::VectorXcd& values = right.eigenvalues();
  modes.spectral_radius = spectral_radius(values);
  modes.integrators = count_integrators(values);
  for (Index i = 0; i < values.size(); ++i) {
    if (std::abs(values[i]) <= kZero) {
      ++modes.at_zero;
    } else if (values[i].imag() >= 0.0) {
      Pole pole = pole_of(values[i], system.period_s);
      pole.participation =
          participation_of(right.eigenvectors().col(i),
                           left.eigenvectors().col(nearest(left.eigenvalues(), values[i])));
      modes.poles.push_back(std::move(pole));
    }
  }
  std::ranges::stable_sort(modes.poles, [](const Pole& one, const Pole& other) {
    return std::abs(one.z) > std::abs(other.z);
  });
  return modes;
}

}  // namespace eagerx::gen
