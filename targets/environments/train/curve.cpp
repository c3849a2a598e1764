#include "targets/environments/train/curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace eagerx::train {
namespace {

std::string cell(double x) {
  return std::isnan(x) ? std::string() : fmt::format("{:.7g}", x);
}

/// The plane of the picture in its units.
struct Plane {
  static constexpr double kLeft = 70, kRight = 570, kTop = 40, kBottom = 300;
  double last_step, low, high;

  double x(double steps) const { return kLeft + (kRight - kLeft) * steps / last_step; }
  double y(double value) const { return kBottom - (kBottom - kTop) * (value - low) / (high - low); }
};

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '<')
      result += "&lt;";
    else if (c == '&')
      result += "&amp;";
    else
      result += c;
  }
  return result;
}

template <class Value>
std::string line(const std::vector<CurvePoint>& points, const Plane& plane, const char* colour,
                 Value value) {
  std::string path;
  for (const CurvePoint& point : points) {
    const double y = value(point);
    if (std::isnan(y)) continue;
    path += fmt::format("{:.1f},{:.1f} ", plane.x(point.steps), plane.y(y));
  }
  return fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\" points=\"{}\"/>\n",
                     colour, path);
}

std::string label(double x, double y, const char* anchor, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     escaped(text));
}

/// 1, 2 or 5 times a power of ten: about five of them are `span`.
double spacing(double span) {
  constexpr double kLines = 5;
  const double power = std::pow(10.0, std::floor(std::log10(span / kLines)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power * kLines >= span) return factor * power;
  }
  return 10.0 * power;
}

std::string grid(const Plane& plane) {
  std::string text;
  const double rise = spacing(plane.high - plane.low);
  for (double value = std::ceil(plane.low / rise) * rise; value <= plane.high; value += rise) {
    const double y = plane.y(value);
    text += fmt::format("<path stroke=\"#ddd\" d=\"M{} {:.1f}H{}\"/>\n", Plane::kLeft, y,
                        Plane::kRight);
    text += label(Plane::kLeft - 6, y + 4, "end", fmt::format("{:.6g}", value + 0.0));
  }
  const double stride = spacing(plane.last_step);
  for (double steps = 0; steps <= plane.last_step; steps += stride) {
    text += label(plane.x(steps), Plane::kBottom + 18, "middle", fmt::format("{:g}", steps / 1e6));
  }
  return text;
}

}  // namespace

std::string curve_csv(const std::vector<CurvePoint>& points) {
  std::string text =
      "steps,return,success,evaluation_return,evaluation_success,deviation,step_size,divergence\n";
  for (const CurvePoint& point : points) {
    text += fmt::format("{:.0f},{},{},{},{},{},{},{}\n", point.steps, cell(point.mean_return),
                        cell(point.success), cell(point.evaluation_return),
                        cell(point.evaluation_success), cell(point.deviation),
                        cell(point.step_size), cell(point.divergence));
  }
  return text;
}

std::string curve_svg(const std::vector<CurvePoint>& points, const std::string& title) {
  Plane plane{points.empty() ? 1.0 : points.back().steps, 0.0, 0.0};
  bool any = false;
  for (const CurvePoint& point : points) {
    for (const double value : {point.mean_return, point.evaluation_return}) {
      if (std::isnan(value)) continue;
      plane.low = any ? std::min(plane.low, value) : value;
      plane.high = any ? std::max(plane.high, value) : value;
      any = true;
    }
  }
  if (plane.high - plane.low < 1e-9) plane.high = plane.low + 1.0;
  const Plane share{plane.last_step, 0.0, 1.0};
  std::string text =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"640\" height=\"360\" viewBox=\"0 0 640 "
      "360\" font-family=\"sans-serif\" font-size=\"12\">\n"
      "<rect width=\"640\" height=\"360\" fill=\"white\"/>\n";
  text += label(320, 22, "middle", title);
  text += grid(plane);
  for (const int percent : {0, 50, 100}) {
    text += label(Plane::kRight + 6, share.y(percent / 100.0) + 4, "start",
                  fmt::format("{} %", percent));
  }
  text += line(points, share, "#9c9", [](const CurvePoint& p) { return p.success; });
  text += line(points, share, "#393", [](const CurvePoint& p) { return p.evaluation_success; });
  text += line(points, plane, "#9bd", [](const CurvePoint& p) { return p.mean_return; });
  text += line(points, plane, "#057", [](const CurvePoint& p) { return p.evaluation_return; });
  text += label(320, 350, "middle",
                "million steps; blue: return, green: success, of the last 100 episodes (dark: "
                "evaluation without noise)");
  return text + "</svg>\n";
}

}  // namespace eagerx::train
