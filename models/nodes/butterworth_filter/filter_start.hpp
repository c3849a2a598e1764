// Initial state of a filter.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <models/nodes/block.hpp>

namespace eagerx::models {

enum class FilterInitial : std::uint8_t { zero, measured };

/// Which of N elements have had their first finite sample. Takes no memory with `zero`.
template <class Real, std::size_t N, FilterInitial Initial>
class FilterStart {
 public:
  void reset() { begun_ = {}; }

  /// Whether element `i` begins with this sample, which it then has.
  TruthOf<Real> begins(std::size_t i, const TruthOf<Real>& empty, const Real& sample) {
    const TruthOf<Real> first = !empty && eagerx::isfinite(sample) && begun_[i] == Real(0);
    begun_[i] = select(first, Real(1), begun_[i]);
    return first;
  }
  /// Element `i` begins again where `lost`.
  void forget(std::size_t i, const TruthOf<Real>& lost) {
    begun_[i] = select(lost, Real(0), begun_[i]);
  }

 private:
  std::array<Real, N> begun_{};  // 1 after the first sample
};

template <class Real, std::size_t N>
class FilterStart<Real, N, FilterInitial::zero> {
 public:
  static void reset() {}
  static TruthOf<Real> begins(std::size_t /*i*/, const TruthOf<Real>& /*empty*/,
                              const Real& /*sample*/) {
    return false;
  }
  static void forget(std::size_t /*i*/, const TruthOf<Real>& /*lost*/) {}
};

}  // namespace eagerx::models
