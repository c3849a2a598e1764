// A guard for generated Linux programs: between eagerx_run_begins() and eagerx_run_ends(), which
// the main loop calls around its stepping, any use of the heap ends the program. Linked in as an
// object file:
//   target_sources(<program> PRIVATE tests/support/no_alloc.cpp)
// The functions below take the place of glibc's in the whole process, and glibc's real ones are
// called through their second names. operator new and delete, fopen, printf and all others go
// through them.
#include <pthread.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>

extern "C" {
void* __libc_malloc(std::size_t bytes);
void* __libc_calloc(std::size_t count, std::size_t bytes);
void* __libc_realloc(void* old, std::size_t bytes);
void* __libc_memalign(std::size_t alignment, std::size_t bytes);
void __libc_free(void* memory);

void eagerx_run_begins();
void eagerx_run_ends();
}

namespace {

bool running = false;
unsigned runs = 0;
pthread_t stepper;
bool others_may = false;  // EAGERX_OTHER_THREADS_ALLOCATE: the guard is for the thread that steps

void write_text(const char* text) {
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text, std::strlen(text));
}

void check(const char* function) {
  if (!running || (others_may && pthread_equal(stepper, pthread_self()) == 0)) return;
  running = false;  // abort may need the heap
  write_text("no_alloc: ");
  write_text(function);
  write_text(" was called while the program was stepping\n");
  std::abort();
}

// Proves in the output that the guard was there.
struct Report {
  ~Report() {
    write_text(runs > 0 ? "no_alloc: no allocation while stepping\n" : "no_alloc: no run\n");
  }
} report;

}  // namespace

extern "C" {

void eagerx_run_begins() {
  stepper = pthread_self();
  others_may = std::getenv("EAGERX_OTHER_THREADS_ALLOCATE") != nullptr;
  running = true;
  ++runs;
}
void eagerx_run_ends() {
  running = false;
}

void* malloc(std::size_t bytes) {
  return check("malloc"), __libc_malloc(bytes);
}
void* calloc(std::size_t count, std::size_t bytes) {
  return check("calloc"), __libc_calloc(count, bytes);
}
void* realloc(void* old, std::size_t bytes) {
  return check("realloc"), __libc_realloc(old, bytes);
}
void* memalign(std::size_t alignment, std::size_t bytes) {
  return check("memalign"), __libc_memalign(alignment, bytes);
}
void* aligned_alloc(std::size_t alignment, std::size_t bytes) {
  return check("aligned_alloc"), __libc_memalign(alignment, bytes);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t bytes) {
  check("posix_memalign");
  *memory = __libc_memalign(alignment, bytes);
  return *memory == nullptr ? ENOMEM : 0;
}
void free(void* memory) {
  if (memory != nullptr) check("free");
  __libc_free(memory);
}
}
