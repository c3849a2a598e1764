// Pickles, read without running them: a pickle is a program that builds objects, and this reader
// only knows the objects that hold tensors, arrays and plain values. A name that it does not know
// is an error before anything else happens; a call is recorded, never made.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/policy/formats/tensors/tensor.hpp"
#include "generator/policy/network/problem.hpp"

namespace eagerx::gen {

/// Letters of a name in a pickle: it is stored once, and may be in a dictionary half a million
/// times.
inline constexpr std::size_t kLongestPickledName = 4096;

/// A value of a pickle. Values refer to each other by index, so that cycles cost nothing.
struct PickleValue {
  enum class Kind : std::uint8_t {
    none,
    boolean,     // integer
    integer,     // integer
    real,        // real
    text,        // text
    bytes,       // text
    sequence,    // items: a list, tuple or set
    dictionary,  // items: key, value, key, value …
    name,        // text: "module.name"
    object,      // function and arguments; state; items as of a dictionary, or appended
    persistent,  // function: what torch.save wrote outside the pickle
    mark,
  };
  Kind kind = Kind::none;
  std::int64_t integer = 0;
  double real = 0.0;
  std::string_view text;
  std::vector<std::uint32_t> items;
  std::uint32_t function = 0, arguments = 0, state = 0;  // 0 is the value None
};

/// The values built so far; values[0] is None.
struct Pickle {
  std::vector<PickleValue> values;
  std::uint32_t root = 0;
  std::size_t end = 0;            // bytes that it took
  std::deque<std::string> names;  // that texts point to, besides the file itself

  [[nodiscard]] const PickleValue& at(std::uint32_t index) const { return values[index]; }
  [[nodiscard]] const PickleValue& top() const { return values[root]; }
  /// A dictionary, or that of the state of an object, or nullptr.
  [[nodiscard]] const PickleValue* dictionary_of(const PickleValue& in) const;
  /// The value of key `key` in a dictionary or in the state of an object, or nullptr.
  [[nodiscard]] const PickleValue* find(const PickleValue& in, std::string_view key) const;
  /// True for an object that `name` ("module.name") made.
  [[nodiscard]] bool made_by(const PickleValue& value, std::string_view name) const;
  /// The value as that type, if it has it; nothing for nullptr.
  [[nodiscard]] std::optional<double> number(const PickleValue* value) const;
  [[nodiscard]] std::optional<std::vector<std::int64_t>> integers(const PickleValue* value) const;
  /// A NumPy array, or a NumPy scalar as one of no dimensions; its bytes are checked.
  [[nodiscard]] std::optional<StoredTensor> array(const PickleValue* value) const;
};

enum class PickleNames : std::uint8_t {
  tensors,     // torch's state dicts
  statistics,  // also NumPy arrays, spaces, VecNormalize
  program,     // TorchScript: tensors, lists, and the modules of the archive's own code
};

/// Whether pickles may use `name` ("module.name"): names that make tensors, arrays and plain
/// values.
bool is_known_in_pickles(std::string_view name, PickleNames known);

/// Reads protocols 2 to 5. E0622: it imports an unknown name. E0623: it is damaged, or uses
/// operations that data never uses.
std::optional<Pickle> read_pickle(std::string_view bytes, PickleNames known,
                                  PolicyProblem& problem);

}  // namespace eagerx::gen
