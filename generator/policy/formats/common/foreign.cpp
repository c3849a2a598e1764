#include "generator/policy/formats/common/foreign.hpp"

#include <fmt/core.h>

#include <array>
#include <cstdint>

#include "generator/policy/network/element_type.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

constexpr const char* kKerasWay = "convert it to ONNX: `python -m tf2onnx.convert --keras FILE`";
constexpr const char* kHdfWay =
    "convert it to ONNX: of Keras with `python -m tf2onnx.convert --keras FILE`; of other "
    "libraries copy "
    "its "
    "layers into a `torch.nn.Sequential`, and save that";
constexpr const char* kTensorFlowWay =
    "convert it to ONNX with `python -m tf2onnx.convert`, or save it as ONNX when training";
constexpr const char* kBaselines2Way =
    "export its TensorFlow graph to ONNX with tf2onnx, or train with Stable-Baselines3";
constexpr const char* kUnpackWay = "unpack it, and name the policy in it";

/// A mark that identifies a file or folder, its kind, and the fix.
struct Mark {
  std::string_view text;
  const char* what;
  const char* way;
  std::size_t at = 0;  // of bytes: where they are
};
using namespace std::string_view_literals;
constexpr std::array kBeginnings = {
    Mark{"version https://git-lfs"sv, "a Git LFS pointer, not the file itself",
         "run `git lfs pull`"},
    Mark{"\x93NUMPY"sv, "one NumPy array, not an archive of them (npz)",
         "save all arrays of the actor with `numpy.savez`"},
    Mark{"\x89HDF"sv, "an HDF5 file, as Keras, RLtools and others save their weights", kHdfWay},
    Mark{"TFL3"sv, "a TensorFlow Lite model",
         "name the file that it was converted from, as ONNX: `python -m tf2onnx.convert "
         "--tflite FILE`",
         4},
    Mark{"ftrt"sv, "a TensorRT engine, which is made for one kind of GPU",
         "name the ONNX file that it was built from"},
    Mark{"ptrt"sv, "a TensorRT engine, which is made for one kind of GPU",
         "name the ONNX file that it was built from"},
    Mark{"GGUF"sv, "a GGUF file", "export the actor to ONNX"},
    Mark{"\x1f\x8b"sv, "packed with gzip", kUnpackWay},
    Mark{"\xfd"
         "7zXZ"sv,
         "packed with xz", kUnpackWay},
    Mark{"BZh"sv, "packed with bzip2", kUnpackWay},
    Mark{"\x28\xb5\x2f\xfd"sv, "packed with zstd", kUnpackWay},
    Mark{"7z\xbc\xaf"sv, "a 7z archive", kUnpackWay},
    Mark{"ustar"sv, "a tar archive", kUnpackWay, 257},
};

/// Names in a pickle that identify its library, the more special first.
constexpr std::array kPickleMarks = {
    Mark{"vec_normalize", "VecNormalize's statistics, not a policy",
         "name the policy as `policy`, and this file as its `normalize`"},
    Mark{"stable_baselines3.common.buffers", "a replay buffer, not a policy",
         "name the file that `model.save` wrote"},
    Mark{"stable_baselines.", "a model of Stable-Baselines 2, with TensorFlow's weights",
         kBaselines2Way},
    Mark{"ray.rllib", "a pickle of RLlib", "export the policy with `export_model` as ONNX"},
    Mark{"ray.cloudpickle", "a pickle of RLlib", "export the policy with `export_model` as ONNX"},
    Mark{"brax", "a pickle of Brax, with JAX's arrays", kJaxWay},
    Mark{"flax", "a pickle of Flax, with JAX's arrays", kJaxWay},
    Mark{"jax", "a pickle with JAX's arrays", kJaxWay},
    Mark{"tensorflow", "a pickle with TensorFlow's objects", kTensorFlowWay},
    Mark{"keras", "a pickle with Keras' objects", kKerasWay},
    Mark{"torch", "a pickle with torch's objects, which torch.save did not write",
         "save `actor.state_dict()` with `torch.save`"},
};

PolicyProblem foreign(std::string_view what, std::string_view way) {
  return {"E0603", fmt::format("is {}", what), fmt::format("{}; {}", way, kKnownFormats)};
}

bool is_printable(std::string_view bytes) {
  constexpr unsigned char kDelete = 0x7f;
  return ranges::all_of(bytes, [](unsigned char c) { return c >= ' ' && c < kDelete; });
}

/// By its beginning: no format that is read has only letters, blanks and line ends there.
bool is_text(std::string_view bytes) {
  constexpr std::size_t kLooked = 512;
  constexpr unsigned char kDelete = 0x7f;
  return ranges::all_of(bytes.substr(0, kLooked),
                        [](unsigned char c) {
                          return (c >= ' ' && c != kDelete) || c == '\n' || c == '\r' || c == '\t';
                        }) &&
         ranges::none_of(bytes.substr(0, kLooked), [](unsigned char c) { return c >= 0xf8; });
}

/// Barracuda's version in eight bytes, how many inputs there are, and the name of the first one.
bool is_barracuda(std::string_view bytes) {
  constexpr std::size_t kName = 16;
  constexpr std::uint64_t kNewestVersion = 31;
  constexpr std::uint64_t kMostInputs = 64;
  if (bytes.size() < kName || little_endian(bytes, 8) == 0 ||
      little_endian(bytes, 8) > kNewestVersion) {
    return false;
  }
  const std::uint64_t inputs = little_endian(bytes.substr(8), 4);
  const std::uint64_t length = little_endian(bytes.substr(12), 4);
  return inputs >= 1 && inputs <= kMostInputs && length >= 1 && length <= bytes.size() - kName &&
         length < 256 && is_printable(bytes.substr(kName, length));
}

/// MessagePack's map of a few entries, the first with a short name.
bool is_flax(std::string_view bytes) {
  if (bytes.size() < 3) return false;
  const auto map = static_cast<unsigned char>(bytes[0]);
  const auto name = static_cast<unsigned char>(bytes[1]);
  const std::size_t length = name & 0x1fU;
  return map > 0x80 && map <= 0x8f && name > 0xa0 && name <= 0xbf && bytes.size() > 2 + length &&
         is_printable(bytes.substr(2, length));
}

/// Protobuf: a saved model has version 1 and then a graph with its tags; a frozen graph is a list
/// of nodes, one of them a placeholder.
bool is_tensorflow(std::string_view bytes) {
  constexpr std::size_t kLooked = 1U << 16U;
  if (bytes.starts_with("\x08\x01\x12")) {
    return bytes.find("\x22\x05serve") != std::string_view::npos;
  }
  return bytes.starts_with("\x0a") &&
         bytes.substr(0, kLooked).find("\x12\x0bPlaceholder") != std::string_view::npos;
}

bool is_pickle(std::string_view bytes) {
  constexpr char kOldest = 2;
  constexpr char kNewest = 5;
  return bytes.size() > 2 && bytes[0] == '\x80' && bytes[1] >= kOldest && bytes[1] <= kNewest;
}

PolicyProblem foreign_pickle(std::string_view bytes) {
  for (const Mark& mark : kPickleMarks) {
    if (bytes.find(mark.text) == std::string_view::npos) continue;
    return foreign(mark.what, mark.way);
  }
  return foreign("a Python pickle", "save the actor's `state_dict()` with `torch.save`");
}

PolicyProblem foreign_text(std::string_view bytes) {
  constexpr std::size_t kLooked = 512;
  std::string start(bytes.substr(0, kLooked));
  for (char& c : start) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  if (start.find("<html") != std::string::npos ||
      start.find("<!doctype html") != std::string::npos) {
    return foreign("a web page, not the file that it shows", "download the file itself");
  }
  if (start.find("<net ") != std::string::npos) {
    return foreign("a network of OpenVINO", "name the ONNX file that it was made from");
  }
  return foreign("a text file", "name the weight file");
}

/// Ends of names of entries.
constexpr std::array kArchives = {
    Mark{"parameter_list", "a model of Stable-Baselines 2, with TensorFlow's weights",
         kBaselines2Way},
    Mark{"model.weights.h5", "a Keras model", kKerasWay},
    Mark{"saved_model.pb", "a TensorFlow SavedModel", kTensorFlowWay},
    Mark{"policy.pth", "a zip archive with a folder in it", kUnpackWay},
    Mark{".onnx", "a zip archive with ONNX files in it", kUnpackWay},
    Mark{".pt", "a zip archive with torch files in it", kUnpackWay},
    Mark{".pth", "a zip archive with torch files in it", kUnpackWay},
    Mark{".safetensors", "a zip archive with safetensors in it", kUnpackWay},
    Mark{".zip", "a zip archive with others in it", kUnpackWay},
};
constexpr std::array kFolders = {
    Mark{"saved_model.pb", "a TensorFlow SavedModel",
         "convert it to ONNX: `python -m tf2onnx.convert --saved-model FOLDER`"},
    Mark{"manifest.ocdbt", "a checkpoint of JAX's Orbax", kJaxWay},
    Mark{"_METADATA", "a checkpoint of JAX's Orbax", kJaxWay},
    Mark{"_CHECKPOINT_METADATA", "a checkpoint of JAX's Orbax", kJaxWay},
    Mark{"rllib_checkpoint.json", "a checkpoint of RLlib",
         "export the policy with `export_model` as ONNX"},
    Mark{"algorithm_state.pkl", "a checkpoint of RLlib",
         "export the policy with `export_model` as ONNX"},
    Mark{"policy.pth", "an unpacked zip of Stable-Baselines3", "name the zip itself"},
    Mark{"data.pkl", "an unpacked file of torch.save", "name the file itself"},
};

std::optional<PolicyProblem> among(const auto& known, const std::vector<std::string>& names) {
  for (const Mark& entry : known) {
    const bool there =
        ranges::any_of(names, [&](const std::string& name) { return name.ends_with(entry.text); });
    if (there) return foreign(entry.what, entry.way);
  }
  return std::nullopt;
}

}  // namespace

std::optional<PolicyProblem> foreign_file(std::string_view bytes) {
  for (const Mark& known : kBeginnings) {
    if (bytes.size() < known.at) continue;
    if (bytes.substr(known.at).starts_with(known.text)) return foreign(known.what, known.way);
  }
  if (is_pickle(bytes)) return foreign_pickle(bytes);
  if (is_barracuda(bytes)) {
    return foreign("a network of Unity's Barracuda", "name the ONNX file that it was made from");
  }
  if (is_tensorflow(bytes)) return foreign("a TensorFlow graph", kTensorFlowWay);
  if (is_flax(bytes)) return foreign("MessagePack, as Flax saves JAX's arrays", kJaxWay);
  if (is_text(bytes)) return foreign_text(bytes);
  return std::nullopt;
}

PolicyProblem foreign_archive(const std::vector<std::string>& names) {
  if (auto known = among(kArchives, names)) return *known;
  if (names.empty()) return foreign("an empty zip archive", "save the policy again");
  return foreign(fmt::format("a zip archive that is not a policy: its first entry is `{}`",
                             printable(names.front())),
                 "name the file that `model.save` or `torch.save` wrote");
}

std::optional<PolicyProblem> foreign_folder(const std::vector<std::string>& names) {
  return among(kFolders, names);
}

}  // namespace eagerx::gen
