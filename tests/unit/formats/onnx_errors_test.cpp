// Files that are broken or lie: exactly one diagnostic, with the right code, that names the
// culprit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "generator/policy/formats/read.hpp"
#include "tests/unit/formats/onnx_builder.hpp"

namespace eagerx::gen {
namespace {

using test::expect_problem;
using test::OnnxBuilder;
using test::read_bad;
using testing::HasSubstr;

/// With the name of the file in the message.
void expect_named(const Diagnostic& diagnostic, const char* code, const char* part) {
  EXPECT_THAT(diagnostic.message, HasSubstr("policy `policy.onnx`"));
  expect_problem(diagnostic, code, part);
}

onnx::TensorShapeProto& input_shape(OnnxBuilder& builder) {
  return *builder.graph().mutable_input(0)->mutable_type()->mutable_tensor_type()->mutable_shape();
}

Diagnostic read_path(const std::string& path) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_policy(path, "policy.onnx", {}, diagnostics).has_value());
  EXPECT_EQ(diagnostics.all().size(), 1U);
  return diagnostics.all().front();
}

TEST(OnnxErrors, MissingFileIsAnIoError) {
  const Diagnostic diagnostic = read_path("/nonexistent/policy.onnx");
  expect_named(diagnostic, "E0601", "no such file");
  EXPECT_TRUE(diagnostic.io);
}

TEST(OnnxErrors, DirectoryIsAnIoError) {
  const Diagnostic diagnostic = read_path(EAGERX_SOURCE_DIR);
  expect_named(diagnostic, "E0601", "not a regular file");
  EXPECT_TRUE(diagnostic.io);
}

TEST(OnnxErrors, LargeFileIsNotRead) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / "eagerx_policy_too_large.onnx";
  std::ofstream(path) << "x";
  std::filesystem::resize_file(path, (std::uintmax_t{100} << 20U));  // sparse
  const Diagnostic diagnostic = read_path(path.string());
  std::filesystem::remove(path);
  expect_named(diagnostic, "E0602", "104857600 bytes");
  EXPECT_FALSE(diagnostic.io);
}

TEST(OnnxErrors, EmptyFile) {
  expect_named(read_bad(""), "E0603", "is empty");
}

TEST(OnnxErrors, OtherFormatsAreNamed) {
  expect_named(read_bad("PK\x03\x04 and so on"), "E0621", "zip archive without its directory");
  expect_named(read_bad("\x80\x04\x95 and so on"), "E0603", "Python pickle");
  expect_named(read_bad(std::string("\x40\0\0\0\0\0\0\0{\"a\": 1}", 16)), "E0604", "safetensors");
}

TEST(OnnxErrors, GarbageIsNotOnnx) {
  expect_named(read_bad("name: pendulum\nrate: 30\n"), "E0603", "is a text file");
  expect_named(read_bad(std::string(1000, '\xff')), "E0603", "none of the supported formats");
}

TEST(OnnxErrors, TruncatedFile) {
  std::string bytes = test::two_layers().bytes();
  bytes.resize(bytes.size() / 2);
  expect_named(read_bad(bytes), "E0604", "damaged or truncated");
}

TEST(OnnxErrors, ModelWithoutGraphOrOperatorSet) {
  OnnxBuilder builder = test::two_layers();
  builder.model.clear_graph();
  expect_named(read_bad(builder.bytes()), "E0605", "no graph");
  builder = test::two_layers();
  builder.model.clear_opset_import();
  expect_named(read_bad(builder.bytes()), "E0605", "no operator set");
}

TEST(OnnxErrors, OpsetFromAnotherTime) {
  OnnxBuilder builder = test::two_layers();
  builder.model.mutable_opset_import(0)->set_version(6);
  const Diagnostic diagnostic = read_bad(builder.bytes());
  expect_named(diagnostic, "E0605", "opset 6");
  EXPECT_EQ(diagnostic.help.text, "export it with an `opset_version` from 9 to 23");
}

TEST(OnnxErrors, NoOutput) {
  OnnxBuilder builder = test::two_layers();
  builder.graph().clear_output();
  expect_named(read_bad(builder.bytes()), "E0606", "without an output");
}

TEST(OnnxErrors, RowsThatAreAdded) {
  OnnxBuilder builder = test::two_layers();
  builder.add_input("goal", {1, 3, 3});
  builder.add_node("Add", {"g1", "goal"}, "sum");
  builder.graph().mutable_node(1)->set_input(0, "sum");
  expect_named(read_bad(builder.bytes()), "E0613", "does not add a constant");
}

TEST(OnnxErrors, BatchOfObservations) {
  OnnxBuilder builder = test::two_layers();
  input_shape(builder).mutable_dim(0)->set_dim_value(4);
  expect_named(read_bad(builder.bytes()), "E0608", "batch of 4");
}

TEST(OnnxErrors, InputOfUnknownSize) {
  OnnxBuilder builder = test::two_layers();
  input_shape(builder).mutable_dim(1)->set_dim_param("n");
  expect_named(read_bad(builder.bytes()), "E0608", "unknown size");
  builder.graph().mutable_input(0)->clear_type();
  expect_named(read_bad(builder.bytes()), "E0608", "unknown shape");
}

TEST(OnnxErrors, InputOfImpossibleSize) {
  OnnxBuilder builder = test::two_layers();
  for (int i = 0; i < 3; ++i) {
    input_shape(builder).add_dim()->set_dim_value(std::numeric_limits<std::int64_t>::max());
  }
  expect_named(read_bad(builder.bytes()), "E0608", "impossible size");
}

TEST(OnnxErrors, InputOfIntegers) {
  OnnxBuilder builder = test::two_layers();
  builder.graph().mutable_input(0)->mutable_type()->mutable_tensor_type()->set_elem_type(
      onnx::TensorProto::INT64);
  expect_named(read_bad(builder.bytes()), "E0608", "type INT64");
}

TEST(OnnxErrors, MissingTensor) {
  OnnxBuilder builder = test::two_layers();
  builder.graph().mutable_initializer(0)->set_name("w1_renamed");
  expect_named(read_bad(builder.bytes()), "E0609", "`w1`");
}

TEST(OnnxErrors, DanglingOutput) {
  OnnxBuilder builder = test::two_layers();
  builder.graph().mutable_output(0)->set_name("nothing");
  expect_named(read_bad(builder.bytes()), "E0609", "`nothing`");
}

TEST(OnnxErrors, Cycle) {
  OnnxBuilder builder = test::two_layers();
  builder.graph().mutable_node(0)->set_input(0, "h1");
  expect_named(read_bad(builder.bytes()), "E0610", "`h1`");
}

TEST(OnnxErrors, NameDefinedTwice) {
  OnnxBuilder builder = test::two_layers();
  builder.graph().mutable_node(1)->set_output(0, "g1");
  expect_named(read_bad(builder.bytes()), "E0611", "`g1` twice");
  builder = test::two_layers();
  builder.add_tensor("w1", {1}, {1});
  expect_named(read_bad(builder.bytes()), "E0611", "`w1` twice");
}

TEST(OnnxErrors, UnsupportedOperatorIsNamedWithTheSupportedOnes) {
  OnnxBuilder builder = test::two_layers();
  builder.graph().mutable_node(1)->set_op_type("Softsign");
  const Diagnostic diagnostic = read_bad(builder.bytes());
  expect_named(diagnostic, "E0612", "operator `Softsign`");
  EXPECT_THAT(diagnostic.help.text,
              HasSubstr("Identity, LSTM, LayerNormalization, LeakyRelu, Less, "
                        "LessOrEqual, LogSoftmax, MatMul, Max, MaxPool"));
}

TEST(OnnxErrors, WholeNumberOperatorsHaveAnotherForm) {
  for (const char* type : {"QLinearMatMul", "MatMulInteger", "DynamicQuantizeLinear"}) {
    OnnxBuilder builder = test::two_layers();
    builder.add_node(type, {"g1"}, "real");
    builder.graph().mutable_node(1)->set_input(0, "real");
    EXPECT_THAT(read_bad(builder.bytes()).help.text, HasSubstr("`QuantFormat.QDQ`")) << type;
  }
}

TEST(OnnxErrors, OperatorOfAnotherDomain) {
  OnnxBuilder builder = test::two_layers();
  builder.graph().mutable_node(1)->set_domain("com.microsoft");
  expect_named(read_bad(builder.bytes()), "E0612", "operator `Relu` of `com.microsoft`");
}

TEST(OnnxErrors, StochasticActor) {
  OnnxBuilder builder = test::two_layers();
  builder.add_node("RandomNormalLike", {"action"}, "noise");
  builder.add_node("Add", {"action", "noise"}, "noisy");
  builder.graph().mutable_output(0)->set_name("noisy");
  const Diagnostic diagnostic = read_bad(builder.bytes());
  expect_named(diagnostic, "E0612", "RandomNormalLike");
  EXPECT_THAT(diagnostic.help.text, HasSubstr("deterministic=True"));
}

TEST(OnnxErrors, OperatorUsedInAWayThatIsNotALayer) {
  OnnxBuilder builder = test::two_layers();
  builder.graph().mutable_node(2)->set_input(1, "h1");
  expect_named(read_bad(builder.bytes()), "E0613", "without exactly one constant matrix");
  builder = test::two_layers();
  builder.add_tensor("zero", {}, {0});
  builder.add_node("Div", {"action", "zero"}, "more");
  builder.graph().mutable_output(0)->set_name("more");
  expect_named(read_bad(builder.bytes()), "E0616", "divides by zero");
  builder = test::two_layers();
  builder.add_node("Erf", {"action"}, "more");
  builder.graph().mutable_output(0)->set_name("more");
  expect_named(read_bad(builder.bytes()), "E0613", "not a part of a LayerNorm or a gelu");
}

TEST(OnnxErrors, DimensionsThatDoNotFitTheData) {
  OnnxBuilder builder = test::two_layers();
  builder.graph().mutable_initializer(0)->set_dims(0, 4);
  expect_named(read_bad(builder.bytes()), "E0614", "`w1` has shape [4, 2], but holds 6 values");
}

TEST(OnnxErrors, RawDataThatIsCutShort) {
  OnnxBuilder builder = test::two_layers();
  onnx::TensorProto& weights = *builder.graph().mutable_initializer(0);
  weights.clear_float_data();
  weights.set_raw_data(std::string(23, '\0'));
  expect_named(read_bad(builder.bytes()), "E0614", "holds 5 values and a rest");
}

TEST(OnnxErrors, HugeDimensionsDoNotOverflow) {
  constexpr std::int64_t kMax = std::numeric_limits<std::int64_t>::max();
  const std::int64_t cases[][2] = {{kMax, kMax},
                                   {std::int64_t{1} << 32U, std::int64_t{1} << 32U},
                                   {-1, -6},
                                   {kMax, 0},
                                   {std::int64_t{1} << 62U, 4},
                                   {std::numeric_limits<std::int64_t>::min(), 2}};
  for (const auto& dims : cases) {
    OnnxBuilder builder = test::two_layers();
    builder.graph().mutable_initializer(0)->set_dims(0, dims[0]);
    builder.graph().mutable_initializer(0)->set_dims(1, dims[1]);
    expect_named(read_bad(builder.bytes()), "E0614", "`w1`");
  }
}

TEST(OnnxErrors, TypesThatAreNotRead) {
  OnnxBuilder builder = test::two_layers();
  onnx::TensorProto& weights = *builder.graph().mutable_initializer(0);
  weights.set_data_type(12345);
  expect_named(read_bad(builder.bytes()), "E0615", "type number 12345");
  weights.clear_float_data();
  for (int i = 0; i < 6; ++i) weights.add_int32_data(i);
  weights.set_data_type(onnx::TensorProto::INT16);
  expect_named(read_bad(builder.bytes()), "E0615", "type INT16");
  weights.set_data_type(onnx::TensorProto::INT32);
  expect_named(read_bad(builder.bytes()), "E0615", "type INT32");
}

TEST(OnnxErrors, Float64ThatFloat32CannotHold) {
  for (const double value : {0.1, 1e300, 1e-300}) {
    OnnxBuilder builder = test::two_layers();
    onnx::TensorProto& bias = *builder.graph().mutable_initializer(3);
    bias.clear_float_data();
    bias.set_data_type(onnx::TensorProto::DOUBLE);
    bias.add_double_data(value);
    const Diagnostic diagnostic = read_bad(builder.bytes());
    expect_named(diagnostic, "E0615", "tensor `b2` that float32 cannot hold");
  }
}

TEST(OnnxErrors, WeightsThatAreNotNumbers) {
  OnnxBuilder builder = test::two_layers();
  builder.graph().mutable_initializer(0)->set_float_data(4,
                                                         std::numeric_limits<float>::quiet_NaN());
  expect_named(read_bad(builder.bytes()), "E0616", "NaN in tensor `w1`");
  builder = test::two_layers();
  builder.graph().mutable_initializer(3)->set_float_data(0,
                                                         -std::numeric_limits<float>::infinity());
  expect_named(read_bad(builder.bytes()), "E0616", "infinity in tensor `b2`");
  builder = test::two_layers();
  builder.graph().mutable_initializer(0)->set_float_data(0, 1e30F);
  OnnxBuilder::set(*builder.graph().mutable_node(0), "alpha", 1e30F);
  expect_named(read_bad(builder.bytes()), "E0616", "`w1` into NaN or infinity");
}

TEST(OnnxErrors, ExternalData) {
  OnnxBuilder builder = test::two_layers();
  onnx::TensorProto& weights = *builder.graph().mutable_initializer(0);
  weights.clear_float_data();
  weights.set_data_location(onnx::TensorProto::EXTERNAL);
  onnx::StringStringEntryProto& entry = *weights.add_external_data();
  entry.set_key("location");
  entry.set_value("../../etc/passwd");
  expect_named(read_bad(builder.bytes()), "E0617", "which is not in the same folder");
}

/// Two layers whose first weights are in `location`, from `offset` on, `length` bytes.
std::string with_external(const char* location, const char* offset, const char* length) {
  OnnxBuilder builder = test::two_layers();
  onnx::TensorProto& weights = *builder.graph().mutable_initializer(0);
  weights.clear_float_data();
  weights.set_data_location(onnx::TensorProto::EXTERNAL);
  for (const auto& [key, value] : {std::pair{"location", location}, std::pair{"offset", offset},
                                   std::pair{"length", length}}) {
    onnx::StringStringEntryProto& entry = *weights.add_external_data();
    entry.set_key(key);
    entry.set_value(value);
  }
  return builder.bytes();
}

TEST(OnnxErrors, ExternalDataThatIsNotWhatItsTensorSays) {
  ReadContext context;
  context.files = [](const std::string& name, std::string& why) {
    why = "which is not there";
    return name == "w" ? std::optional(std::string(64, '\0')) : std::nullopt;
  };
  const auto problem = [&](const std::string& bytes) {
    Diagnostics diagnostics;
    const auto network = read_policy_bytes(bytes, "p", {}, diagnostics, context);
    return network ? std::string("none") : diagnostics.all().front().code;
  };
  for (const char* name : {"/w", "a/w", "..", ".", "", "\\w", "other"}) {
    EXPECT_EQ(problem(with_external(name, "0", "8")), "E0617") << name;
  }
  for (const char* number : {"65", "-1", "18446744073709551615", "1e3", "x", ""}) {
    EXPECT_EQ(problem(with_external("w", number, "8")), "E0617") << number;
    EXPECT_EQ(problem(with_external("w", "8", number)), "E0617") << number;
  }
  EXPECT_EQ(problem(with_external("w", "0", "5")), "E0614");
}

TEST(OnnxErrors, LayersThatDoNotFitTogether) {
  OnnxBuilder builder = test::two_layers();
  input_shape(builder).mutable_dim(1)->set_dim_value(3);
  expect_named(read_bad(builder.bytes()), "E0618", "3 values by tensor `w1`, which takes 2");
  builder = test::two_layers();
  builder.graph().mutable_node(2)->set_input(2, "b1");
  expect_named(read_bad(builder.bytes()), "E0618", "bias `b1` of shape [3] to 1 values");
}

TEST(OnnxErrors, SharedWeightsCannotMakeAHugeNetwork) {
  OnnxBuilder builder(8);
  builder.add_tensor("w", {8, 8}, std::vector<float>(64, 0.0F));
  std::string before = "observation";
  for (int i = 0; i < 1000; ++i) {
    const std::string after = "x" + std::to_string(i);
    builder.add_node("MatMul", {before.c_str(), "w"}, after.c_str());
    before = after;
  }
  builder.graph().mutable_output(0)->set_name(before);
  expect_named(read_bad(builder.bytes()), "E0619", "more than 256 layers");
}

TEST(OnnxErrors, OutputThatIsNoAction) {
  OnnxBuilder builder = test::two_layers();
  builder.graph().mutable_output(0)->set_name("observation");
  expect_named(read_bad(builder.bytes()), "E0620", "no layer");
  builder.graph().mutable_output(0)->set_name("w1");
  expect_named(read_bad(builder.bytes()), "E0620", "depends on no input");
  builder.add_node("Shape", {"action"}, "shape");
  builder.graph().mutable_output(0)->set_name("shape");
  expect_named(read_bad(builder.bytes()), "E0620", "constant");
}

TEST(OnnxErrors, NamesFromTheFileAreCleaned) {
  OnnxBuilder builder = test::two_layers();
  builder.graph().mutable_node(1)->set_op_type("Bad\n\x1b[31m`\xff" + std::string(500, 'x'));
  const Diagnostic diagnostic = read_bad(builder.bytes());
  EXPECT_EQ(diagnostic.code, "E0612");
  EXPECT_THAT(diagnostic.message, HasSubstr("`Bad??[31m??xxx"));
  EXPECT_LT(diagnostic.message.size(), 250U);
}

TEST(OnnxErrors, ADeepGraphNeedsNoDeepStack) {
  OnnxBuilder builder = test::two_layers();
  std::string before = "action";
  for (int i = 0; i < 50000; ++i) {
    const std::string after = "i" + std::to_string(i);
    builder.add_node("Identity", {before.c_str()}, after.c_str());
    before = after;
  }
  builder.graph().mutable_output(0)->set_name(before);
  EXPECT_EQ(test::read_good(builder.bytes()).layers.size(), 2U);
}

}  // namespace
}  // namespace eagerx::gen
