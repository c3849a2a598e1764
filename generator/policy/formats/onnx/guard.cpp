// Walks through protobuf's wire format without building messages. onnx.proto says which fields are
// messages.
#include "generator/policy/formats/onnx/guard.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace eagerx::gen {
namespace {

constexpr std::int64_t kMostObjects = 500'000;
constexpr std::int64_t kMostNumbers = 16 * kMostObjects;
constexpr std::size_t kDeepest = 100;  // messages in the model, as protobuf

enum class Message : std::uint8_t {
  leaf,  // has no messages in it
  model,
  graph,
  node,
  attribute,
  tensor,
  sparse,
  value,
  type,
  tensor_type,
  element_type,
  map_type,
  shape,
  annotation,
  training,
  function,
};

struct Field {
  Message in;
  std::uint64_t number;
  Message what;
};

constexpr std::array kFields = {
    Field{Message::model, 7, Message::graph},
    Field{Message::model, 8, Message::leaf},
    Field{Message::model, 14, Message::leaf},
    Field{Message::model, 20, Message::training},
    Field{Message::model, 25, Message::function},
    Field{Message::training, 1, Message::graph},
    Field{Message::training, 2, Message::graph},
    Field{Message::training, 3, Message::leaf},
    Field{Message::training, 4, Message::leaf},
    Field{Message::function, 7, Message::node},
    Field{Message::function, 9, Message::leaf},
    Field{Message::function, 11, Message::attribute},
    Field{Message::graph, 1, Message::node},
    Field{Message::graph, 5, Message::tensor},
    Field{Message::graph, 11, Message::value},
    Field{Message::graph, 12, Message::value},
    Field{Message::graph, 13, Message::value},
    Field{Message::graph, 14, Message::annotation},
    Field{Message::graph, 15, Message::sparse},
    Field{Message::annotation, 2, Message::leaf},
    Field{Message::node, 5, Message::attribute},
    Field{Message::attribute, 5, Message::tensor},
    Field{Message::attribute, 6, Message::graph},
    Field{Message::attribute, 10, Message::tensor},
    Field{Message::attribute, 11, Message::graph},
    Field{Message::attribute, 14, Message::type},
    Field{Message::attribute, 15, Message::type},
    Field{Message::attribute, 22, Message::sparse},
    Field{Message::attribute, 23, Message::sparse},
    Field{Message::sparse, 1, Message::tensor},
    Field{Message::sparse, 2, Message::tensor},
    Field{Message::tensor, 3, Message::leaf},
    Field{Message::tensor, 13, Message::leaf},
    Field{Message::value, 2, Message::type},
    Field{Message::type, 1, Message::tensor_type},
    Field{Message::type, 4, Message::element_type},
    Field{Message::type, 5, Message::map_type},
    Field{Message::type, 8, Message::tensor_type},
    Field{Message::type, 9, Message::element_type},
    Field{Message::element_type, 1, Message::type},
    Field{Message::map_type, 2, Message::type},
    Field{Message::tensor_type, 2, Message::shape},
    Field{Message::shape, 1, Message::leaf},
};

std::optional<Message> message_in(Message in, std::uint64_t number) {
  for (const Field& field : kFields) {
    if (field.in == in && field.number == number) return field.what;
  }
  return std::nullopt;
}

/// Fields in which a byte of the file may become a number of eight bytes.
constexpr std::array kPackedNumbers = {
    Field{Message::tensor, 1, Message::leaf},    Field{Message::tensor, 5, Message::leaf},
    Field{Message::tensor, 7, Message::leaf},    Field{Message::tensor, 11, Message::leaf},
    Field{Message::attribute, 8, Message::leaf},
};

bool is_packed(Message in, std::uint64_t number) {
  return std::any_of(kPackedNumbers.begin(), kPackedNumbers.end(),
                     [&](const Field& field) { return field.in == in && field.number == number; });
}

class WireWalk {
 public:
  explicit WireWalk(std::string_view bytes) : bytes_(bytes) {
    open_.push_back({Message::model, bytes.size()});
  }

  bool run() {
    while (!open_.empty()) {
      if (at_ >= open_.back().end) {
        open_.pop_back();
        continue;
      }
      if (!next()) return true;  // damaged
      if (objects_ > kMostObjects || numbers_ > kMostNumbers) return false;
    }
    return true;
  }

 private:
  struct Open {
    Message message;
    std::size_t end;
  };

  bool varint(std::uint64_t& out) {
    constexpr unsigned kMostBits = 64;
    out = 0;
    for (unsigned shift = 0; shift < kMostBits && at_ < bytes_.size(); shift += 7) {
      const auto byte = static_cast<unsigned char>(bytes_[at_++]);
      out |= std::uint64_t{byte & 0x7fU} << shift;
      if ((byte & 0x80U) == 0) return true;
    }
    return false;
  }
  bool skip(std::uint64_t count) {
    if (count > open_.back().end - at_) return false;
    at_ += static_cast<std::size_t>(count);
    return true;
  }

  /// One field. False if protobuf would not read on.
  bool next() {
    std::uint64_t tag = 0;
    std::uint64_t value = 0;
    if (!varint(tag) || at_ > open_.back().end) return false;
    ++numbers_;
    switch (tag & 7U) {
      case 0:
        return varint(value);
      case 1:
        return skip(8);
      case 5:
        return skip(4);
      case 2:
        break;
      default:
        objects_ += kMostObjects + 1;  // groups, which ONNX has none of
        return true;
    }
    ++objects_;
    if (!varint(value) || at_ > open_.back().end || value > open_.back().end - at_) return false;
    const auto inside = message_in(open_.back().message, tag >> 3U);
    if (is_packed(open_.back().message, tag >> 3U)) numbers_ += static_cast<std::int64_t>(value);
    if (!inside) return skip(value);
    if (open_.size() > kDeepest) return false;
    open_.push_back({*inside, at_ + static_cast<std::size_t>(value)});
    return true;
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
  std::int64_t objects_ = 0, numbers_ = 0;
  std::vector<Open> open_;
};

}  // namespace

bool is_onnx_of_few_parts(std::string_view bytes) {
  return WireWalk(bytes).run();
}

}  // namespace eagerx::gen
