// A library of environments, loaded at run time.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "targets/environments/client/description.hpp"
#include "targets/environments/eagerx_environments.h"

namespace eagerx::client {

/// The functions of eagerx_environments.h that all programs need.
struct LibraryFunctions {
  decltype(&eagerx_version) version;
  decltype(&eagerx_describe) describe;
  decltype(&eagerx_error) error;
  decltype(&eagerx_create) create;
  decltype(&eagerx_destroy) destroy;
  decltype(&eagerx_reset) reset;
  decltype(&eagerx_step) step;
  decltype(&eagerx_stepping) stepping;
  decltype(&eagerx_set_stage) set_stage;  // null where the task has no stages
  decltype(&eagerx_critic) critic;  // null where the critic of a training sees observations only
};

/// Some environments of a library, stepped by the caller's thread. Failures throw Problem.
class Environments {
 public:
  /// Numbers first … first + count - 1 of `seed`. `longest`: steps until they are truncated; 0:
  /// those of the task. `autoreset` as in eagerx_environments.h.
  Environments(const LibraryFunctions& library, std::uint32_t count, std::uint32_t first,
               std::uint64_t seed, std::uint32_t longest, std::uint32_t autoreset);

  /// All begin an episode, the first of `seed`. observation [count][observation numbers].
  void reset(std::uint64_t seed, float* observation);
  /// Those whose byte in `mask` [count] is not 0 begin their next episode; only their rows of
  /// `observation` are written.
  void reset_some(const std::uint8_t* mask, float* observation);
  /// False if a reward is not finite; see error(). The step is complete.
  [[nodiscard]] bool step(const float* action, const eagerx_rows& rows);
  /// Sets the stage of the task from the next reset on; empty: the graph as written.
  void set_stage(const std::string& name);
  /// The inputs of a training's critic, as eagerx_critic() returns them.
  void critic(float* rows, float* final_rows);
  /// How they are stepped, and the reason if that is slow: "vectorized: 64 lanes (avx512)".
  std::string stepping() const;
  /// Why the last call of this thread was not as it should be.
  std::string error() const { return library_.error(); }
  /// For other functions of the library.
  eagerx_environments* handle() const { return handle_.get(); }

 private:
  const LibraryFunctions& library_;
  std::unique_ptr<eagerx_environments, decltype(&eagerx_destroy)> handle_;
  std::vector<std::uint64_t> seeds_;
};

class Library {
 public:
  explicit Library(const std::string& path);

  const LibraryFunctions& functions() const { return functions_; }
  const Description& description() const { return description_; }
  /// Another of its functions. Throws Problem if it has none of this name.
  template <class Function>
  Function find(const char* name) const {
    return reinterpret_cast<Function>(address(name));  // NOLINT: POSIX says so
  }

 private:
  void* address(const char* name) const;

  std::string path_;
  void* library_ = nullptr;  // of dlopen; never closed: its threads and statics may live on
  LibraryFunctions functions_{};
  Description description_;
};

}  // namespace eagerx::client
