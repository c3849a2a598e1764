#include "targets/environments/train/ranks/gradient_sum.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>

#include "targets/environments/train/settings.hpp"

namespace eagerx::train {
namespace {

using environments::Share;
using environments::share_of;

/// Values of each part that are no float32 of a gradient.
struct Counted {
  double divergence, count;
};

std::size_t numbers_in(const Share& share) {
  return share.end - share.first;
}

std::size_t total_of(const std::vector<std::size_t>& sizes) {
  return std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
}

}  // namespace

GradientSum::GradientSum(Ranks& ranks, const Model& model) : ranks_(ranks), total_(model) {
  if (ranks.size() == 1) return;
  for (const std::vector<float>* values : total_.vectors()) numbers_ += values->size();
  flat_.resize(numbers_);
  const std::size_t own = numbers_in(share_of(kParts, ranks.rank(), ranks.size()));
  for (std::uint32_t rank = 0; rank < ranks.size(); ++rank) {
    const std::size_t theirs = numbers_in(share_of(kParts, rank, ranks.size()));
    out_.push_back(own * slice(rank) * sizeof(float));
    in_.push_back(theirs * slice(ranks.rank()) * sizeof(float));
    all_sizes_.push_back(slice(rank) * sizeof(float) + theirs * sizeof(Counted));
  }
  to_.resize(total_of(out_) / sizeof(float));
  from_.resize(total_of(in_) / sizeof(float));
  mine_.resize(all_sizes_[ranks.rank()]);
  all_.resize(total_of(all_sizes_));
}

std::size_t GradientSum::slice(std::uint32_t rank) const {
  return numbers_in(share_of(numbers_, rank, ranks_.size()));
}

const Gradient& GradientSum::of(std::span<Gradient* const> own) {
  if (ranks_.size() == 1) {
    for (Gradient* more : own.subspan(1)) own.front()->add(*more);
    return *own.front();
  }
  cut(own);
  ranks_.exchange(
      std::span(reinterpret_cast<const char*>(to_.data()), to_.size() * sizeof(float)), out_,
      std::span(reinterpret_cast<char*>(from_.data()), from_.size() * sizeof(float)), in_);
  add_slices();
  put_together(own);
  return total_;
}

void GradientSum::cut(std::span<Gradient* const> own) {
  for (std::size_t i = 0; i < own.size(); ++i) {
    auto to = flat_.begin();
    for (const std::vector<float>* values : own[i]->vectors())
      to = std::ranges::copy(*values, to).out;
    std::size_t piece = 0;
    for (std::uint32_t rank = 0; rank < ranks_.size(); ++rank) {
      const Share share = share_of(numbers_, rank, ranks_.size());
      std::copy_n(flat_.begin() + static_cast<std::ptrdiff_t>(share.first), numbers_in(share),
                  to_.begin() + static_cast<std::ptrdiff_t>(piece + i * numbers_in(share)));
      piece += own.size() * numbers_in(share);
    }
  }
}

/// Parts are neighbours in their ranks, so the pieces are in the order of parts.
void GradientSum::add_slices() {
  const std::size_t count = slice(ranks_.rank());
  for (std::size_t part = 1; part < kParts; ++part) {
    for (std::size_t i = 0; i < count; ++i) from_[i] += from_[part * count + i];
  }
}

void GradientSum::put_together(std::span<Gradient* const> own) {
  const std::size_t floats = slice(ranks_.rank()) * sizeof(float);
  std::memcpy(mine_.data(), from_.data(), floats);
  for (std::size_t i = 0; i < own.size(); ++i) {
    const Counted counted{own[i]->divergence, own[i]->count};
    std::memcpy(mine_.data() + floats + i * sizeof counted, &counted, sizeof counted);
  }
  ranks_.gather(mine_, all_, all_sizes_);
  total_.divergence = total_.count = 0.0;
  float* to = flat_.data();
  const char* from = all_.data();
  for (std::uint32_t rank = 0; rank < ranks_.size(); ++rank) {
    const std::size_t count = slice(rank);
    std::memcpy(to, from, count * sizeof(float));
    to += count;
    const char* const end = from + all_sizes_[rank];
    for (from += count * sizeof(float); from != end; from += sizeof(Counted)) {
      Counted counted{};
      std::memcpy(&counted, from, sizeof counted);
      total_.divergence += counted.divergence;
      total_.count += counted.count;
    }
  }
  auto next = flat_.begin();
  for (std::vector<float>* values : total_.vectors()) {
    std::copy_n(next, values->size(), values->begin());
    next += static_cast<std::ptrdiff_t>(values->size());
  }
}

}  // namespace eagerx::train
