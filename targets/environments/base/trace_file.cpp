#include <cstdint>
#include <eagerx/trace_text.hpp>
#include <runtime/host/base/files.hpp>
#include <runtime/host/base/text_file.hpp>
#include <string>
#include <targets/environments/base/problem.hpp>
#include <targets/environments/base/trace_file.hpp>

namespace eagerx::environments {

TraceFile::TraceFile(const std::string& path) : path_(path) {
  if (path.empty()) return;
  // Nothing is printed, not by `-` either.
  if (!file_.open(path == "-" ? "./-" : path)) refuse(cannot_write());
  if (!file_.reserve()) {
    file_.discard();
    refuse("cannot write `" + path + "`: another environment's trace goes into it");
  }
}

void TraceFile::begin(const TracedGraph& graph, std::uint64_t seed, std::uint32_t environment) {
  TraceText<host::TextFile>::head(file_, graph, seed, environment, "library", false);
}

void TraceFile::begin_state(std::uint32_t episode, const std::uint64_t* step, const char* name) {
  file_.text(step == nullptr ? "# state " : "# set ");
  file_.number(episode);
  file_.text(" ");
  if (step != nullptr) {
    file_.number(*step);
    file_.text(" ");
  }
  file_.text(name);
}

void TraceFile::close() {
  if (!file_.close()) refuse(cannot_write());
}

void TraceFile::hand_on() {
  if (file_.failed()) {
    const std::string problem = cannot_write();
    file_.close();
    refuse(problem);
  }
  file_.hand_on(false);
}

std::string TraceFile::cannot_write() const {
  return "cannot write `" + path_ + "`: " + host::problem_of_writing(file_.error());
}

}  // namespace eagerx::environments
