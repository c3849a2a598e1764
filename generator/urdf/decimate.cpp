// Meshes with few triangles, for drawings. Corners in one cell of a grid become their mean:
// Rossignac, Borrel, Multi-resolution 3D approximations for rendering complex scenes, 1993.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>

#include "generator/urdf/meshes.hpp"

namespace eagerx::urdf {
namespace {

using Cell = std::array<std::int32_t, 3>;

struct Bounds {
  Vector3 low{}, high{};

  explicit Bounds(const Triangles& triangles) {
    if (triangles.empty()) return;
    low = high = triangles.front();
    for (const Vector3& p : triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], p[i]);
        high[i] = std::max(high[i], p[i]);
      }
    }
  }
  [[nodiscard]] double longest() const {
    return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  }
};

/// With `cells` along the longest side.
Triangles clustered(const Triangles& triangles, const Bounds& bounds, int cells) {
  const double side = bounds.longest() / cells;
  struct Mean {
    Vector3 sum{};
    double count = 0.0;
    std::int32_t number = 0;
  };
  std::map<Cell, Mean> means;
  std::vector<const Mean*> corners;
  for (const Vector3& p : triangles) {
    Cell cell{};
    for (std::size_t i = 0; i < 3; ++i)
      cell[i] = static_cast<std::int32_t>(std::floor((p[i] - bounds.low[i]) / side + 0.5));
    const auto [at, is_new] = means.try_emplace(cell);
    if (is_new) at->second.number = static_cast<std::int32_t>(means.size());
    at->second.sum = at->second.sum + p;
    at->second.count += 1.0;
    corners.push_back(&at->second);
  }
  Triangles result;
  std::set<std::array<std::int32_t, 3>> taken;
  for (std::size_t t = 0; t + 2 < corners.size(); t += 3) {
    std::array<std::int32_t, 3> numbers{};
    for (std::size_t i = 0; i < 3; ++i) numbers[i] = corners[t + i]->number;
    std::ranges::sort(numbers);
    if (numbers[0] == numbers[1] || numbers[1] == numbers[2] || !taken.insert(numbers).second)
      continue;
    for (std::size_t i = 0; i < 3; ++i)
      result.push_back(1.0 / corners[t + i]->count * corners[t + i]->sum);
  }
  return result;
}

/// The twelve triangles of the box around all.
Triangles box_of(const Bounds& bounds) {
  const auto corner = [&](unsigned bits) {
    Vector3 p{};
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = (bits >> i & 1U) != 0 ? bounds.high[i] : bounds.low[i];
    return p;
  };
  constexpr unsigned kFaces[6][4] = {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3},
                                     {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};
  Triangles result;
  for (const auto& face : kFaces) {
    for (const std::size_t i : {0, 1, 2, 0, 2, 3}) result.push_back(corner(face[i]));
  }
  return result;
}

/// Six times the volume inside, negative if the corners go round clockwise.
double volume(const Triangles& triangles) {
  const Vector3 from = triangles.empty() ? Vector3{} : triangles.front();
  double sum = 0.0;
  for (std::size_t t = 0; t + 2 < triangles.size(); t += 3)
    sum +=
        dot(triangles[t] - from, models::cross(triangles[t + 1] - from, triangles[t + 2] - from));
  return sum;
}

}  // namespace

double surface_of(const Triangles& triangles) {
  double sum = 0.0;
  for (std::size_t t = 0; t + 2 < triangles.size(); t += 3) {
    const Vector3 n =
        models::cross(triangles[t + 1] - triangles[t], triangles[t + 2] - triangles[t]);
    sum += 0.5 * std::sqrt(dot(n, n));
  }
  return sum;
}

Triangles decimated(const Triangles& triangles, std::size_t most) {
  constexpr int kFinest = 64;
  constexpr std::size_t kFewest = 4;  // triangles of a solid
  const Bounds bounds(triangles);
  Triangles best;
  if (triangles.size() / 3 <= most) {
    best = triangles;
  } else if (bounds.longest() > 0.0) {
    int coarse = 0, fine = kFinest + 1;  // few enough, too many triangles
    while (fine - coarse > 1) {
      const int cells = (coarse + fine) / 2;
      Triangles tried = clustered(triangles, bounds, cells);
      if (tried.size() / 3 > most) {
        fine = cells;
        continue;
      }
      coarse = cells;
      best = std::move(tried);
    }
    if (best.size() / 3 < kFewest) best = box_of(bounds);
  }
  if (volume(best) < 0.0) {
    for (std::size_t t = 0; t + 2 < best.size(); t += 3) std::swap(best[t + 1], best[t + 2]);
  }
  return best;
}

}  // namespace eagerx::urdf
