// Uses the heap between the guard's hooks, in the way its argument says: the guard must end it.
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string_view>

extern "C" {
void eagerx_run_begins();
void eagerx_run_ends();
}

namespace {

constexpr std::size_t kBytes = 64;

/// Seen by the compiler only, which must not take the allocation out.
void* volatile sink = nullptr;

bool use_heap(std::string_view how, void* before) {
  if (how == "new") return sink = new char, true;  // NOLINT(cppcoreguidelines-owning-memory)
  if (how == "malloc") return sink = std::malloc(kBytes), true;
  if (how == "calloc") return sink = std::calloc(kBytes, 1), true;
  if (how == "realloc") return sink = std::realloc(before, 2 * kBytes), true;
  if (how == "free") return std::free(before), true;
  if (how == "aligned_alloc") return sink = std::aligned_alloc(kBytes, kBytes), true;
  if (how == "fopen") return sink = std::fopen("/dev/null", "r"), true;
  return how == "nothing";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  void* const before = std::malloc(kBytes);
  sink = before;
  eagerx_run_begins();
  const bool known = use_heap(argv[1], before);
  eagerx_run_ends();
  return known ? 0 : 2;
}
