// What tests of trainings share.
#pragma once

#include <stdlib.h>

#include <filesystem>
#include <string>

#include "targets/environments/train/client.hpp"

namespace eagerx::train {

inline const Interrupt never = false;

/// The library that is written by hand, pendulum_library.cpp.
inline const Library& pendulum() {
  static const Library library(EAGERX_TEST_PENDULUM);
  return library;
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
