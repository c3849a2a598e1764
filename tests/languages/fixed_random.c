/* Loaded before a part (LD_PRELOAD): libsodium samples the numbers of targets/PROTOCOL.md. What is of 32 bytes is a secret
   half, what is of 24 the head of a stream. */
#include <dlfcn.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static const char* name(void) { return "those of a page"; }
static uint32_t number(void) { return 4; }
static void nothing(void) {}
static void fill(void* room, size_t size) {
  for (size_t i = 0; i < size; ++i) ((uint8_t*)room)[i] = (uint8_t)((size == 24 ? 0x80 : 0x40) + i);
}
static int close_it(void) { return 0; }

/* randombytes_implementation of libsodium's headers. */
static struct {
  const char* (*name)(void);
  uint32_t (*random)(void);
  void (*stir)(void);
  uint32_t (*uniform)(uint32_t bound);
  void (*fill)(void* room, size_t size);
  int (*close)(void);
} page = {name, number, nothing, 0, fill, close_it};

__attribute__((constructor)) static void begin(void) {
  void* const library = dlopen("libsodium.so.23", RTLD_NOW);
  int (*set)(void*) = 0;
  if (library != 0) *(void**)&set = dlsym(library, "randombytes_set_implementation");
  if (set == 0 || set(&page) != 0) {
    fprintf(stderr, "no libsodium\n");
    exit(1);
  }
}
