// The picture of a learning curve.
#include "targets/environments/train/curve.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace eagerx::train {
namespace {

TEST(TrainCurve, HasItsLegendAndStepsAtTheAxis) {
  std::vector<CurvePoint> points;
  for (int i = 1; i <= 40; ++i)
    points.push_back({50e3 * i, -300.0 + i, i / 40.0, -280.0 + i, i / 40.0, 0.5, 1e-3, 0.01});
  const std::string one = curve_svg(points, "pendulum");
  for (const std::string text :
       {">steps<", ">500 k<", ">1.5 M<", ">return<", ">success<", ">return, training<",
        ">return, evaluation<", ">success, training<", ">success, evaluation<"})
    EXPECT_NE(one.find(text), std::string::npos) << text;
  const std::string several = curves_svg({points, points}, "pendulum");
  for (const std::string text : {">steps<", ">return, evaluation<", ">success, evaluation<",
                                 ">mean, least and most of 2 seeds<"})
    EXPECT_NE(several.find(text), std::string::npos) << text;
}

}  // namespace
}  // namespace eagerx::train
