// NumPy's files: a line of Python that says type and shape, then the values.
#include <fmt/core.h>

#include <charconv>

#include "generator/policy/formats/tensors/containers.hpp"
#include "generator/policy/network/limits.hpp"

namespace eagerx::gen {
namespace {

constexpr const char* kNumpyHelp = "save it again with `numpy.savez`";

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// The text after `'key':` in the header, or empty.
std::string_view header_entry(std::string_view header, std::string_view key) {
  const std::string quoted = fmt::format("'{}':", key);
  const std::size_t at = header.find(quoted);
  return at == std::string_view::npos ? std::string_view{}
                                      : trimmed(header.substr(at + quoted.size()));
}

/// "(64, 3)" and so on.
std::optional<Dims> shape_of(std::string_view text) {
  const std::size_t end = text.find(')');
  if (text.empty() || text.front() != '(' || end == std::string_view::npos) return std::nullopt;
  text = text.substr(1, end - 1);
  Dims dims;
  while (!trimmed(text).empty()) {
    const std::size_t comma = text.find(',');
    const std::string_view one = trimmed(text.substr(0, comma));
    std::int64_t value = 0;
    const auto result = std::from_chars(one.data(), one.data() + one.size(), value);
    if (result.ec != std::errc{} || result.ptr != one.data() + one.size()) return std::nullopt;
    dims.push_back(value);
    if (comma == std::string_view::npos) break;
    text = text.substr(comma + 1);
  }
  return dims;
}

/// Row-major strides swapped: the first index runs fastest.
std::vector<std::int64_t> fortran_strides(const Dims& dims) {
  std::vector<std::int64_t> strides;
  std::int64_t step = 1;
  for (const std::int64_t dim : dims) {
    strides.push_back(step);
    step = dim > 0 && step <= kMaxElements ? step * std::min(dim, kMaxElements) : step;
  }
  return strides;
}

/// The text between the quotes of "'<f4', …".
std::string_view quoted_text(std::string_view text) {
  if (text.empty() || text.front() != '\'') return {};
  text.remove_prefix(1);
  return text.substr(0, text.find('\''));
}

}  // namespace

std::optional<StoredTensor> read_npy(std::string_view bytes, const std::string& name,
                                     PolicyProblem& problem) {
  constexpr std::string_view kMagic = "\x93NUMPY";
  constexpr std::size_t kVersion = 6;
  const auto fail = [&](const std::string& how) {
    return refuse(problem, "E0630", fmt::format("has array `{}` {}", printable(name), how),
                  kNumpyHelp);
  };
  if (bytes.size() < 12 || !bytes.starts_with(kMagic)) return fail("that is not NumPy's format");
  const std::size_t width = bytes[kVersion] == 1 ? 2 : 4;
  const auto length = static_cast<std::size_t>(little_endian(bytes.substr(8), width));
  if (length > bytes.size() - 8 - width) return fail("that ends early");
  const std::string_view header = bytes.substr(8 + width, length);
  const std::string_view code = quoted_text(header_entry(header, "descr"));
  const auto shape = shape_of(header_entry(header, "shape"));
  if (code.size() < 2 || !shape) return fail("whose header cannot be read");
  const auto type = numpy_type(code.substr(1));
  if (!type || code.front() == '>') {
    return refuse(problem, "E0615",
                  fmt::format("has array `{}` of type `{}`", printable(name), printable(code)),
                  "save it as float32, little-endian");
  }
  StoredTensor tensor;
  tensor.type = *type;
  tensor.shape = *shape;
  if (header_entry(header, "fortran_order").starts_with("True")) {
    tensor.strides = fortran_strides(tensor.shape);
  }
  tensor.bytes = bytes.substr(8 + width + length);
  return tensor;
}

bool read_npz(const Archive& archive, TensorTable& table, PolicyProblem& problem) {
  constexpr std::string_view kEnding = ".npy";
  std::size_t unpacked = 0;
  for (const std::string& entry_name : archive.names()) {
    if (!entry_name.ends_with(kEnding)) continue;
    const std::string name = entry_name.substr(0, entry_name.size() - kEnding.size());
    std::string& buffer = table.buffers.emplace_back();
    const auto bytes = archive.read(entry_name, buffer, problem);
    if (!bytes) return false;
    if (!count_unpacked(bytes->size(), unpacked, kNumpyHelp, problem)) return false;
    auto tensor = read_npy(*bytes, name, problem);
    if (!tensor || !table.add(name, std::move(*tensor), problem)) return false;
  }
  return true;
}

}  // namespace eagerx::gen
