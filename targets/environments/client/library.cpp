#include "targets/environments/client/library.hpp"

#include <dlfcn.h>

#include <numeric>

#include "targets/environments/client/problem.hpp"

namespace eagerx::client {
namespace {

template <class Function>
void find(void* library, const std::string& path, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));  // NOLINT: POSIX says so
  if (function != nullptr) return;
  throw Problem(kInputOutput, "`" + path + "` is no library of environments: it has no " + name,
                "make one with `eagerx-gen generate GRAPH.yaml --target environments`");
}

[[noreturn]] void fail(const LibraryFunctions& library, const char* what) {
  throw Problem(kProblems, std::string(what) + ": " + library.error());
}

}  // namespace

Environments::Environments(const LibraryFunctions& library, std::uint32_t count,
                           std::uint32_t first, std::uint64_t seed, std::uint32_t longest,
                           std::uint32_t autoreset)
    : library_(library), handle_(nullptr, library.destroy), seeds_(count, seed) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), first);
  const eagerx_options options{
      sizeof(eagerx_options), count, numbers.data(), seed, longest, autoreset, 1, 0};
  handle_.reset(library.create(&options));
  if (!handle_) fail(library, "cannot make the environments");
}

void Environments::reset(std::uint64_t seed, float* observation) {
  seeds_.assign(seeds_.size(), seed);
  if (library_.reset(handle_.get(), nullptr, seeds_.data(), observation) != 0) {
    fail(library_, "cannot reset the environments");
  }
}

void Environments::step(const float* action, const eagerx_rows& rows) {
  if (library_.step(handle_.get(), action, &rows) != 0) {
    fail(library_, "cannot step the environments");
  }
}

Library::Library(const std::string& path) {
  const std::string file = path.find('/') == std::string::npos ? "./" + path : path;
  // Never closed: threads and statics of a library may live on.
  void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    throw Problem(kInputOutput, "cannot load `" + path + "`: " + dlerror());
  }
  find(library, path, "eagerx_version", functions_.version);
  if (functions_.version() != EAGERX_ENVIRONMENTS_VERSION) {
    throw Problem(kInputOutput,
                  "`" + path + "` has version " + std::to_string(functions_.version()) +
                      " of the interface, and this program needs version " +
                      std::to_string(EAGERX_ENVIRONMENTS_VERSION),
                  "build the library again with this version of eagerx-gen");
  }
  find(library, path, "eagerx_describe", functions_.describe);
  find(library, path, "eagerx_error", functions_.error);
  find(library, path, "eagerx_create", functions_.create);
  find(library, path, "eagerx_destroy", functions_.destroy);
  find(library, path, "eagerx_reset", functions_.reset);
  find(library, path, "eagerx_step", functions_.step);
  description_ = read_description(functions_.describe());
}

}  // namespace eagerx::client
