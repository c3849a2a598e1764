// The classes of entities, compiled with this machine's compiler under the rules of boards: no
// heap, no exceptions, no functions of <cmath>, no double where the graph calculates in float.
// Every problem is reported at a place in a manifest or a header.
#pragma once

#include <string>
#include <vector>

#include "generator/backend/emit/emit.hpp"

namespace eagerx::gen {

struct CompileOptions {
  std::string compiler;                      // its command
  std::string root;                          // of the built-in runtime and models
  std::vector<std::string> include_folders;  // of the user's own entities
  std::vector<std::string> packages;         // pkg-config's names of libraries
};

/// A temporary folder that no other process uses; removed with its contents.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  /// Empty if it could not be made: errno says why.
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Compiles the program in `files`, which emit() made for the output `folder`, and checks the code
/// of its entities. An entity that needs an operating system may use a heap. Problems: E0510 a
/// missing class, E0511 code that does not compile, E0512 a broken promise, E0513 no compiler,
/// E0901 the files cannot be written.
void check_entities(const Plan& plan, const std::vector<GeneratedFile>& files,
                    const TemporaryFolder& folder, const CompileOptions& options,
                    SourceMap& sources, Diagnostics& diagnostics);

}  // namespace eagerx::gen
