// Shapes of the plane as outlines in pixels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/picture/coverage.hpp>
#include <eagerx/picture/glyphs.hpp>
#include <eagerx/scene.hpp>
#include <numbers>

namespace eagerx::picture {

/// Maps lengths to pixels.
struct Frame {
  float left = 0.0F, bottom = 0.0F;      // of the origin, in pixels from the top left
  float x_scale = 0.0F, y_scale = 0.0F;  // pixels
  float scale = 0.0F;                    // of lengths that have no direction
  constexpr Point2 operator()(Point2 p) const {
    return {left + p.x * x_scale, bottom - p.y * y_scale};
  }
};

/// Points on a circle: cosines of k/64 of a turn.
inline constexpr int kTurn = 64;
inline constexpr auto kCosines = [] {
  std::array<float, kTurn> table{};
  for (int i = 0; i < kTurn; ++i)
    table[static_cast<std::size_t>(i)] =
        eagerx::cos(static_cast<float>(i) * (2.0F * std::numbers::pi_v<float> / kTurn));
  return table;
}();
constexpr Point2 on_circle(int k) {
  return {kCosines[static_cast<std::size_t>(k & (kTurn - 1))],
          kCosines[static_cast<std::size_t>((k - kTurn / 4) & (kTurn - 1))]};
}
/// The stride between points that is enough for a circle of this radius in pixels.
constexpr int stride_of(float radius) {
  return radius < 1.5F ? 8 : radius < 5.0F ? 4 : radius < 12.0F ? 2 : 1;
}
/// The factor by which a polygon with this stride must be larger to have the circle's area.
constexpr float swell_of(int stride) {
  return stride == 8 ? 1.0539F : stride == 4 ? 1.0130F : stride == 2 ? 1.0032F : 1.0008F;
}

/// Paints planar shapes. All coordinates are in pixels, y downward.
template <std::size_t kMaxEdges, std::size_t kMaxWidth>
class Brush {
 public:
  void begin(const Image& image) { image_ = image; }
  const Image& image() const { return image_; }
  void dip(const Paint& paint) { paint_ = paint; }
  /// Paints the shapes added since the last call.
  void paint() {
    outline_.fill(image_, paint_);
    outline_.clear();
  }

  /// A convex polygon in either direction; at most kTurn + 2 points.
  void add_convex(const Point2* p, std::size_t count) {
    std::array<Fixed, kMost> fixed{};
    std::int64_t area = 0;
    for (std::size_t i = 0; i < count; ++i) fixed[i] = {to_fixed(p[i].x), to_fixed(p[i].y)};
    for (std::size_t i = 0; i < count; ++i) {
      const Fixed& a = fixed[i];
      const Fixed& b = fixed[i + 1 == count ? 0 : i + 1];
      area += static_cast<std::int64_t>(a.x) * b.y - static_cast<std::int64_t>(b.x) * a.y;
    }
    make_room(count);
    outline_.add(fixed.data(), count, area > 0);
  }
  /// Any polygon, alone in its outline.
  void add_polygon(const Point2* p, std::size_t count) {
    std::array<Fixed, kMost> fixed{};
    for (std::size_t i = 0; i < count; ++i) fixed[i] = {to_fixed(p[i].x), to_fixed(p[i].y)};
    outline_.add(fixed.data(), count);
  }

  void add_disc(Point2 middle, float radius, bool is_hole = false) {
    std::array<Fixed, kMost> p{};
    std::size_t count = 0;
    const int stride = stride_of(radius);
    const float r = radius * swell_of(stride);
    for (int k = 0; k < kTurn; k += stride) {
      const Point2 c = on_circle(k);
      p[count++] = {to_fixed(middle.x + r * c.x), to_fixed(middle.y + r * c.y)};
    }
    if (!is_hole) make_room(count);
    outline_.add(p.data(), count, !is_hole);
  }
  void add_ring(Point2 middle, float radius, float width) {
    add_disc(middle, radius + 0.5F * width);
    if (radius > 0.5F * width) add_disc(middle, radius - 0.5F * width, true);
  }

  /// The area that two discs and their common tangents enclose.
  void add_hull(Point2 a, float radius_a, Point2 b, float radius_b) {
    const float dx = b.x - a.x, dy = b.y - a.y;
    const float length = eagerx::sqrt(dx * dx + dy * dy);
    const float larger = radius_a > radius_b ? radius_a : radius_b;
    const float inset = radius_a > radius_b ? radius_a - radius_b : radius_b - radius_a;
    const float tilt = (radius_a - radius_b) / length;
    if (!(length > inset) || !(length > 0.001F) || !(tilt > -1.0F && tilt < 1.0F))
      return add_disc(radius_a >= radius_b ? a : b, larger);
    const float c = dx / length, s = dy / length;
    // Where the lines touch, counted from the direction from a to b: cosine (ra - rb) / length.
    const int half =
        kTurn / 4 - static_cast<int>(eagerx::round(eagerx::asin(tilt) *
                                                   (kTurn / (2.0F * std::numbers::pi_v<float>))));
    const int step = stride_of(larger);
    std::array<Point2, kMost> p{};
    std::size_t count = 0;
    const auto add = [&](Point2 middle, float radius, int k) {
      const Point2 u = on_circle(k);
      p[count++] = {middle.x + radius * (u.x * c - u.y * s),
                    middle.y + radius * (u.x * s + u.y * c)};
    };
    for (int k = -half; k < half; k += step) add(b, radius_b, k);
    add(b, radius_b, half);
    for (int k = half; k < kTurn - half; k += step) add(a, radius_a, k);
    add(a, radius_a, kTurn - half);
    add_convex(p.data(), count);
  }
  void add_line(Point2 a, Point2 b, float width) { add_hull(a, 0.5F * width, b, 0.5F * width); }

  void add_path(const Point2* p, std::size_t count, float width, bool closed) {
    for (std::size_t i = 0; i + 1 < count; ++i) add_line(p[i], p[i + 1], width);
    if (closed) add_line(p[count - 1], p[0], width);
  }

  /// Corners are round; `grow` moves all sides outward.
  void add_rectangle(const Frame& frame, const float* n, float grow, bool is_hole) {
    const float c = eagerx::cos(n[4]), s = eagerx::sin(n[4]);
    float corner = eagerx::max(n[5], 0.0F) + grow;
    corner = eagerx::max(corner, 0.0F);
    const float w = eagerx::max(0.5F * n[2] + grow - corner, 0.0F);
    const float h = eagerx::max(0.5F * n[3] + grow - corner, 0.0F);
    std::array<Fixed, kMost> p{};
    std::size_t count = 0;
    const int step = corner > 0.0F ? stride_of(corner * frame.scale) : kTurn / 4;
    for (int quarter = 0; quarter < 4; ++quarter) {
      const float x = quarter == 0 || quarter == 3 ? w : -w;
      const float y = quarter < 2 ? h : -h;
      for (int k = 0; k <= kTurn / 4; k += step) {
        if (corner == 0.0F && k > 0) break;
        const Point2 u = on_circle(quarter * (kTurn / 4) + k);
        const float px = x + corner * u.x, py = y + corner * u.y;
        const Point2 at = frame({n[0] + px * c - py * s, n[1] + px * s + py * c});
        p[count++] = {to_fixed(at.x), to_fixed(at.y)};
      }
    }
    outline_.add(p.data(), count, !is_hole);
  }

  void add_arrow(Point2 a, Point2 b, float head, float width) {
    const float dx = b.x - a.x, dy = b.y - a.y;
    const float length = eagerx::sqrt(dx * dx + dy * dy);
    if (!(length > 0.5F)) return;
    const float size = eagerx::min(head, length);
    const float c = dx / length, s = dy / length;
    const Point2 base{b.x - size * c, b.y - size * s};
    if (length > size) add_line(a, base, width);
    const float half = 0.5F * size;
    const Point2 p[] = {
        b, {base.x - half * s, base.y + half * c}, {base.x + half * s, base.y - half * c}};
    add_convex(p, 3);
  }

  /// `at`: the left, middle or right end of the line that the text stands on; painted at once.
  void paint_text(Point2 at, float height, const Line& line, Align align) {
    const float unit = height / kGlyphHeight;
    int width = 0;
    for (std::size_t i = 0; i < line.size(); ++i) width += glyph_of(line[i]).width + kGlyphGap;
    if (width > 0) width -= kGlyphGap;
    const float share = align == Align::left ? 0.0F : align == Align::middle ? 0.5F : 1.0F;
    at.x -= share * static_cast<float>(width) * unit;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Glyph& glyph = glyph_of(line[i]);
      add_glyph(glyph, at, unit);
      paint();
      at.x += static_cast<float>(glyph.width + kGlyphGap) * unit;
    }
  }

 private:
  static constexpr std::size_t kMost = kTurn + 8;

  void make_room(std::size_t edges) {
    if (!outline_.has_room(edges)) paint();
  }

  void add_glyph(const Glyph& glyph, Point2 at, float unit) {
    const float width = eagerx::max(unit, 1.1F);
    std::array<Point2, 12> p{};
    const std::string_view text = glyph.strokes;
    for (std::size_t i = 0; i < text.size();) {
      const bool curved = text[i] == '~';
      if (curved) ++i;
      std::size_t count = 0;
      for (; i + 1 < text.size() && text[i] != ' '; i += 2)
        p[count++] = {at.x + static_cast<float>(glyph_x(text[i])) * unit,
                      at.y - static_cast<float>(glyph_y(text[i + 1])) * unit};
      ++i;
      if (curved)
        add_curve(p.data(), count, width);
      else
        add_path(p.data(), count, width, false);
    }
  }

  /// Parabolas that touch the lines between the points in their middles.
  void add_curve(const Point2* p, std::size_t count, float width) {
    const int pieces = width < 1.5F ? 3 : width < 4.0F ? 5 : 8;
    Point2 from = p[0];
    for (std::size_t i = 1; i + 1 < count; ++i) {
      const bool last = i + 2 == count;
      const Point2 to =
          last ? p[i + 1] : Point2{0.5F * (p[i].x + p[i + 1].x), 0.5F * (p[i].y + p[i + 1].y)};
      Point2 before = from;
      for (int k = 1; k <= pieces; ++k) {
        const float t = static_cast<float>(k) / static_cast<float>(pieces), u = 1.0F - t;
        const Point2 next{u * u * from.x + 2.0F * u * t * p[i].x + t * t * to.x,
                          u * u * from.y + 2.0F * u * t * p[i].y + t * t * to.y};
        add_line(before, next, width);
        before = next;
      }
      from = to;
    }
  }

  Image image_{};
  Paint paint_{};
  Outline<kMaxEdges, kMaxWidth> outline_{};
};

}  // namespace eagerx::picture
