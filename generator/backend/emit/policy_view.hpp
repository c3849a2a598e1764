// The view of a network for templates/cpp/policy.hpp.mustache.
#pragma once

#include <cstddef>
#include <cstdint>
#include <kainjow/mustache.hpp>
#include <string>
#include <vector>

#include "generator/policy/network/network.hpp"

namespace eagerx::gen {

/// The form of a policy's tables in its view.
class PolicyTables {
 public:
  enum class Kind : std::uint8_t {
    text,    // in the view, number by number
    blocks,  // the same, but the view has marks of them, so that a template does not copy megabytes
    stored,  // bytes of a file next to the header
    none,    // not shown
  };
  /// `name_space` of `stored`: where the tables are declared, such as graphs::pendulum::policy.
  explicit PolicyTables(Kind kind, std::string name_space = {})
      : kind_(kind), name_space_(std::move(name_space)) {}

  [[nodiscard]] bool is_stored() const { return kind_ == Kind::stored; }

  /// The view's replacement for a text. `make` is called only if the text is needed.
  template <class Make>
  std::string text(const Make& make) {
    if (kind_ == Kind::text) return make();
    return kind_ == Kind::blocks ? mark_of(make()) : std::string();
  }

  /// The bytes of eagerx::DenseWeights or Int8Weights, numbers, and indices of 16 or 32 bits.
  void add(const Layer& dense);
  void add(const std::vector<float>& numbers);
  void add(const std::vector<std::uint32_t>& indices, bool are_wide);
  /// Where the next table begins.
  std::size_t begin();
  /// The declaration of the table since then; false if nothing was added.
  kainjow::mustache::data declaration(std::size_t begin, const std::string& type,
                                      const std::string& constant, const std::string& extent) const;

  [[nodiscard]] const std::string& bytes() const { return bytes_; }
  std::string take_bytes() { return std::move(bytes_); }
  /// `rendered` with the marks replaced by their texts.
  [[nodiscard]] std::string put_blocks(const std::string& rendered) const;

 private:
  std::string mark_of(std::string block);

  Kind kind_;
  std::string name_space_;
  std::string bytes_;
  std::vector<std::string> blocks_;
};

/// Bytes of a network's tables in flash.
std::size_t flash_bytes(const Network& network);

/// Keys: file, format, inputs, outputs, parameters, bytes, layers (each: number, inputs, outputs,
/// activation, slope, weights, biases, input, output, hidden, plain, norm, gamma, beta, epsilon,
/// stored), normalization (source, mean, deviation, clip), has_rows, rows, self_test (each:
/// observation, answer), stored (size, hash). The template also needs `namespace`, the graph's.
/// `real`: the type of its numbers.
kainjow::mustache::data policy_view(const Network& network, PolicyTables& tables,
                                    const std::string& real = "float");

}  // namespace eagerx::gen
