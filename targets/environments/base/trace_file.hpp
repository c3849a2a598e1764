// The trace file that a caller requested.
#pragma once

#include <cstdint>
#include <eagerx/trace_text.hpp>
#include <runtime/host/base/text_file.hpp>
#include <string>

namespace eagerx::environments {

/// The file keeps its contents if nothing is written.
class TraceFile {
 public:
  /// Throws Problem if `path` cannot be written, or is written as another trace. Empty: no file.
  explicit TraceFile(const std::string& path);

  bool is_open() const { return file_.is_open(); }
  host::TextFile& text() { return file_; }
  /// Whether it is the file `path`, by any name.
  bool is(const std::string& path) const { return file_.is_same_file(path); }

  /// `seed`, `environment`: of the first episode.
  void begin(const TracedGraph& graph, std::uint64_t seed, std::uint32_t environment);
  /// Lines `# state EPISODE NAME VALUE,…`, from which a replay takes the states, and
  /// `# set EPISODE STEP NAME VALUE,…`: up to the values. `step`: null for the former.
  void begin_state(std::uint32_t episode, const std::uint64_t* step, const char* name);

  void discard() { file_.discard(); }
  /// Throws Problem if something of it is lost.
  void close();
  /// Behind each step: rows are in the file after half a second. Throws Problem, and is closed.
  void hand_on();

 private:
  std::string cannot_write() const;

  std::string path_;
  host::TextFile file_;
};

}  // namespace eagerx::environments
