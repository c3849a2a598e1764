// A plugin of QEMU that counts the instructions of functions from their first one to their return,
// those of callees included, without exception handlers.
//   qemu-system-arm … -plugin counter.so,plan=FILE,counts=FILE
// Lines of the plan, in hexadecimal: `e ADDRESS 0`, the entry of a function to count; `c ADDRESS
// NEXT`, a call and the instruction behind it; `h FIRST END`, a handler. Lines of the counts:
// address, the most of a call, the number of calls. Debian has no header of the interface:
// https://www.qemu.org/docs/master/devel/tcg-plugins.html
#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EXPORT __attribute__((visibility("default")))

struct qemu_plugin_tb;
struct qemu_plugin_insn;
void qemu_plugin_register_vcpu_tb_trans_cb(uint64_t id,
                                           void (*call)(uint64_t id, struct qemu_plugin_tb* block));
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb* block);
struct qemu_plugin_insn* qemu_plugin_tb_get_insn(const struct qemu_plugin_tb* block, size_t i);
uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn* instruction);
void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn* instruction,
                                            void (*call)(unsigned cpu, void* data), int flags,
                                            void* data);
void qemu_plugin_register_vcpu_insn_exec_inline(struct qemu_plugin_insn* instruction, int operation,
                                                void* number, uint64_t added);
void qemu_plugin_register_atexit_cb(uint64_t id, void (*call)(uint64_t id, void* data), void* data);

EXPORT int qemu_plugin_version = PLUGIN_VERSION;

enum { kMostEntries = 1 << 20, kMostFrames = 1 << 12, kMostHandlers = 16 };

// Data of an instruction, one for each halfword of the code.
struct place {
  uint32_t at, next;  // `next`: behind a call; 0: it is none
  uint64_t most, calls;
  bool is_entry, is_behind;
};
static struct place* places[kMostEntries];
static struct { uint32_t first, end; } handlers[kMostHandlers];
static unsigned handler_count, frame_count;
static struct {
  struct place* function;
  uint64_t begun;
  uint32_t back;
} frames[kMostFrames];
static uint64_t executed;
static uint32_t back;  // behind the last call, until its callee begins; 0: none
static const char* counts_file;

static struct place* place_of(uint32_t at) {
  for (uint32_t i = at / 2 * 2654435761U;; ++i) {
    struct place** found = &places[i % kMostEntries];
    if (*found != NULL && (*found)->at != at) continue;
    if (*found == NULL) {
      *found = calloc(1, sizeof(struct place));
      (*found)->at = at;
    }
    return *found;
  }
}

static bool is_in_handler(uint32_t at) {
  for (unsigned i = 0; i < handler_count; ++i)
    if (at >= handlers[i].first && at < handlers[i].end) return true;
  return false;
}

// Before a call, behind one, and at an entry: nothing else is of interest but its number.
static void on_place(unsigned cpu, void* data) {
  (void)cpu;
  struct place* here = data;
  while (frame_count > 0 && frames[frame_count - 1].back == here->at) {
    struct place* function = frames[--frame_count].function;
    const uint64_t count = executed - frames[frame_count].begun;
    if (count > function->most) function->most = count;
    ++function->calls;
  }
  if (here->is_entry && back != 0 && back != here->at) {
    if (frame_count == kMostFrames) abort();
    frames[frame_count].function = here;
    frames[frame_count].begun = executed;
    frames[frame_count++].back = back;
  }
  back = here->next;
}

// Since version 2 the interface has no addition for all processors.
#if PLUGIN_VERSION >= 2
static void add_one(unsigned cpu, void* data) {
  (void)cpu, (void)data;
  ++executed;
}
static void count(struct qemu_plugin_insn* instruction) {
  qemu_plugin_register_vcpu_insn_exec_cb(instruction, add_one, 0, NULL);
}
#else
static void count(struct qemu_plugin_insn* instruction) {
  enum { kAdd = 0 };
  qemu_plugin_register_vcpu_insn_exec_inline(instruction, kAdd, &executed, 1);
}
#endif

static void on_block(uint64_t id, struct qemu_plugin_tb* block) {
  (void)id;
  for (size_t i = 0; i < qemu_plugin_tb_n_insns(block); ++i) {
    struct qemu_plugin_insn* instruction = qemu_plugin_tb_get_insn(block, i);
    struct place* place = place_of((uint32_t)qemu_plugin_insn_vaddr(instruction));
    if (is_in_handler(place->at)) continue;
    if (place->is_entry || place->is_behind || place->next != 0)
      qemu_plugin_register_vcpu_insn_exec_cb(instruction, on_place, 0, place);
    count(instruction);
  }
}

static void write_counts(uint64_t id, void* data) {
  (void)id, (void)data;
  FILE* file = fopen(counts_file, "w");
  if (file == NULL) return;
  for (unsigned i = 0; i < kMostEntries; ++i)
    if (places[i] != NULL && places[i]->calls > 0)
      fprintf(file, "%" PRIx32 " %" PRIu64 " %" PRIu64 "\n", places[i]->at, places[i]->most,
              places[i]->calls);
  fclose(file);
}

static bool read_plan(const char* path) {
  FILE* file = fopen(path, "r");
  if (file == NULL) return false;
  char kind = 0;
  uint32_t first = 0, second = 0;
  while (fscanf(file, " %c %" SCNx32 " %" SCNx32, &kind, &first, &second) == 3) {
    if (kind == 'e') place_of(first)->is_entry = true;
    if (kind == 'c') {
      place_of(first)->next = second;
      place_of(second)->is_behind = true;
    }
    if (kind == 'h' && handler_count < kMostHandlers) {
      handlers[handler_count].first = first;
      handlers[handler_count++].end = second;
    }
  }
  fclose(file);
  return true;
}

EXPORT int qemu_plugin_install(uint64_t id, const void* info, int argc, char** argv) {
  (void)info;
  const char* plan = NULL;
  for (int i = 0; i < argc; ++i) {
    if (strncmp(argv[i], "plan=", 5) == 0) plan = argv[i] + 5;
    if (strncmp(argv[i], "counts=", 7) == 0) counts_file = strdup(argv[i] + 7);
  }
  if (plan == NULL || counts_file == NULL || !read_plan(plan)) return 1;
  qemu_plugin_register_vcpu_tb_trans_cb(id, on_block);
  qemu_plugin_register_atexit_cb(id, write_counts, NULL);
  return 0;
}
