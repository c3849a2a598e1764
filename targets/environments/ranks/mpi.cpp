// Ranks of MPI (MPI: A Message-Passing Interface Standard, version 3.1).
#include <mpi.h>
#include <sched.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <limits>
#include <runtime/host/base/interrupt.hpp>

#include "targets/environments/client/problem.hpp"
#include "targets/environments/ranks/ranks.hpp"

namespace eagerx::environments {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kTag = 0;
// A count is an int.
constexpr std::size_t kMostAtOnce = std::size_t{1} << 30U;
/// How long rank 0 waits for the others after a signal, who may be at work still. Open MPI's mpirun
/// kills a second after its SIGTERM, and a checkpoint is written in between.
constexpr std::chrono::milliseconds kPatience(300);

/// Pieces of a collective operation: counts, and where they begin.
struct Pieces {
  explicit Pieces(std::span<const std::size_t> sizes) {
    std::size_t at = 0;
    for (const std::size_t size : sizes) {
      counts.push_back(static_cast<int>(size));
      places.push_back(static_cast<int>(at));
      at += size;
    }
    if (at > static_cast<std::size_t>(std::numeric_limits<int>::max()))
      throw client::Problem(client::kProblems, "ranks cannot send more than 2 GB at once");
  }
  std::vector<int> counts, places;
};

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

  using Ranks::gather;
  void gather(std::span<const char> mine, std::span<char> all,
              std::span<const std::size_t> sizes) override {
    const Pieces pieces(sizes);
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Iallgatherv(mine.data(), static_cast<int>(mine.size()), MPI_BYTE, all.data(),
                    pieces.counts.data(), pieces.places.data(), MPI_BYTE, MPI_COMM_WORLD, &request);
    wait(request);
  }

  void exchange(std::span<const char> out, std::span<const std::size_t> out_sizes,
                std::span<char> in, std::span<const std::size_t> in_sizes) override {
    const Pieces given(out_sizes), taken(in_sizes);
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ialltoallv(out.data(), given.counts.data(), given.places.data(), MPI_BYTE, in.data(),
                   taken.counts.data(), taken.places.data(), MPI_BYTE, MPI_COMM_WORLD, &request);
    wait(request);
  }

 private:
  /// Rank 0 gives up when it is interrupted and the others do not come. They never do: what they
  /// know is known to rank 0, which ends them.
  void wait(MPI_Request& request) const {
    std::optional<Clock::time_point> interrupted_at;
    for (int is_done = 0;;) {
      MPI_Test(&request, &is_done, MPI_STATUS_IGNORE);
      if (is_done != 0) return;
      sched_yield();
      if (rank_ != 0 || !host::interrupted()) continue;
      if (!interrupted_at) interrupted_at = Clock::now();
      if (Clock::now() - *interrupted_at < kPatience) continue;
      throw client::Problem(client::kInterrupted, "another rank is gone, or still at work",
                            "`--resume` continues from the last checkpoint");
    }
  }

  int rank_ = 0, size_ = 1;
};

}  // namespace

std::unique_ptr<Ranks> make_ranks(int& argc, char**& argv) {
  return std::make_unique<MpiRanks>(argc, argv);
}

}  // namespace eagerx::environments
