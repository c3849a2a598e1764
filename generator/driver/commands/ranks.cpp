#include "generator/driver/commands/ranks.hpp"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "generator/driver/build/exec.hpp"
#include "generator/driver/commands/environments.hpp"
#include "generator/driver/pipeline/paths.hpp"

namespace eagerx::gen {
namespace {

/// The rank that mpirun assigns; 0 of 1 in a process that it has not started.
struct Rank {
  long number = 0, size = 1;
};
Rank rank_of_this() {
  using Names = std::array<const char*, 2>;
  constexpr std::array kNames = {Names{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},  // Open MPI
                                 Names{"PMI_RANK", "PMI_SIZE"}};                         // MPICH
  for (const Names& names : kNames) {
    const char* const number = std::getenv(names[0]);
    const char* const size = std::getenv(names[1]);
    if (number != nullptr && size != nullptr)
      return {std::strtol(number, nullptr, 10), std::strtol(size, nullptr, 10)};
  }
  return {};
}

int complain_of_no_mpi() {
  complain(
      "error: this eagerx-gen was built without MPI\n"
      "help: `toolchains/install-packages mpi`, and build it with `cmake -DEAGERX_MPI=ON`\n");
  return kInputOutput;
}

}  // namespace

int exec_in_ranks(const std::string& name, const GenerateOptions& options,
                  const std::function<int(std::vector<std::string>&)>& words,
                  const std::function<int(const ProcessResult& checked)>& explain) {
  const Rank rank = rank_of_this();
  const std::string shared = name + "-mpi";
  if (rank.size > 1) {
    std::error_code error;
    if (!std::filesystem::exists(helper_program(shared), error))
      return rank.number == 0 ? complain_of_no_mpi() : int{kInputOutput};
    if (rank.number != 0) return exec(helper_program(shared), {});
  }
  std::vector<std::string> all;
  if (const int code = words(all); code != kDone) return code;
  const std::string& program = rank.size > 1 ? shared : name;
  const bool looks_at_graph = options.purpose == Purpose::campaign;
  return exec_with_environments(
      {program.c_str(), name.c_str(), explain, looks_at_graph, rank.size > 1}, options,
      std::move(all));
}

}  // namespace eagerx::gen
