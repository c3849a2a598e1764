// TorchScript archives that torch wrote, and changed ones: answers against torch's own
// (tests/data/policy/make_torchscript.py), refusals with the line of the code.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "generator/policy/formats/golden.hpp"
#include "generator/policy/formats/read.hpp"
#include "generator/policy/formats/tensors/archive.hpp"
#include "generator/policy/network/buffers.hpp"
#include "generator/policy/network/evaluate.hpp"
#include "tests/unit/formats/onnx_builder.hpp"
#include "tests/unit/formats/table_builder.hpp"

namespace eagerx::gen {
namespace {

using test::read_bad;
using test::read_good;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kFolder = EAGERX_SOURCE_DIR "/tests/data/policy/torchscript/";

std::string bytes_of(const std::string& file) {
  std::ifstream stream(kFolder + file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The largest difference to torch's answers, over the range of all answers; 1 if rows are missing.
double difference(const std::string& file) {
  const Network network = read_good(bytes_of(file));
  const std::size_t end = file.find_last_of(file.ends_with(".pt") ? '_' : '.');
  const std::string golden = file.substr(0, end) + "_golden.npz";
  Diagnostics diagnostics;
  const auto rows = read_golden(kFolder + golden, golden, {}, diagnostics);
  if (!rows || rows->observations.size() != 1000) return 1.0;
  double low = 1e9;
  double high = -1e9;
  double worst = 0.0;
  Memory<float> memory;
  for (std::size_t i = 0; i < rows->observations.size(); ++i) {
    if (starts_episode(*rows, i)) memory.clear();
    const auto answer = evaluate(network, input_of_row(network, *rows, i), &memory);
    for (std::size_t k = 0; k < answer.size(); ++k) {
      const double known = rows->outputs[i][k];
      low = std::min(low, known);
      high = std::max(high, known);
      worst = std::max(worst, std::fabs(static_cast<double>(answer[k]) - known));
    }
  }
  return worst / (high - low);
}

TEST(TorchScript, AnswersAsTorchDoes) {
  for (const char* file :
       {"mlp_scripted.pt",         "mlp_traced.pt",          "activations_scripted.pt",
        "activations_traced.pt",   "normalizer_scripted.pt", "normalizer_traced.pt",
        "identity_scripted.pt",    "lstm_scripted.pt",       "lstm_two_scripted.pt",
        "gru_scripted.pt",         "branches_scripted.pt",   "branches_traced.pt",
        "residual_scripted.pt",    "residual_traced.pt",     "by_hand_half.pt",
        "small_scripted.pt",       "branches.onnx",          "residual.onnx",
        "history_scripted.pt",     "history_traced.pt",      "history.onnx",
        "picture_scripted.pt",     "picture_traced.pt",      "conditions_scripted.pt",
        "conditions_traced.pt",    "conditions.onnx",        "reordered_traced.pt",
        "reordered.onnx",          "some_joints_traced.pt",  "kept_joints_traced.pt",
        "kept_frames_scripted.pt", "kept_flat_scripted.pt",  "kept_rolled_scripted.pt",
        "kept_before_scripted.pt"}) {
    EXPECT_LT(difference(file), 2e-6) << file;
  }
}

/// The network of one of several results.
std::optional<Network> read_result(const std::string& file, const std::string& output,
                                   Diagnostics& diagnostics) {
  ReadContext context;
  context.output_name = output;
  return read_policy_bytes(bytes_of(file), file, {}, diagnostics, context);
}

TEST(TorchScript, OfSeveralResultsOneIsTheAction) {
  for (const char* file : {"several_scripted.pt", "several_traced.pt"}) {
    Diagnostics diagnostics;
    const auto network = read_result(file, "1.0", diagnostics);
    ASSERT_TRUE(network.has_value()) << diagnostics.all().front().message;
    const std::string golden = "several_golden.npz";
    const auto rows = read_golden(kFolder + golden, golden, {}, diagnostics);
    ASSERT_TRUE(rows.has_value());
    EXPECT_TRUE(compare(*network, *rows, golden, {}, diagnostics).has_value());
    EXPECT_THAT(network->ignored, ElementsAre("result `0` [1, 1]", "result `1.1` [1, 3]"));
  }
}

TEST(TorchScript, WhichResultIsTheActionMustBeSaid) {
  for (const auto& [output, text] :
       {std::pair{"",
                  "has 3 results, and it is not known which one is the action: `0` [1, 1], "
                  "`1.0` [1, 3], `1.1` [1, 3]"},
        std::pair{"mean", "has no result `mean`: it has `0` [1, 1]"}}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(read_result("several_scripted.pt", output, diagnostics).has_value());
    EXPECT_EQ(diagnostics.all().front().code, "E0751");
    EXPECT_THAT(diagnostics.all().front().message, HasSubstr(text));
  }
  Diagnostics diagnostics;
  EXPECT_FALSE(read_result("mlp_scripted.pt", "0", diagnostics).has_value());
  EXPECT_EQ(diagnostics.all().front().code, "E0751");
}

TEST(TorchScript, LayersAreThoseOfTheModules) {
  const Network mlp = read_good(bytes_of("mlp_scripted.pt"));
  ASSERT_EQ(mlp.layers.size(), 3U);
  EXPECT_TRUE(mlp.is_chain());
  EXPECT_EQ(mlp.layers[0].activation, Activation::elu);
  EXPECT_EQ(mlp.inputs(), 8U);
  EXPECT_TRUE(mlp.assumed.empty());
  const Network lstm = read_good(bytes_of("lstm_two_scripted.pt"));
  EXPECT_TRUE(lstm.is_chain());
  EXPECT_EQ(lstm.layers[1].remembers(), 10U);
}

TEST(TorchScript, ResultsShareOnlyUnneededBuffers) {
  const Network network = read_good(bytes_of("branches_scripted.pt"));
  ASSERT_FALSE(network.is_chain());
  const BufferPlan plan = plan_buffers(network);
  std::size_t together = 0;
  for (const std::size_t size : plan.sizes) together += size;
  std::size_t alone = 0;
  std::vector<std::vector<std::size_t>> needed(network.layers.size());  // by layers that read it
  const auto maker = [&](std::int32_t i) {
    while (i >= 0 && first_of_slice(network.layers[static_cast<std::size_t>(i)])) {
      i = network.taken_by(static_cast<std::size_t>(i)).front();
    }
    return i;
  };
  for (std::size_t i = 0; i < network.layers.size(); ++i) {
    if (plan.places[i]) alone += network.layers[i].outputs;
    for (const std::int32_t from : network.taken_by(i)) {
      if (maker(from) >= 0) needed[static_cast<std::size_t>(maker(from))].push_back(i);
    }
  }
  EXPECT_LT(together, alone);
  for (std::size_t i = 0; i < network.layers.size(); ++i) {
    for (std::size_t k = i + 1; plan.places[i] && k < network.layers.size(); ++k) {
      if (plan.places[k] != plan.places[i]) continue;
      for (const std::size_t reader : needed[i]) EXPECT_LT(reader, k) << i << " is lost";
    }
  }
}

/// An archive with another text of one entry.
std::string changed(const std::string& file, const std::string& ending, const std::string& text) {
  const std::string bytes = bytes_of(file);
  PolicyProblem problem;
  const auto archive = Archive::open(bytes, problem);
  EXPECT_TRUE(archive.has_value());
  std::vector<test::ZipEntry> entries;
  for (const std::string& name : archive->names()) {
    std::string buffer;
    const auto content = archive->read(name, buffer, problem);
    entries.push_back({name, name.ends_with(ending) ? text : std::string(*content)});
  }
  return test::zip(entries);
}

/// The module with tensors a [4, 8], b [8], c [2, 8], d [2] and this body of `forward`, which takes
/// these inputs.
std::string with_body(const std::string& body, const std::string& inputs = "x: Tensor") {
  return changed("by_hand_half.pt", "code/__torch__.py",
                 "class ByHand(Module):\n"
                 "  a : Tensor\n"
                 "  def forward(self: __torch__.ByHand,\n    " +
                     inputs + ") -> Tensor:\n" + body);
}
std::string body_with(const std::string& line) {
  return with_body("    y = torch.add(torch.matmul(x, self.a), self.b)\n    " + line +
                   "\n    return z\n");
}

void expect_refused(const std::string& bytes, const char* code, const char* text) {
  const Diagnostic diagnostic = read_bad(bytes);
  EXPECT_EQ(diagnostic.code, code) << diagnostic.message;
  EXPECT_THAT(diagnostic.message, HasSubstr(text));
}

TEST(TorchScript, CodeThatIsNoCodeIsRefused) {
  expect_refused(with_body("    return torch.relu(x\n"), "E0753", "code/__torch__.py");
  expect_refused(with_body("    return x @ x\n"), "E0753", "line 5");
  expect_refused(with_body("    return \"x\n"), "E0753", "a text does not end");
  expect_refused(with_body("    " + std::string(4000, '(') + "\n"), "E0753", "nested too deeply");
  expect_refused(changed("by_hand_half.pt", "code/__torch__.py", ""), "E0753", "ByHand.forward");
}

TEST(TorchScript, MishIsItsFormula) {
  const Network whole = read_good(body_with("z = torch.mish(y)"));
  const Network parts = read_good(body_with("z = torch.mul(y, torch.tanh(torch.softplus(y)))"));
  const std::vector<float> x = {0.5F, -1.0F, 2.0F, -0.25F};
  EXPECT_EQ(evaluate(whole, x), evaluate(parts, x));
}

TEST(TorchScript, WhatIsNotUnderstoodIsRefusedByItsLine) {
  for (const auto& [line, text] : std::initializer_list<std::pair<const char*, const char*>>{
           {"z = torch.cumsum(y, 1)", "`cumsum`, which is not supported (line 6"},
           {"z = torch.dropout(y, 0.5, True)", "as in training"},
           {"z = torch.softplus(y, 2.)", "`softplus` in a way"},
           {"z = torch.to(y, 5)", "rounds numbers to another type"},
           {"z = self.e", "has no member `e`"},
           {"z = unknown(y)", "calls `unknown`"},
           {"z = q", "uses `q`, which is not known"},
           {"z = torch.relu_(torch.slice(y, 1, 0, 2))", "changes a part of a tensor"},
           {"z = (y)[3]", "takes a part that is not there"},
           {"ops.prim.RaiseException(\"no\")", "raises an error"},
           {"z = (self).forward(y, )", "calls itself"}}) {
    expect_refused(body_with(line), "E0754", text);
  }
  expect_refused(body_with("for i in range(3):\n      y = torch.relu(y)"), "E0754",
                 "a statement `for` (line 6");
  expect_refused(body_with("if torch.gt(torch.sum(y), 0):\n      z = y\n    else:\n      z = x"),
                 "E0754", "`sum`");
  expect_refused(body_with("if y:\n      z = y\n    else:\n      z = x"), "E0754",
                 "a condition that is not known");
  expect_refused(with_body("    return (x, x)\n"), "E0751", "has 2 results");
  expect_refused(with_body("    return 3\n"), "E0754", "returns no tensor");
  expect_refused(body_with("z = torch.bitwise_not(y)"), "E0754", "`bitwise_not` in a way");
  const std::string places = "annotate(List[Optional[Tensor]], [None, y])";
  expect_refused(body_with("z = torch.index_put_(y, " + places + ", y)"), "E0754",
                 "`index_put` in a way");
  expect_refused(body_with("z = torch.matmul(y, self.a)"), "E0618", "line 6");
  expect_refused(body_with("z = torch.add(y, torch.mul(torch.randn_like(y), torch.log(y)))"),
                 "E0754", "its code samples random numbers (`randn_like`)");
  expect_refused(with_body("    return x\n", "x: Tensor,\n    hc: Tuple[Tensor, Tensor]"), "E0754",
                 "takes `hc`, which is not a tensor but Tuple[Tensor,Tensor]");
}

/// rsl_rl's deviation that depends on the state: means and deviations are two rows.
TEST(TorchScript, MeansAreTheFirstRow) {
  const Network all = read_good(body_with("z = y"));
  const Network means =
      read_good(body_with("z = torch.select(torch.unflatten(y, -1, [2, 4]), -2, 0)"));
  const std::vector<float> x = {0.5F, -1.0F, 2.0F, 0.25F};
  const std::vector<float> both = evaluate(all, x);
  ASSERT_EQ(both.size(), 8U);
  EXPECT_THAT(evaluate(means, x), testing::ElementsAreArray(both.begin(), both.begin() + 4));
}

TEST(TorchScript, ConditionsThatAreKnownAreFollowed) {
  const Network network =
      read_good(body_with("if torch.eq(torch.dim(y), 2):\n      z = torch.tanh(y)\n"
                          "    else:\n      z = torch.cumsum(y, 1)"));
  EXPECT_EQ(network.layers.back().activation, Activation::tanh);
  EXPECT_EQ(network.inputs(), 4U);
  const Network checked =
      read_good(body_with("if torch.__not__(torch.__contains__([1, 2], torch.dim(y))):\n"
                          "      ops.prim.RaiseException(\"no\")\n"
                          "    else:\n      pass\n"
                          "    print(y)\n    z = torch.tanh(y)"));
  EXPECT_EQ(checked.layers.back().activation, Activation::tanh);
}

TEST(TorchScript, WhatIsChangedInPlaceIsChangedForAll) {
  const Network network = read_good(body_with("z = y\n    _0 = torch.relu_(y)"));
  EXPECT_EQ(network.layers.back().activation, Activation::relu);
}

TEST(TorchScript, TheSizeOfTheObservationIsFound) {
  const Network sum =
      read_good(with_body("    y = torch.matmul(torch.slice(x, 1, 0, 4), self.a)\n"
                          "    z = torch.linear(torch.slice(x, 1, 4), self.c)\n"
                          "    return torch.cat([y, z], 1)\n"));
  EXPECT_EQ(sum.inputs(), 12U);
  EXPECT_TRUE(sum.assumed.empty());
  const Network part =
      read_good(with_body("    return torch.matmul(torch.slice(x, 1, 0, 4), self.a)\n"));
  EXPECT_EQ(part.inputs(), 4U);
  EXPECT_EQ(part.assumed.size(), 1U);
}

TEST(TorchScript, NothingWithoutTensorsIsAPolicy) {
  // The pickle of a module without members.
  const std::string pickle = std::string("\x80\x02", 2) + "c__torch__\nByHand\n)\x81}b.";
  expect_refused(changed("by_hand_half.pt", "data.pkl", pickle), "E0755", "no tensors");
}

/// gru_scripted with another line instead of the one that keeps the state.
std::string with_state(const std::string& line) {
  const std::string bytes = bytes_of("gru_scripted.pt");
  PolicyProblem problem;
  const auto archive = Archive::open(bytes, problem);
  std::string buffer;
  for (const std::string& name : archive->names()) {
    if (!name.ends_with("code/__torch__.py")) continue;
    std::string code(*archive->read(name, buffer, problem));
    const std::size_t at = code.find("    _2 = torch.copy_(");
    EXPECT_NE(at, std::string::npos) << code;
    code.replace(at, code.find('\n', at) - at, "    " + line);
    return changed("gru_scripted.pt", "code/__torch__.py", code);
  }
  return {};
}

TEST(TorchScript, StatesAreKeptAndBeginWithZeros) {
  EXPECT_TRUE(read_good(with_state("self.hidden_state = h")).has_memory());
  // A result that contains a part of the old state keeps the state.
  EXPECT_TRUE(
      read_good(with_state("_9 = torch.squeeze(hidden_state0, 0)\n    self.hidden_state = h"))
          .has_memory());
  expect_refused(with_state("pass"), "E0756", "that is not kept");
  expect_refused(with_state("self.hidden_state = x0"), "E0756", "not the state of a GRU or LSTM");
  expect_refused(with_state("_2 = torch.copy_(hidden_state0, torch.relu(h))"), "E0756",
                 "not the state of a GRU or LSTM");
  // A history in a buffer, newest last.
  const std::string history = with_state(
      "self.hidden_state = torch.cat([torch.slice(hidden_state0, 2, 1), "
      "torch.slice(h, 2, 0, 1)], 2)");
  expect_refused(history, "E0756", "not the state of a GRU or LSTM");
  EXPECT_THAT(read_bad(history).help.text, HasSubstr("oldest first, and set `window: N`"));
  std::size_t refused = 0;  // the storage of the state is one of those of 8 numbers
  for (int i = 0; i < 13; ++i) {
    Diagnostics diagnostics;
    const std::string ones(32, '\x3f');
    const auto bytes = changed("gru_scripted.pt", fmt::format("data/{}", i), ones);
    if (read_policy_bytes(bytes, "policy", {}, diagnostics)) continue;
    if (diagnostics.all().front().code == "E0756") ++refused;
  }
  EXPECT_EQ(refused, 1U);
}

/// What it keeps depends on itself, or is no number that was new once.
TEST(TorchScript, OfBuffersOnlyStatesAndHistoriesAreKept) {
  for (const auto& [file, buffer] :
       {std::pair{"kept_actions_scripted.pt", "`actions`"}, {"kept_mean_scripted.pt", "`mean`"}}) {
    expect_refused(bytes_of(file), "E0756", buffer);
    expect_refused(bytes_of(file), "E0756", "not the state of a GRU or LSTM, nor a history");
  }
  // A history that does not begin with zeros, and one next to a tensor that is cut off.
  const std::string ones(80, '\x3f');
  expect_refused(changed("kept_frames_scripted.pt", "data/0", ones), "E0756",
                 "does not begin with zeros");
  expect_refused(changed("kept_frames_scripted.pt", "data/1", ones), "E0614", "`weight`");
}

TEST(TorchScript, HistoriesHaveTheNumbersThatTheyNeed) {
  std::vector<std::uint32_t> remembered;
  for (const char* file : {"kept_frames_scripted.pt", "kept_rolled_scripted.pt"}) {
    for (const Layer& layer : read_good(bytes_of(file)).layers) {
      if (layer.remembers() > 0) remembered.push_back(layer.remembers());
    }
  }
  EXPECT_THAT(remembered, ElementsAre(20U, 15U, 12U));
}

TEST(TorchScript, WhatTheFileSaysIsNotSaidAgain) {
  ReadContext context;
  context.output_activation = Activation::tanh;
  Diagnostics diagnostics;
  EXPECT_FALSE(read_policy_bytes(bytes_of("mlp_traced.pt"), "policy", {}, diagnostics, context));
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(diagnostics.all().front().code, "E0626");
}

}  // namespace
}  // namespace eagerx::gen
