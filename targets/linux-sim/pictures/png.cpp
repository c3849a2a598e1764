#include <array>
#include <runtime/host/base/crc32.hpp>
#include <string_view>
#include <targets/linux-sim/pictures/png.hpp>

namespace eagerx::linux_sim {
namespace {

// ISO 15948 (PNG), RFC 1950 and 1951.
void put_u32(std::string& text, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8)
    text.push_back(static_cast<char>(value >> static_cast<unsigned>(shift) & 0xffU));
}

void put_chunk(std::string& file, const char* type, const std::string& data) {
  put_u32(file, static_cast<std::uint32_t>(data.size()));
  const std::size_t begin = file.size();
  file += type;
  file += data;
  put_u32(file, crc32_of(std::string_view(file).substr(begin)));
}

class Bits {
 public:
  explicit Bits(std::string& to) : to_(to) {}
  /// The lowest bit first.
  void put(std::uint32_t value, unsigned count) {
    held_ |= static_cast<std::uint64_t>(value) << have_;
    for (have_ += count; have_ >= 8; have_ -= 8, held_ >>= 8U)
      to_.push_back(static_cast<char>(held_ & 0xffU));
  }
  /// A Huffman code: the highest bit first.
  void put_code(std::uint32_t code, unsigned count) {
    std::uint32_t turned = 0;
    for (unsigned i = 0; i < count; ++i) turned |= (code >> i & 1U) << (count - 1 - i);
    put(turned, count);
  }
  void finish() {
    if (have_ > 0) put(0, 8 - have_);
  }

 private:
  std::string& to_;
  std::uint64_t held_ = 0;
  unsigned have_ = 0;
};

/// A literal, or the code of a length: the fixed codes of RFC 1951, 3.2.6.
void put_symbol(Bits& bits, std::uint32_t symbol) {
  if (symbol < 144) return bits.put_code(0x30 + symbol, 8);
  if (symbol < 256) return bits.put_code(0x190 + symbol - 144, 9);
  if (symbol < 280) return bits.put_code(symbol - 256, 7);
  bits.put_code(0xc0 + symbol - 280, 8);
}

void put_length(Bits& bits, std::uint32_t length) {
  if (length == 258) return put_symbol(bits, 285);
  const std::uint32_t n = length - 3;
  unsigned extra = 0;
  while (n >> (extra + 3U) != 0) ++extra;
  const std::uint32_t symbol = extra == 0 ? 257 + n : 257 + 4 * extra + (n >> extra);
  put_symbol(bits, symbol);
  bits.put(n & ((1U << extra) - 1U), extra);
}
void put_distance(Bits& bits, std::uint32_t distance) {
  const std::uint32_t n = distance - 1;
  unsigned extra = 0;
  while (n >> (extra + 2U) != 0) ++extra;
  const std::uint32_t symbol = extra == 0 ? n : 2 * extra + (n >> extra);
  bits.put_code(symbol, 5);
  bits.put(n & ((1U << extra) - 1U), extra);
}

std::size_t run(const std::string& data, std::size_t at, std::size_t distance) {
  constexpr std::size_t kLongest = 258;
  if (distance > at) return 0;
  std::size_t length = 0;
  while (length < kLongest && at + length < data.size() &&
         data[at + length] == data[at + length - distance])
    ++length;
  return length;
}

/// zlib's form of `data`, whose rows have `stride` bytes.
std::string deflated(const std::string& data, std::size_t stride) {
  constexpr std::size_t kFarthest = 32768, kShortest = 4;
  std::string out("\x78\x01", 2);
  Bits bits(out);
  bits.put(1, 1);  // the last block
  bits.put(1, 2);  // with fixed codes
  for (std::size_t i = 0; i < data.size();) {
    const std::size_t same = run(data, i, 3);
    const std::size_t above = stride <= kFarthest ? run(data, i, stride) : 0;
    const std::size_t longest = same >= above ? same : above;
    if (longest < kShortest) {
      put_symbol(bits, static_cast<unsigned char>(data[i++]));
      continue;
    }
    put_length(bits, static_cast<std::uint32_t>(longest));
    put_distance(bits, static_cast<std::uint32_t>(same >= above ? 3 : stride));
    i += longest;
  }
  put_symbol(bits, 256);
  bits.finish();
  std::uint32_t a = 1, b = 0;
  for (const char c : data) {
    a = (a + static_cast<unsigned char>(c)) % 65521U;
    b = (b + a) % 65521U;
  }
  put_u32(out, b << 16U | a);
  return out;
}

}  // namespace

std::string png_of(const std::uint8_t* pixels, int width, int height) {
  const std::size_t row = static_cast<std::size_t>(width) * 3;
  std::string data;
  data.reserve((row + 1) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    data.push_back(0);  // no filter
    data.append(reinterpret_cast<const char*>(pixels) + static_cast<std::size_t>(y) * row, row);
  }
  std::string head;
  put_u32(head, static_cast<std::uint32_t>(width));
  put_u32(head, static_cast<std::uint32_t>(height));
  head += std::string("\x08\x02\x00\x00\x00", 5);  // 8 bits, red green blue
  std::string file("\x89PNG\r\n\x1a\n", 8);
  put_chunk(file, "IHDR", head);
  put_chunk(file, "IDAT", deflated(data, row + 1));
  put_chunk(file, "IEND", "");
  return file;
}

}  // namespace eagerx::linux_sim
