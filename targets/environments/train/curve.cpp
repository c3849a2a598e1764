#include "targets/environments/train/curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>

namespace eagerx::train {
namespace {

std::string cell(double x) {
  return std::isnan(x) ? std::string() : fmt::format("{:.7g}", x);
}

/// The plane of the picture in its units.
struct Plane {
  static constexpr double kLeft = 70, kRight = 570, kTop = 66, kBottom = 300;
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

/// "0", "50 k", "1.5 M"
std::string steps_text(double steps) {
  constexpr double kMillion = 1e6, kThousand = 1e3;
  if (steps >= kMillion) return fmt::format("{:g} M", steps / kMillion);
  if (steps >= kThousand) return fmt::format("{:g} k", steps / kThousand);
  return fmt::format("{:g}", steps);
}

/// An entry of the legend, in a row below the title.
struct Meaning {
  const char* colour;
  const char* text;
};
std::string legend(std::initializer_list<Meaning> meanings) {
  std::string text;
  double x = Plane::kLeft;
  for (const auto& [colour, meaning] : meanings) {
    text +=
        fmt::format("<path stroke=\"{}\" stroke-width=\"2\" d=\"M{:.1f} 38h18\"/>\n", colour, x);
    text += label(x + 22, 42, "start", meaning);
    x += 34 + 6.1 * static_cast<double>(std::string_view(meaning).size());
  }
  return text;
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
    text += label(plane.x(steps), Plane::kBottom + 18, "middle", steps_text(steps));
  }
  return text;
}

constexpr std::string_view kColumns =
    "steps,return,success_rate,eval_return,eval_success_rate,std,learning_rate,approx_kl,stage,"
    "stage_success_rate,stage_return";

std::string row_of(const CurvePoint& point) {
  return fmt::format("{:.0f},{},{},{},{},{},{},{},{},{},{}\n", point.steps, cell(point.mean_return),
                     cell(point.success), cell(point.evaluation_return),
                     cell(point.evaluation_success), cell(point.deviation), cell(point.step_size),
                     cell(point.divergence), cell(point.stage), cell(point.stage_success),
                     cell(point.stage_return));
}

/// The plane in which all returns lie.
Plane plane_of(const std::vector<std::vector<CurvePoint>>& trainings) {
  Plane plane{1.0, 0.0, 0.0};
  bool any = false;
  for (const std::vector<CurvePoint>& points : trainings) {
    if (!points.empty()) plane.last_step = std::max(plane.last_step, points.back().steps);
    for (const CurvePoint& point : points) {
      for (const double value : {point.mean_return, point.evaluation_return}) {
        if (std::isnan(value)) continue;
        plane.low = any ? std::min(plane.low, value) : value;
        plane.high = any ? std::max(plane.high, value) : value;
        any = true;
      }
    }
  }
  if (plane.high - plane.low < 1e-9) plane.high = plane.low + 1.0;
  return plane;
}

/// Everything but the curves.
std::string head(const Plane& plane, const Plane& share, const std::string& title) {
  std::string text =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"640\" height=\"360\" viewBox=\"0 0 640 "
      "360\" font-family=\"sans-serif\" font-size=\"12\">\n"
      "<rect width=\"640\" height=\"360\" fill=\"white\"/>\n";
  text += label(320, 20, "middle", title) + grid(plane);
  text += label((Plane::kLeft + Plane::kRight) / 2.0, 350, "middle", "steps");
  text += label(Plane::kLeft - 6, Plane::kTop - 8, "end", "return");
  text += label(Plane::kRight + 6, Plane::kTop - 8, "start", "success");
  for (const int percent : {0, 50, 100}) {
    text += label(Plane::kRight + 6, share.y(percent / 100.0) + 4, "start",
                  fmt::format("{} %", percent));
  }
  return text;
}

/// Of several trainings at one number of steps.
struct Spread {
  double steps, low, mean, high;
};

template <class Value>
std::vector<Spread> band_of(const std::vector<std::vector<CurvePoint>>& trainings, Value value) {
  std::vector<double> all;
  for (const auto& points : trainings) {
    for (const CurvePoint& point : points) {
      if (!std::isnan(value(point))) all.push_back(point.steps);
    }
  }
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  std::vector<Spread> band;
  for (const double steps : all) {
    Spread spread{steps, INFINITY, 0.0, -INFINITY};
    double count = 0.0;
    for (const auto& points : trainings) {
      double last = NAN;
      for (const CurvePoint& point : points) {
        if (point.steps <= steps && !std::isnan(value(point))) last = value(point);
      }
      if (std::isnan(last)) continue;
      spread.low = std::min(spread.low, last);
      spread.high = std::max(spread.high, last);
      spread.mean += last;
      count += 1.0;
    }
    spread.mean /= count;
    band.push_back(spread);
  }
  return band;
}

std::string band(const std::vector<Spread>& spreads, const Plane& plane, const char* colour) {
  std::string there, back, mean;
  for (const Spread& each : spreads) {
    const auto place = [&](double value) {
      return fmt::format("{:.1f},{:.1f} ", plane.x(each.steps), plane.y(value));
    };
    there += place(each.high);
    back.insert(0, place(each.low));
    mean += place(each.mean);
  }
  return fmt::format(
      "<polygon fill=\"{0}\" fill-opacity=\"0.2\" points=\"{1}{2}\"/>\n<polyline fill=\"none\" "
      "stroke=\"{0}\" stroke-width=\"1.5\" points=\"{3}\"/>\n",
      colour, there, back, mean);
}

}  // namespace

std::string curve_csv(const std::vector<CurvePoint>& points) {
  std::string text = std::string(kColumns) + "\n";
  for (const CurvePoint& point : points) text += row_of(point);
  return text;
}

std::string curves_csv(const std::vector<std::vector<CurvePoint>>& trainings,
                       std::uint64_t first_seed) {
  std::string text = "seed," + std::string(kColumns) + "\n";
  for (std::size_t i = 0; i < trainings.size(); ++i) {
    for (const CurvePoint& point : trainings[i])
      text += fmt::format("{},{}", first_seed + i, row_of(point));
  }
  return text;
}

std::string curve_svg(const std::vector<CurvePoint>& points, const std::string& title) {
  const Plane plane = plane_of({points});
  const Plane share{plane.last_step, 0.0, 1.0};
  return head(plane, share, title) +
         line(points, share, "#9c9", [](const CurvePoint& p) { return p.success; }) +
         line(points, share, "#393", [](const CurvePoint& p) { return p.evaluation_success; }) +
         line(points, plane, "#9bd", [](const CurvePoint& p) { return p.mean_return; }) +
         line(points, plane, "#057", [](const CurvePoint& p) { return p.evaluation_return; }) +
         legend({{"#9bd", "return, training"},
                 {"#057", "return, evaluation"},
                 {"#9c9", "success, training"},
                 {"#393", "success, evaluation"}}) +
         "</svg>\n";
}

std::string curves_svg(const std::vector<std::vector<CurvePoint>>& trainings,
                       const std::string& title) {
  const Plane plane = plane_of(trainings);
  const Plane share{plane.last_step, 0.0, 1.0};
  const auto successes =
      band_of(trainings, [](const CurvePoint& p) { return p.evaluation_success; });
  const auto returns = band_of(trainings, [](const CurvePoint& p) { return p.evaluation_return; });
  return head(plane, share, title) + band(successes, share, "#393") + band(returns, plane, "#057") +
         legend({{"#057", "return, evaluation"}, {"#393", "success, evaluation"}}) +
         label(Plane::kRight, 42, "end",
               fmt::format("mean, least and most of {} seeds", trainings.size())) +
         "</svg>\n";
}

}  // namespace eagerx::train
