// Shared by tests of trainings.
#pragma once

#include <stdlib.h>

#include <cstdint>
#include <filesystem>
#include <string>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/settings.hpp"

namespace eagerx::train {

inline const Interrupt never = false;

/// The message when `work` fails.
template <class Work>
std::string said_by(Work work) {
  try {
    work();
  } catch (const Problem& problem) {
    return problem.what();
  }
  return "nothing";
}

/// The library that is written by hand, pendulum_library.cpp.
inline const Library& pendulum() {
  static const Library library(EAGERX_TEST_PENDULUM);
  return library;
}

/// Steps of all iterations that even_settings() makes.
inline constexpr std::uint64_t kIteration = std::uint64_t{256} * 32;

/// The defaults, but all iterations are of one length.
inline Settings even_settings() {
  Settings settings;
  settings.n_envs = 256;
  settings.n_steps = settings.max_n_steps = 32;
  settings.n_minibatches = 8;
  settings.eval_interval = 5;
  return settings;
}

/// A folder of a test's own, which is gone with it.
class TestFolder {
 public:
  TestFolder() {
    std::string draft = (std::filesystem::temp_directory_path() / "eagerx_train_XXXXXX").string();
    folder_ = mkdtemp(draft.data());
  }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;
  ~TestFolder() { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_;
};

}  // namespace eagerx::train
