// Powers, sums over the last axis and halves, as exporters write out F.normalize and norms.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "generator/policy/network/evaluate.hpp"
#include "tests/unit/formats/onnx_builder.hpp"

namespace eagerx::gen {
namespace {

using test::OnnxBuilder;
using test::read_bad;
using test::read_good;
using testing::HasSubstr;

const std::vector<float> kObservation = {-3.0F, 0.5F, 2.0F};

void expect_near(const Network& network, const std::vector<double>& wanted) {
  const std::vector<float> answer = evaluate(network, kObservation);
  ASSERT_EQ(answer.size(), wanted.size());
  for (std::size_t i = 0; i < answer.size(); ++i) EXPECT_NEAR(answer[i], wanted[i], 1e-6) << i;
}

TEST(OnnxPowers, NormalizeAsTorch20ExportsIt) {
  OnnxBuilder builder(3, 13);
  builder.add_tensor("two", {}, {2});
  builder.add_tensor("half", {}, {0.5F});
  builder.add_tensor("epsilon", {}, {1e-12F});
  builder.add_integers("axes", {1});
  builder.add_node("Abs", {"observation"}, "magnitude");
  builder.add_node("Pow", {"magnitude", "two"}, "square");
  OnnxBuilder::set(builder.add_node("ReduceSum", {"square", "axes"}, "sum"), "keepdims",
                   std::int64_t{1});
  builder.add_node("Pow", {"sum", "half"}, "norm");
  builder.add_node("Clip", {"norm", "epsilon"}, "clipped");
  builder.add_node("Shape", {"observation"}, "shape");
  builder.add_node("Expand", {"clipped", "shape"}, "wide");
  builder.add_node("Div", {"observation", "wide"}, "action");
  const double norm = std::sqrt(9.0 + 0.25 + 4.0);
  expect_near(read_good(builder.bytes()), {-3.0 / norm, 0.5 / norm, 2.0 / norm});
}

TEST(OnnxPowers, SumsOverTheLastAxis) {
  struct Case {
    const char* type;
    double sum;
  };
  for (const auto& [type, sum] : {Case{"ReduceL1", 5.5}, Case{"ReduceL2", std::sqrt(13.25)},
                                  Case{"ReduceSum", -0.5}, Case{"ReduceSumSquare", 13.25}}) {
    OnnxBuilder builder(3, 18);
    builder.add_integers("axes", {-1});
    builder.add_node(type, {"observation", "axes"}, "action");
    expect_near(read_good(builder.bytes()), {sum});
  }
}

TEST(OnnxPowers, ExponentsThatAreProductsOrRoots) {
  struct Case {
    float exponent;
    double (*wanted)(double);
  };
  for (const Case& each :
       {Case{1.0F, [](double x) { return x; }}, Case{2.0F, [](double x) { return x * x; }},
        Case{3.0F, [](double x) { return x * x * x; }},
        Case{4.0F, [](double x) { return x * x * x * x; }}}) {
    OnnxBuilder builder(3, 18);
    builder.add_tensor("exponent", {}, {each.exponent});
    builder.add_tensor("zero", {}, {0});
    builder.add_node("Pow", {"observation", "exponent"}, "power");
    builder.add_node("Relu", {"power"}, "action");
    const auto of = [&each](double x) { return std::fmax(each.wanted(x), 0.0); };
    expect_near(read_good(builder.bytes()), {of(-3.0), of(0.5), of(2.0)});
  }
  OnnxBuilder builder(3, 18);
  builder.add_tensor("exponent", {}, {1.5F});
  builder.add_node("Pow", {"observation", "exponent"}, "action");
  EXPECT_THAT(read_bad(builder.bytes()).message, HasSubstr("an exponent other than"));
}

TEST(OnnxPowers, HalvesAreCalculatedInFloat32AndThatIsSaid) {
  for (const bool casts : {false, true}) {
    OnnxBuilder builder(3, 13);
    onnx::TensorProto& weights = builder.add_tensor("w", {3, 1}, {});
    weights.set_data_type(onnx::TensorProto::FLOAT16);
    for (const int bits : {0x3C00, 0x3800, 0xC000}) weights.add_int32_data(bits);  // 1, 0.5, -2
    const char* from = "observation";
    if (casts) {
      OnnxBuilder::set(builder.add_node("Cast", {"observation"}, "halves"), "to",
                       std::int64_t{onnx::TensorProto::FLOAT16});
      from = "halves";
    } else {
      builder.graph().mutable_input(0)->mutable_type()->mutable_tensor_type()->set_elem_type(
          onnx::TensorProto::FLOAT16);
    }
    builder.add_node("MatMul", {from, "w"}, "action");
    const Network network = read_good(builder.bytes());
    expect_near(network, {-3.0 + 0.25 - 4.0});
    EXPECT_THAT(network.assumed, testing::Contains(HasSubstr("float16")));
  }
}

}  // namespace
}  // namespace eagerx::gen
