// Fills outlines with exact coverage in integers: the same pixels on every machine.
#pragma once

#include <cstddef>
#include <cstdint>

namespace eagerx::picture {

/// Pixels in memory, row by row from the top: `channels` bytes each, 3 for red, green and blue, 1
/// for grey.
struct Image {
  std::uint8_t* pixels = nullptr;
  int width = 0, height = 0, channels = 0;
};

/// A position in 1/256 of a pixel, y downward.
struct Fixed {
  std::int32_t x = 0, y = 0;
};
inline constexpr std::int32_t kOne = 256;
/// The largest coordinate, so that products fit into 64 bits.
inline constexpr float kFarthest = 16000.0F;

constexpr std::int32_t to_fixed(float pixels) {
  if (!(pixels > -kFarthest)) pixels = -kFarthest;  // NaN too
  if (pixels > kFarthest) pixels = kFarthest;
  const float scaled = pixels * static_cast<float>(kOne);
  return static_cast<std::int32_t>(scaled < 0.0F ? scaled - 0.5F : scaled + 0.5F);
}

struct Paint {
  std::uint8_t red = 0, green = 0, blue = 0;
  std::int32_t opacity = 0;  // of 256
};

constexpr Paint paint_of(std::uint32_t colour, float opacity) {
  // NOLINTBEGIN(bugprone-incorrect-roundings): the same bits everywhere, which matter more
  return {static_cast<std::uint8_t>(colour >> 16U & 0xffU),
          static_cast<std::uint8_t>(colour >> 8U & 0xffU),
          static_cast<std::uint8_t>(colour & 0xffU),
          static_cast<std::int32_t>(opacity * 256.0F + 0.5F)};
  // NOLINTEND(bugprone-incorrect-roundings)
}
/// The gray value of a color (ITU-R BT.601).
constexpr std::int32_t grey_of(const Paint& p) {
  return (77 * p.red + 150 * p.green + 29 * p.blue + 128) >> 8;
}

/// An outline of closed parts. Overlapping parts with the same direction are filled once. The
/// coverage of a pixel is exact to 1/256, except for the rounding of slopes.
template <std::size_t kMaxEdges, std::size_t kMaxWidth>
class Outline {
 public:
  constexpr void clear() { edges_ = 0; }
  constexpr bool has_room(std::size_t edges) const { return edges_ + edges <= kMaxEdges; }

  /// Adds a closed polygon; `forward` false reverses it. Edges that do not fit are left out.
  constexpr void add(const Fixed* p, std::size_t count, bool forward = true) {
    if (!has_room(count)) return;
    for (std::size_t i = 0; i < count; ++i) {
      const Fixed& a = p[i];
      const Fixed& b = p[i + 1 == count ? 0 : i + 1];
      forward ? add_edge(a, b) : add_edge(b, a);
    }
  }

  /// Paints the inside.
  void fill(const Image& image, const Paint& paint) {
    if (edges_ == 0 || image.width > static_cast<int>(kMaxWidth) || paint.opacity <= 0) return;
    std::int32_t top = edge_[0].y0, bottom = edge_[0].y1;
    for (std::size_t e = 1; e < edges_; ++e) {
      if (edge_[e].y0 < top) top = edge_[e].y0;
      if (edge_[e].y1 > bottom) bottom = edge_[e].y1;
    }
    const int first = top < 0 ? 0 : top / kOne;
    const int end = bottom >= image.height * kOne ? image.height : (bottom + kOne - 1) / kOne;
    for (int row = first; row < end; ++row) fill_row(image, paint, row);
  }

 private:
  struct Edge {
    std::int32_t x0, y0, y1;  // y0 < y1
    std::int32_t sign;
    std::int64_t slope;  // of x, in 1/65536
  };

  constexpr void add_edge(const Fixed& a, const Fixed& b) {
    if (a.y == b.y) return;
    const bool down = a.y < b.y;
    const Fixed& upper = down ? a : b;
    const Fixed& lower = down ? b : a;
    const std::int64_t slope =
        (static_cast<std::int64_t>(lower.x) - upper.x) * 65536 / (lower.y - upper.y);
    edge_[edges_++] = {upper.x, upper.y, lower.y, down ? 1 : -1, slope};
  }

  void fill_row(const Image& image, const Paint& paint, int row) {
    left_ = image.width;
    right_ = -1;
    const std::int32_t top = row * kOne;
    const std::int32_t limit = image.width * kOne;
    for (std::size_t e = 0; e < edges_; ++e) {
      const Edge& edge = edge_[e];
      const std::int32_t y0 = edge.y0 > top ? edge.y0 : top;
      const std::int32_t y1 = edge.y1 < top + kOne ? edge.y1 : top + kOne;
      if (y0 >= y1) continue;
      add_piece({at(edge, y0), y0}, {at(edge, y1), y1}, edge.sign, limit);
    }
    if (right_ < 0) return;
    std::int32_t sum = 0;
    std::uint8_t* pixel =
        image.pixels + (static_cast<std::ptrdiff_t>(row) * image.width + left_) * image.channels;
    for (int x = left_; x < image.width; ++x, pixel += image.channels) {
      if (x <= right_) {
        sum += cell_[x];
        cell_[x] = 0;
      } else if (sum == 0) {
        break;
      }
      const std::int32_t inside = sum < 0 ? -sum : sum;
      const std::int32_t covered = inside >= kWhole ? kOne : inside / (kWhole / kOne);
      if (covered != 0) blend(pixel, image.channels, paint, covered * paint.opacity / kOne);
    }
    cell_[image.width] = cell_[image.width + 1] = 0;
  }

  static std::int32_t at(const Edge& edge, std::int32_t y) {
    return edge.x0 + static_cast<std::int32_t>((edge.slope * (y - edge.y0)) >> 16U);
  }

  /// A part of an edge within one row. Parts left of the picture count at its border; parts right
  /// of it do not count.
  void add_piece(Fixed a, Fixed b, std::int32_t sign, std::int32_t limit) {
    if (a.x > b.x) {  // from left to right; the height is what counts
      const std::int32_t x = a.x;
      a.x = b.x;
      b.x = x;
    }
    std::int32_t height = b.y - a.y;
    if (b.x <= 0) return add_cells(0, 0, height * sign, limit);
    if (a.x >= limit) return;
    const std::int64_t width = static_cast<std::int64_t>(b.x) - a.x;
    if (a.x < 0) {
      const auto outside =
          static_cast<std::int32_t>(-static_cast<std::int64_t>(a.x) * height / width);
      add_cells(0, 0, outside * sign, limit);
      const std::int32_t end = b.x > limit ? limit : b.x;
      const auto beyond =
          static_cast<std::int32_t>((static_cast<std::int64_t>(b.x) - end) * height / width);
      return add_cells(0, end, (height - outside - beyond) * sign, limit);
    }
    if (b.x > limit) {
      height = static_cast<std::int32_t>((static_cast<std::int64_t>(limit) - a.x) * height / width);
      return add_cells(a.x, limit, height * sign, limit);
    }
    add_cells(a.x, b.x, height * sign, limit);
  }

  /// `height` spread evenly from x0 to x1, both within the picture.
  void add_cells(std::int32_t x0, std::int32_t x1, std::int32_t height, std::int32_t limit) {
    if (height == 0 || x0 >= limit) return;
    const int first = x0 / kOne;
    const int last = x1 / kOne;
    if (first < left_) left_ = first;
    if (last + 1 > right_) right_ = last + 1 > limit / kOne ? limit / kOne : last + 1;
    if (first == last) return add_cell(first, height, (x0 + x1) - 2 * first * kOne);
    const std::int32_t width = x1 - x0;
    std::int32_t done = 0;
    for (int c = first; c <= last; ++c) {
      const std::int32_t from = c == first ? x0 : c * kOne;
      const std::int32_t to = c == last ? x1 : (c + 1) * kOne;
      const auto upto =
          static_cast<std::int32_t>(static_cast<std::int64_t>(to - x0) * height / width);
      if (to > from) add_cell(c, upto - done, (from + to) - 2 * c * kOne);
      done = upto;
    }
  }
  /// `middle`: twice the position in the cell, 0 to 512; the area right of it is covered.
  void add_cell(int c, std::int32_t height, std::int32_t middle) {
    const std::int32_t uncovered = height * middle;
    cell_[c] += height * 2 * kOne - uncovered;
    cell_[c + 1] += uncovered;
  }

  static void blend(std::uint8_t* pixel, int channels, const Paint& paint, std::int32_t part) {
    const auto mix = [part](std::uint8_t& value, std::int32_t wanted) {
      value = static_cast<std::uint8_t>(value + (((wanted - value) * part + 128) >> 8));
    };
    if (channels == 1) return mix(*pixel, grey_of(paint));
    mix(pixel[0], paint.red);
    mix(pixel[1], paint.green);
    mix(pixel[2], paint.blue);
  }

  static constexpr std::int32_t kWhole = 2 * kOne * kOne;  // of a cell that is covered
  Edge edge_[kMaxEdges]{};
  std::size_t edges_ = 0;
  std::int32_t cell_[kMaxWidth + 2]{};  // of a row; all 0 between rows
  int left_ = 0, right_ = 0;
};

}  // namespace eagerx::picture
