// Ranks of MPI (MPI: A Message-Passing Interface Standard, version 3.1).
#include <mpi.h>

#include <algorithm>
#include <cstdlib>

#include "targets/environments/campaign/ranks.hpp"
#include "targets/environments/client/problem.hpp"

namespace eagerx::campaign {
namespace {

constexpr int kTag = 0;
// A count is an int.
constexpr std::size_t kMostAtOnce = std::size_t{1} << 30U;

class MpiRanks final : public Ranks {
 public:
  MpiRanks(int& argc, char**& argv) {
    // Threads compute, and one at a time sends.
    int given = 0;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &given);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    if (given >= MPI_THREAD_SERIALIZED) return;
    throw client::Problem(client::kProblems, "this MPI knows no threads (MPI_THREAD_SERIALIZED)");
  }
  ~MpiRanks() override { MPI_Finalize(); }
  MpiRanks(const MpiRanks&) = delete;
  MpiRanks& operator=(const MpiRanks&) = delete;

  std::uint32_t rank() const override { return static_cast<std::uint32_t>(rank_); }
  std::uint32_t size() const override { return static_cast<std::uint32_t>(size_); }

  std::string share(std::string bytes) override {
    std::uint64_t size = bytes.size();
    MPI_Bcast(&size, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
    bytes.resize(size);
    for (std::size_t done = 0; done < bytes.size(); done += kMostAtOnce) {
      const auto count = static_cast<int>(std::min(kMostAtOnce, bytes.size() - done));
      MPI_Bcast(bytes.data() + done, count, MPI_BYTE, 0, MPI_COMM_WORLD);
    }
    return bytes;
  }

  // A chunk has a few kilobytes, so its size fits into an int.
  void send(const std::string& bytes) override {
    MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, 0, kTag, MPI_COMM_WORLD);
  }

  std::optional<std::string> take() override {
    int is_there = 0, size = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &is_there, &status);
    if (is_there == 0) return std::nullopt;
    MPI_Get_count(&status, MPI_BYTE, &size);
    std::string bytes(static_cast<std::size_t>(size), '\0');
    MPI_Recv(bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, kTag, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    return bytes;
  }

  [[noreturn]] void abort(int exit_code) override {
    MPI_Abort(MPI_COMM_WORLD, exit_code);
    std::_Exit(exit_code);
  }

 private:
  int rank_ = 0, size_ = 1;
};

}  // namespace

std::unique_ptr<Ranks> make_ranks(int& argc, char**& argv) {
  return std::make_unique<MpiRanks>(argc, argv);
}

}  // namespace eagerx::campaign
