#include <targets/emulated-ftdi/faults.hpp>
#include <targets/emulated-ftdi/time.hpp>

namespace eagerx::emulated {

void Faults::configure(std::uint64_t seed, double probability, std::uint32_t kinds,
                       std::uint64_t most) {
  state_ = seed;
  probability_ = probability;
  kinds_ = kinds;
  left_ = most;
}

// SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014).
std::uint64_t Faults::next() {
  state_ += 0x9e3779b97f4a7c15U;
  std::uint64_t z = state_;
  z = (z ^ z >> 30U) * 0xbf58476d1ce4e5b9U;
  z = (z ^ z >> 27U) * 0x94d049bb133111ebU;
  return z ^ z >> 31U;
}

std::int64_t Faults::between(std::int64_t low, std::int64_t high) {
  return low + static_cast<std::int64_t>(next() % static_cast<std::uint64_t>(high - low + 1));
}

void Faults::note(Fault fault) {
  ++counts_[static_cast<std::size_t>(fault)];
}

bool Faults::sample(Fault& fault, bool has_i2c) {
  if (is_forced_) {
    is_forced_ = false;
    fault = forced_;
    return note(fault), true;
  }
  if (left_ == 0 || probability_ <= 0.0) return false;
  constexpr double kToUnit = 0x1p-64;
  if (static_cast<double>(next()) * kToUnit >= probability_) return false;
  fault = static_cast<Fault>(between(0, kFaults - 1));
  if (fault == Fault::oversleep || !allowed(fault) || (fault == Fault::nak && !has_i2c)) {
    return false;
  }
  --left_;
  return note(fault), true;
}

std::int64_t Faults::oversleep_ns() {
  if (left_ == 0 || probability_ <= 0.0 || !allowed(Fault::oversleep)) return 0;
  constexpr double kToUnit = 0x1p-64;
  if (static_cast<double>(next()) * kToUnit >= probability_ / static_cast<double>(kFaults)) {
    return 0;
  }
  --left_;
  note(Fault::oversleep);
  return between(40 * kNsPerMs, 80 * kNsPerMs);
}

}  // namespace eagerx::emulated
