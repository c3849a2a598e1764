// A cache of parsed files: for a program that reads the same files over and over,
// with small changes.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string_view>

#include "generator/frontend/read/tree.hpp"

namespace eagerx::gen {

/// Keeps the trees of parts of texts. A file is cut where a key of the file begins, and where an
/// entry of such a key does; parts that are known are copied, the others are parsed. A text that
/// cannot be cut with certainty (a part alone has an error, keys that appear twice, aliases, quotes
/// over several lines) is read as a whole, so that results and messages are those without a memory.
class ReadMemory {
 public:
  ReadMemory();
  ~ReadMemory();
  ReadMemory(const ReadMemory&) = delete;
  ReadMemory& operator=(const ReadMemory&) = delete;

  /// Parses a part; nothing: it has an error.
  using Parse = std::function<std::optional<YamlValue>(std::string_view, const ReadLimits&)>;
  /// The tree of the text with places in `file`; nothing where it has to be read as a whole.
  std::optional<YamlValue> read(FileId file, std::string_view text, const ReadLimits& limits,
                                const Parse& parse);
  /// Of the process, while there is one; else nullptr.
  static ReadMemory* current();

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace eagerx::gen
