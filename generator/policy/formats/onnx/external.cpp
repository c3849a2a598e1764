#include "generator/policy/formats/onnx/external.hpp"

#include <fmt/core.h>

#include <charconv>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "generator/policy/network/limits.hpp"

namespace eagerx::gen {
namespace {

constexpr const char* kOneFile =
    "put the file that belongs to it into its folder, or save one file: "
    "`onnx.save(onnx.load(\"in.onnx\"), "
    "\"one.onnx\", save_as_external_data=False)`";

/// Where a tensor's values lie.
struct Place {
  std::string name;
  std::uint64_t offset = 0;
  std::optional<std::uint64_t> length;
};

class External {
 public:
  External(const FilesInFolder& files, PolicyProblem& problem) : files_(files), problem_(problem) {}

  bool take(onnx::TensorProto& tensor) {
    const bool is_external = tensor.data_location() == onnx::TensorProto::EXTERNAL;
    if (!is_external && tensor.external_data_size() == 0) return true;
    const auto place = is_external ? place_of(tensor) : std::nullopt;
    if (!place) return fail(tensor, "does not say where the values of tensor `{}` are");
    const std::string* bytes = file(tensor, place->name);
    if (bytes == nullptr) return false;
    if (place->offset > bytes->size() ||
        place->length.value_or(0) > bytes->size() - place->offset) {
      return fail(tensor, "has a tensor `{}` whose values are behind the end of their file");
    }
    const auto length = place->length.value_or(bytes->size() - place->offset);
    taken_ += length;  // many tensors may be the same bytes
    if (taken_ > kMaxPolicyBytes) {
      return fail(tensor, "has more values in other files than are read, at tensor `{}`");
    }
    tensor.set_raw_data(bytes->data() + place->offset, static_cast<std::size_t>(length));
    tensor.clear_external_data();
    tensor.set_data_location(onnx::TensorProto::DEFAULT);
    return true;
  }

 private:
  Refused fail(const onnx::TensorProto& tensor, const char* how) {
    return refuse(problem_, "E0617", fmt::format(fmt::runtime(how), printable(tensor.name())),
                  kOneFile);
  }

  static std::optional<std::uint64_t> number(const std::string& text) {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc{} || result.ptr != end) return std::nullopt;
    return value;
  }

  static std::optional<Place> place_of(const onnx::TensorProto& tensor) {
    Place place;
    for (const onnx::StringStringEntryProto& entry : tensor.external_data()) {
      if (entry.key() == "location") place.name = entry.value();
      if (entry.key() != "offset" && entry.key() != "length") continue;
      const auto value = number(entry.value());
      if (!value) return std::nullopt;
      if (entry.key() == "offset") place.offset = *value;
      if (entry.key() == "length") place.length = *value;
    }
    return place.name.empty() ? std::nullopt : std::optional(place);
  }

  /// Only a file in the same folder: the name comes from somebody else.
  static bool is_in_same_folder(std::string_view name) {
    constexpr std::size_t kLongest = 255;
    return name.size() <= kLongest && name != "." && name != ".." &&
           name.find_first_of(std::string_view("/\\\0", 3)) == std::string_view::npos;
  }

  const std::string* file(const onnx::TensorProto& tensor, std::string name) {
    if (name.starts_with("./")) name.erase(0, 2);
    if (const auto known = known_.find(name); known != known_.end()) return &known->second;
    const auto refuse_file = [&](const std::string& how) {
      return refuse(problem_, "E0617",
                    fmt::format("keeps the values of tensor `{}` in another file, `{}`, {}",
                                printable(tensor.name()), printable(name), how),
                    kOneFile);
    };
    if (!is_in_same_folder(name)) return refuse_file("which is not in the same folder");
    if (!files_) return refuse_file("which is not at hand");
    std::string why;
    auto bytes = files_(name, why);
    if (!bytes) return refuse_file(why);
    held_ += bytes->size();
    if (held_ > kMaxPolicyBytes) return refuse_file("which is one file too many");
    return &known_.emplace(name, std::move(*bytes)).first->second;
  }

  const FilesInFolder& files_;
  PolicyProblem& problem_;
  std::map<std::string, std::string, std::less<>> known_;
  std::uint64_t taken_ = 0, held_ = 0;
};

}  // namespace

bool take_external_values(onnx::GraphProto& graph, const FilesInFolder& files,
                          PolicyProblem& problem) {
  External external(files, problem);
  for (onnx::TensorProto& tensor : *graph.mutable_initializer()) {
    if (!external.take(tensor)) return false;
  }
  for (onnx::NodeProto& node : *graph.mutable_node()) {
    for (onnx::AttributeProto& attribute : *node.mutable_attribute()) {
      if (attribute.has_t() && !external.take(*attribute.mutable_t())) return false;
    }
  }
  return true;
}

}  // namespace eagerx::gen
