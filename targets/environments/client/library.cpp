#include "targets/environments/client/library.hpp"

#include <dlfcn.h>

#include <numeric>
#include <runtime/host/base/handover.hpp>

#include "targets/environments/client/problem.hpp"

namespace eagerx::client {
namespace {

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

void Environments::reset_some(const std::uint8_t* mask, float* observation) {
  if (library_.reset(handle_.get(), mask, nullptr, observation) != 0)
    fail(library_, "cannot reset the environments");
}

bool Environments::step(const float* action, const eagerx_rows& rows) {
  const int result = library_.step(handle_.get(), action, &rows);
  if (result < 0) fail(library_, "cannot step the environments");
  return result == 0;
}

void Environments::set_stage(const std::string& name) {
  if (library_.set_stage == nullptr) return;
  if (library_.set_stage(handle_.get(), nullptr, name.c_str()) != 0)
    fail(library_, "cannot set the stage of the environments");
}

void Environments::critic(float* rows, float* final_rows) {
  if (library_.critic(handle_.get(), rows, final_rows) != 0)
    fail(library_, "cannot ask what the critic sees");
}

std::string Environments::stepping() const {
  const char* const text = library_.stepping(handle_.get());
  if (text == nullptr) fail(library_, "cannot ask how environments are stepped");
  return text;
}

void* Library::address(const char* name) const {
  void* const found = dlsym(library_, name);
  if (found != nullptr) return found;
  throw Problem(kInputOutput, "`" + path_ + "` is not a library of environments: it has no " + name,
                "make one with `eagerx-gen generate GRAPH.yaml --target environments`");
}

Library::Library(const std::string& path) : path_(path) {
  const std::string file = path.find('/') == std::string::npos ? "./" + path : path;
  library_ = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library_ == nullptr) {
    throw Problem(kInputOutput, "cannot load `" + path + "`: " + dlerror());
  }
  functions_.version = find<decltype(&eagerx_version)>("eagerx_version");
  if (functions_.version() != EAGERX_ENVIRONMENTS_VERSION) {
    throw Problem(kInputOutput,
                  "`" + path + "` has version " + std::to_string(functions_.version()) +
                      " of the interface, and this program needs version " +
                      std::to_string(EAGERX_ENVIRONMENTS_VERSION),
                  "build the library again with this version of eagerx-gen");
  }
  functions_.describe = find<decltype(&eagerx_describe)>("eagerx_describe");
  functions_.error = find<decltype(&eagerx_error)>("eagerx_error");
  functions_.create = find<decltype(&eagerx_create)>("eagerx_create");
  functions_.destroy = find<decltype(&eagerx_destroy)>("eagerx_destroy");
  functions_.reset = find<decltype(&eagerx_reset)>("eagerx_reset");
  functions_.step = find<decltype(&eagerx_step)>("eagerx_step");
  functions_.stepping = find<decltype(&eagerx_stepping)>("eagerx_stepping");
  description_ = read_description(functions_.describe());
  host::release_output_locks();
  if (const std::string other = host::problem_of_graph(description_.program); !other.empty())
    throw Problem(kInputOutput, "`" + path + "`: " + other,
                  "something has changed the folder while it was built: run the command again");
  if (!description_.stages.empty())
    functions_.set_stage = find<decltype(&eagerx_set_stage)>("eagerx_set_stage");
  if (description_.critic_numbers() > 0)
    functions_.critic = find<decltype(&eagerx_critic)>("eagerx_critic");
}

}  // namespace eagerx::client
