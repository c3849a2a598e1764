#include "targets/environments/client/files.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <deque>
#include <filesystem>
#include <fstream>
#include <runtime/host/base/claim.hpp>
#include <runtime/host/base/files.hpp>
#include <sstream>

#include "targets/environments/client/problem.hpp"

namespace eagerx::client {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const char* what, const std::string& path, const std::string& why) {
  throw Problem(kInputOutput, std::string("cannot ") + what + " `" + path + "`: " + why);
}

/// Throws Problem if it was not possible.
void check(int error, const std::string& path) {
  if (error != 0) fail("write", path, host::problem_of_writing(error));
}

}  // namespace

void write_file(const std::string& path, std::string_view bytes) {
  check(host::write_whole(path, bytes), path);
}

void write_files(const std::vector<NewFile>& files) {
  std::deque<host::AtomicFile> drafts;
  for (const NewFile& file : files)
    check(drafts.emplace_back(file.path).write(file.bytes), file.path);
  for (host::AtomicFile& draft : drafts) check(draft.put(), draft.path());
}

void print(std::string_view text) {
  if (const int error = host::print(stdout, text))
    throw Problem(kInputOutput,
                  std::string("cannot write to the standard output: ") + std::strerror(error));
}

void check_writable(const std::string& path) {
  std::error_code error;
  if (path.empty()) fail("write", path, "it has no name");
  if (fs::is_directory(path, error)) fail("write", path, "it is a folder");
  check(host::problem_of_output(path), path);
}

void claim_output(const std::string& path) {
  check_writable(path);
  check(host::claim_output(path), path);
}

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) fail("read", path, std::strerror(errno));
  std::ostringstream bytes;
  bytes << file.rdbuf();
  if (!file || file.bad()) fail("read", path, "it cannot be read to its end");
  return std::move(bytes).str();
}

}  // namespace eagerx::client
