// Files that people take for policies: each is named as what it is, with the way to one that is
// read.
#include "generator/policy/formats/common/foreign.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/unit/formats/onnx_builder.hpp"
#include "tests/unit/formats/table_builder.hpp"

namespace eagerx::gen {
namespace {

using namespace std::string_literals;

struct Foreign {
  const char* name;
  std::string bytes;
  const char* message;
  const char* way;
};

class ForeignFiles : public testing::TestWithParam<Foreign> {};

TEST_P(ForeignFiles, AreNamedAsWhatTheyAre) {
  const Diagnostic diagnostic = test::read_bad(GetParam().bytes);
  EXPECT_EQ(diagnostic.code, "E0603");
  EXPECT_EQ(diagnostic.message, "policy `policy.onnx` is "s + GetParam().message);
  EXPECT_EQ(diagnostic.help.text, GetParam().way + "; "s + kKnownFormats);
}

/// A pickle of protocol `version` that makes an object of `module` and class `name`.
std::string pickle(char version, const std::string& module, const std::string& name) {
  return "\x80"s + version + "c" + module + "\n" + name + "\n)\x81.";
}

const char* const kBaselines2 =
    "export its TensorFlow graph to ONNX with tf2onnx, or train with Stable-Baselines3";
const char* const kKeras = "convert it to ONNX: `python -m tf2onnx.convert --keras FILE`";
const char* const kTensorFlow =
    "convert it to ONNX with `python -m tf2onnx.convert`, or save it as ONNX when training";
const char* const kJax =
    "write the actor's weights as npz with torch's names (`net.0.weight` [outputs, inputs], "
    "`net.0.bias`)";
const char* const kUnpack = "unpack it, and name the policy in it";

INSTANTIATE_TEST_SUITE_P(
    , ForeignFiles,
    testing::Values(
        Foreign{"lfs", "version https://git-lfs.github.com/spec/v1\n",
                "a Git LFS pointer, not the file itself", "run `git lfs pull`"},
        Foreign{"text", "{\"mean\": [0]}", "a text file", "name the weight file"},
        Foreign{"web_page", "\n<!DOCTYPE HTML><html lang=en>",
                "a web page, not the file that it shows", "download the file itself"},
        Foreign{"openvino", "<?xml version=\"1.0\"?>\n<net name=\"actor\" version=\"11\">",
                "a network of OpenVINO", "name the ONNX file that it was made from"},
        Foreign{"keras_h5", "\x89HDF\r\n\x1a\n",
                "an HDF5 file, as Keras, RLtools and others save their weights",
                "convert it to ONNX: of Keras with `python -m tf2onnx.convert --keras FILE`; of "
                "other libraries copy its layers into a `torch.nn.Sequential`, and save that"},
        Foreign{"keras_zip", test::zip({{"config.json", "{}"}, {"model.weights.h5", "x"}}),
                "a Keras model", kKeras},
        Foreign{"tflite", "\x1c\0\0\0TFL3\x14\0\x20\0"s, "a TensorFlow Lite model",
                "name the file that it was converted from, as ONNX: `python -m tf2onnx.convert "
                "--tflite FILE`"},
        Foreign{"saved_model", "\x08\x01\x12\x10\x0a\x0e\x22\x05serve\x2a\x05"s + "2.9.1",
                "a TensorFlow graph", kTensorFlow},
        Foreign{"frozen_graph", "\x0a\x12\x0a\x03obs\x12\x0bPlaceholder"s, "a TensorFlow graph",
                kTensorFlow},
        Foreign{"tensorrt", "ftrt\0\0\0\0\xef\0\0\0"s,
                "a TensorRT engine, which is made for one kind of GPU",
                "name the ONNX file that it was built from"},
        Foreign{"barracuda", "\x10\0\0\0\0\0\0\0\1\0\0\0\x05\0\0\0obs_0\x02\0\0\0"s,
                "a network of Unity's Barracuda", "name the ONNX file that it was made from"},
        Foreign{"baselines2_zip",
                test::zip({{"data", "{}"}, {"parameter_list", "[]"}, {"parameters", "x"}}),
                "a model of Stable-Baselines 2, with TensorFlow's weights", kBaselines2},
        Foreign{"baselines2_pkl", pickle(3, "stable_baselines.common.policies", "MlpPolicy"),
                "a model of Stable-Baselines 2, with TensorFlow's weights", kBaselines2},
        Foreign{"vec_normalize",
                pickle(4, "stable_baselines3.common.vec_env.vec_normalize", "VecNormalize"),
                "VecNormalize's statistics, not a policy",
                "name the policy as `policy`, and this file as its `normalize`"},
        Foreign{"replay_buffer", pickle(4, "stable_baselines3.common.buffers", "ReplayBuffer"),
                "a replay buffer, not a policy", "name the file that `model.save` wrote"},
        Foreign{"brax",
                pickle(4, "brax.training.acme.running_statistics", "RunningStatisticsState"),
                "a pickle of Brax, with JAX's arrays", kJax},
        Foreign{"pickle", pickle(2, "mine", "Actor"), "a Python pickle",
                "save the actor's `state_dict()` with `torch.save`"},
        Foreign{"flax", "\x81\xa6params\x82\xa7"s + "Dense_0",
                "MessagePack, as Flax saves JAX's arrays", kJax},
        Foreign{"gzip", "\x1f\x8b\x08\0"s, "packed with gzip", kUnpack},
        Foreign{"npy", "\x93NUMPY\x01\0"s, "one NumPy array, not an archive of them (npz)",
                "save all arrays of the actor with `numpy.savez`"},
        Foreign{"zipped_onnx", test::zip({{"model/policy.onnx", "x"}}),
                "a zip archive with ONNX files in it", kUnpack},
        Foreign{"zip", test::zip({{"holiday.jpg", "x"}}),
                "a zip archive that is not a policy: its first entry is `holiday.jpg`",
                "name the file that `model.save` or `torch.save` wrote"}),
    [](const auto& test) { return test.param.name; });

TEST(ForeignTables, AreNamedByTheirTensors) {
  Diagnostic diagnostic =
      test::read_bad(test::safetensors({{"params.Dense_0.kernel", {1, 1}, {1}}}));
  test::expect_problem(diagnostic, "E0624", "as Flax and Keras do: `params.Dense_0.kernel`");
  EXPECT_EQ(diagnostic.help.text, kJaxWay);
  diagnostic = test::read_bad(test::safetensors({{"gru.Wx", {3, 1}, {1, 1, 1}}}));
  test::expect_problem(diagnostic, "E0624", "has a memory of MLX: `gru.Wx`");
}

TEST(ForeignFolders, AreNamedToo) {
  const auto message = [](const char* entry) {
    const auto problem = foreign_folder({"checkpoint", entry});
    return problem ? problem->message : "";
  };
  EXPECT_EQ(message("manifest.ocdbt"), "is a checkpoint of JAX's Orbax");
  EXPECT_EQ(message("saved_model.pb"), "is a TensorFlow SavedModel");
  EXPECT_EQ(message("rllib_checkpoint.json"), "is a checkpoint of RLlib");
  EXPECT_EQ(message("readme.txt"), "");
  const std::filesystem::path folder = testing::TempDir() + "orbax_checkpoint";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "_METADATA") << "{}";
  Diagnostics diagnostics;
  EXPECT_FALSE(read_policy(folder.string(), "orbax_checkpoint", {}, diagnostics).has_value());
  test::expect_problem(diagnostics.all().front(), "E0603", "is a checkpoint of JAX's Orbax");
}

TEST(Damage, OfAnOldTorchFileIsNamed) {
  std::ifstream file(EAGERX_SOURCE_DIR "/tests/data/policy/libraries/rsl_rl_legacy.pt",
                     std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  test::expect_problem(test::read_bad(bytes.substr(0, bytes.size() - 1)), "E0623",
                       "ends before its tensors do");
  test::expect_problem(test::read_bad(bytes.substr(0, 40)), "E0623", "ends early");
}

}  // namespace
}  // namespace eagerx::gen
