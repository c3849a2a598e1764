// Tables of a policy as the bytes that the program stores, instead of as text.
#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <string_view>

#include "generator/backend/emit/policy_view.hpp"
#include "generator/policy/network/int8.hpp"
#include "generator/policy/network/panels.hpp"

namespace eagerx::gen {
namespace {

static_assert(std::endian::native == std::endian::little, "the files have the targets' byte order");

// Of every table: that of eagerx::DenseWeights, which is the largest.
constexpr std::size_t kAlignment = 32;

// Around the number of a block. No template has these.
constexpr char kBlock = '\x06';
constexpr char kBlockEnd = '\x07';

void align(std::string& bytes) {
  bytes.resize((bytes.size() + kAlignment - 1) / kAlignment * kAlignment, '\0');
}

/// As eagerx::DenseWeights: weights in panels, biases, each aligned.
void append_panels(const Layer& layer, std::string& bytes) {
  const std::size_t padded = padded_outputs(layer.outputs);
  std::vector<float> numbers(padded * layer.inputs);
  float* to = numbers.data();
  for (const auto& [first, last, end] : panels_of(layer.outputs)) {
    for (std::size_t in = 0; in < layer.inputs; ++in, to += end - first) {
      for (std::size_t out = first; out <= last; ++out)
        to[out - first] = layer.weights[out * layer.inputs + in];
    }
  }
  const auto append = [&bytes](const std::vector<float>& values) {
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
    align(bytes);
  };
  append(numbers);
  std::vector<float> biases = layer.bias;
  biases.resize(padded);
  append(biases);
}

/// The name of a variable for linkers: `_ZN6graphs4cart7kLayer1E` of graphs::cart::kLayer1.
std::string linked_name(std::string_view name_space, const std::string& constant) {
  std::string name = "_ZN";
  while (!name_space.empty()) {
    const std::string_view part = name_space.substr(0, name_space.find("::"));
    name += fmt::format("{}{}", part.size(), part);
    name_space.remove_prefix(std::min(part.size() + 2, name_space.size()));
  }
  return name + fmt::format("{}{}E", constant.size(), constant);
}

}  // namespace

void PolicyTables::add(const Layer& dense) {
  if (!is_stored()) return;
  if (dense.rounded.empty()) {
    append_panels(dense, bytes_);
    return;
  }
  for (const int value : int8_stored(dense)) bytes_ += static_cast<char>(value);
  add(dense.scales);
  add(dense.bias);
}

void PolicyTables::add(const std::vector<float>& numbers) {
  if (is_stored())
    bytes_.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(float));
}

void PolicyTables::add(const std::vector<std::uint32_t>& indices, bool are_wide) {
  if (!is_stored()) return;
  for (const std::uint32_t index : indices)
    bytes_.append(reinterpret_cast<const char*>(&index), are_wide ? 4 : 2);
}

std::size_t PolicyTables::begin() {
  align(bytes_);
  return bytes_.size();
}

kainjow::mustache::data PolicyTables::declaration(std::size_t begin, const std::string& type,
                                                  const std::string& constant,
                                                  const std::string& extent) const {
  using kainjow::mustache::data;
  if (bytes_.size() == begin) return data{false};
  data item{data::type::object};
  item.set("type", type);
  item.set("constant", constant);
  item.set("extent", extent);
  item.set("symbol", linked_name(name_space_, constant));
  item.set("offset", std::to_string(begin));
  item.set("size", std::to_string(bytes_.size() - begin));
  return item;
}

std::string PolicyTables::mark_of(std::string block) {
  blocks_.push_back(std::move(block));
  return kBlock + std::to_string(blocks_.size() - 1) + kBlockEnd;
}

std::string PolicyTables::put_blocks(const std::string& rendered) const {
  std::size_t size = rendered.size();
  for (const std::string& block : blocks_) size += block.size();
  std::string result;
  result.reserve(size);
  for (std::string_view rest = rendered; !rest.empty();) {
    const std::size_t at = std::min(rest.find(kBlock), rest.size());
    result += rest.substr(0, at);
    rest.remove_prefix(at);
    if (rest.empty()) break;
    const std::size_t end = rest.find(kBlockEnd);
    std::size_t number = 0;
    std::from_chars(rest.data() + 1, rest.data() + end, number);
    result += blocks_.at(number);
    rest.remove_prefix(end + 1);
  }
  return result;
}

}  // namespace eagerx::gen
