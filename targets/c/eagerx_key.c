/* Connection with a key: targets/PROTOCOL.md. */
#define _GNU_SOURCE
#include "eagerx_key.h"

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define LIBRARY "libsodium.so.23"
#define MAKE_ONE "\nhelp: `eagerx-gen key new FILE` writes one"
#define DIGITS "0123456789abcdef"

static const char kTitle[] = "eagerx-key-link1";
static const char kKeyTitle[] = "eagerx-gen key 1 ";
static const char kFromListener[] = "eagerx link 1: from who listens.";
static const char kFromConnector[] = "eagerx link 1: from who connects";
enum {
  kKeyText = sizeof kKeyTitle - 1 + 2 * EAGERX_NUMBER + 1,
  kDirection = sizeof kFromListener - 1
};
enum { kMessage = 0, kFinal = 3, kLength = 2 };

/* All return 0 on success, and -1 if they refuse. */
static struct {
  int (*init)(void);
  int (*keypair)(uint8_t* open, uint8_t* secret);
  int (*session_keys)(uint8_t* in, uint8_t* out, const uint8_t* open, const uint8_t* secret,
                      const uint8_t* other);
  int (*generichash)(uint8_t* out, size_t out_size, const uint8_t* bytes, unsigned long long size,
                     const uint8_t* key, size_t key_size);
  int (*init_push)(uint8_t* state, uint8_t* head, const uint8_t* key);
  int (*push)(uint8_t* state, uint8_t* sealed, unsigned long long* sealed_size,
              const uint8_t* bytes, unsigned long long size, const uint8_t* also,
              unsigned long long also_size, uint8_t tag);
  int (*init_pull)(uint8_t* state, const uint8_t* head, const uint8_t* key);
  int (*pull)(uint8_t* state, uint8_t* bytes, unsigned long long* size, uint8_t* tag,
              const uint8_t* sealed, unsigned long long sealed_size, const uint8_t* also,
              unsigned long long also_size);
  size_t (*state_bytes)(void);
  size_t (*head_bytes)(void);
  size_t (*seal_bytes)(void);
} sodium;

static int find_sodium(void) {
  static const char* const names[] = {"sodium_init",
                                      "crypto_kx_keypair",
                                      "crypto_kx_server_session_keys",
                                      "crypto_generichash",
                                      "crypto_secretstream_xchacha20poly1305_init_push",
                                      "crypto_secretstream_xchacha20poly1305_push",
                                      "crypto_secretstream_xchacha20poly1305_init_pull",
                                      "crypto_secretstream_xchacha20poly1305_pull",
                                      "crypto_secretstream_xchacha20poly1305_statebytes",
                                      "crypto_secretstream_xchacha20poly1305_headerbytes",
                                      "crypto_secretstream_xchacha20poly1305_abytes"};
  void* const functions[] = {&sodium.init,        &sodium.keypair,   &sodium.session_keys,
                             &sodium.generichash, &sodium.init_push, &sodium.push,
                             &sodium.init_pull,   &sodium.pull,      &sodium.state_bytes,
                             &sodium.head_bytes,  &sodium.seal_bytes};
  void* const library = dlopen(LIBRARY, RTLD_NOW | RTLD_LOCAL);
  if (library == 0) return 0;
  for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
    void* const found = dlsym(library, names[i]);
    if (found == 0) return 0;
    memcpy(functions[i], &found, sizeof found);
  }
  return sodium.init() >= 0 && sodium.state_bytes() == EAGERX_STATE &&
         sodium.head_bytes() == EAGERX_HEAD && sodium.seal_bytes() == EAGERX_SEAL;
}

static int digit(char c) {
  const char* const found = c == '\0' ? 0 : strchr(DIGITS, c);
  return found == 0 ? -1 : (int)(found - DIGITS);
}

/* Parses the text of a key file. Returns 0 if it is invalid. */
static int is_key(const char* text, struct eagerx_key* key) {
  const char* const digits = text + sizeof kKeyTitle - 1;
  if (memcmp(text, kKeyTitle, sizeof kKeyTitle - 1) != 0 || text[kKeyText - 1] != '\n') return 0;
  for (int i = 0; i < EAGERX_NUMBER; ++i) {
    const int high = digit(digits[2 * i]), low = digit(digits[2 * i + 1]);
    if (high < 0 || low < 0) return 0;
    key->bytes[i] = (uint8_t)(high * 16 + low);
  }
  return 1;
}

/* Returns 0 on failure, with the reason in `problem`. */
static int read_key(int file, const char* path, struct eagerx_key* key, char* problem,
                    size_t room) {
  struct stat status;
  char text[kKeyText + 1] = "";
  if (fstat(file, &status) != 0) return snprintf(problem, room, "%s", strerror(errno)), 0;
  if (!S_ISREG(status.st_mode)) return snprintf(problem, room, "it is not a file" MAKE_ONE), 0;
  if (status.st_uid != geteuid())
    return snprintf(problem, room,
                    "it belongs to another user\nhelp: make a copy for each user: `install -m 600 "
                    "FILE COPY`"),
           0;
  if ((status.st_mode & (S_IRWXG | S_IRWXO)) != 0)
    return snprintf(problem, room,
                    "others can read it, or write it\nhelp: chmod 600 %s; if others may have "
                    "read it, take a new key",
                    path),
           0;
  const ssize_t size = read(file, text, sizeof text);
  int good = 0;
  if (size < 0)
    snprintf(problem, room, "%s", strerror(errno));
  else if (size != kKeyText)
    snprintf(problem, room, "it is not a key: it has %d bytes%s, a key has %d" MAKE_ONE, (int)size,
             size > kKeyText ? " or more" : "", (int)kKeyText);
  else if (!(good = is_key(text, key)))
    snprintf(problem, room,
             "it is not a key: a key is a line `%s` and 64 of the digits " DIGITS MAKE_ONE, kKeyTitle);
  explicit_bzero(text, sizeof text);
  return good;
}

int eagerx_key_use(const char* path, struct eagerx_key* key, char* problem, size_t room) {
  if (!find_sodium())
    return snprintf(problem, room,
                    "a key needs the library libsodium, `" LIBRARY
                    "`\nhelp: apt install libsodium23"),
           0;
  const int begin = snprintf(problem, room, "cannot use the key `%s`: ", path);
  const size_t used = (size_t)begin < room ? (size_t)begin : room - 1;
  const int file =
      open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY); /* a FIFO would block */
  if (file < 0)
    return snprintf(problem + used, room - used, "%s%s", strerror(errno),
                    errno == ENOENT ? MAKE_ONE : ""),
           0;
  const int good = read_key(file, path, key, problem + used, room - used);
  close(file);
  return good;
}

size_t eagerx_seal(struct eagerx_records* records, const uint8_t* bytes, size_t size,
                   uint8_t* sealed) {
  unsigned long long sealed_size = 0;
  sealed[0] = (uint8_t)size; /* authenticated, too */
  sealed[1] = (uint8_t)(size >> 8);
  sodium.push(records->out, sealed + kLength, &sealed_size, bytes, size, sealed, kLength,
              size == 0 ? kFinal : kMessage);
  return kLength + (size_t)sealed_size;
}

enum eagerx_found eagerx_open(struct eagerx_records* records, uint8_t* bytes, size_t* size) {
  uint8_t* const taken = records->taken;
  *size = 0;
  if (records->is_over) return EAGERX_FORGED;
  if (records->taken_size < kLength) return EAGERX_NOTHING;
  const size_t length = (size_t)taken[0] | (size_t)taken[1] << 8;
  const size_t whole = kLength + length + EAGERX_SEAL;
  records->is_over = length > EAGERX_RECORD;
  if (records->is_over) return EAGERX_FORGED;
  if (records->taken_size < whole) return EAGERX_NOTHING;
  unsigned long long opened = 0;
  uint8_t tag = 0;
  const int good = sodium.pull(records->in, bytes, &opened, &tag, taken + kLength,
                               length + EAGERX_SEAL, taken, kLength) == 0;
  records->taken_size -= whole;
  memmove(taken, taken + whole, records->taken_size);
  const int is_end = good && tag == kFinal && length == 0;
  records->is_over = !good || tag != kMessage || length == 0;
  if (records->is_over) return is_end ? EAGERX_END : EAGERX_FORGED;
  *size = (size_t)opened;
  return EAGERX_OPENED;
}

void eagerx_greeting_begin(struct eagerx_greeting* greeting, const struct eagerx_key* key) {
  memset(greeting, 0, sizeof *greeting);
  greeting->key = *key;
  sodium.keypair(greeting->own, greeting->secret);
}

size_t eagerx_greeting_wanted(const struct eagerx_greeting* greeting) {
  if (greeting->is_done) return 0;
  return (greeting->has_said ? EAGERX_PROOF : EAGERX_HELLO) - greeting->taken_size;
}

/* Derives the key of one direction, with the key of the file. */
static void mix(const struct eagerx_greeting* greeting, const char* direction,
                const uint8_t* shared, uint8_t* stream_key) {
  uint8_t text[kDirection + EAGERX_NUMBER + EAGERX_SAID];
  memcpy(text, direction, kDirection);
  memcpy(text + kDirection, shared, EAGERX_NUMBER);
  memcpy(text + kDirection + EAGERX_NUMBER, greeting->said, EAGERX_SAID);
  sodium.generichash(stream_key, EAGERX_NUMBER, text, sizeof text, greeting->key.bytes,
                     EAGERX_NUMBER);
  explicit_bzero(text, sizeof text);
}

static int make_answer(struct eagerx_greeting* greeting, uint8_t* answer) {
  const uint8_t* const other = greeting->taken + EAGERX_TITLE;
  uint8_t in[EAGERX_NUMBER], out[EAGERX_NUMBER], out_key[EAGERX_NUMBER];
  const uint8_t nothing = 0;
  memcpy(greeting->said, greeting->taken, EAGERX_HELLO);
  memcpy(greeting->said + EAGERX_HELLO, greeting->own, EAGERX_NUMBER);
  if (memcmp(other, greeting->own, EAGERX_NUMBER) == 0) return -1; /* our own key sent back */
  if (sodium.session_keys(in, out, greeting->own, greeting->secret, other) != 0)
    return -1; /* a weak key, which is never sampled */
  mix(greeting, kFromConnector, in, greeting->in_key);
  mix(greeting, kFromListener, out, out_key);
  memcpy(answer, greeting->own, EAGERX_NUMBER);
  sodium.init_push(greeting->out, answer + EAGERX_NUMBER, out_key);
  sodium.push(greeting->out, answer + EAGERX_NUMBER + EAGERX_HEAD, 0, &nothing, 0, greeting->said,
              EAGERX_SAID, kMessage);
  explicit_bzero(in, sizeof in);
  explicit_bzero(out, sizeof out);
  explicit_bzero(out_key, sizeof out_key);
  greeting->has_said = 1;
  return EAGERX_ANSWER;
}

static int check_proof(struct eagerx_greeting* greeting) {
  uint8_t nothing = 0, tag = 0;
  unsigned long long size = 0;
  greeting->is_done =
      sodium.init_pull(greeting->in, greeting->taken, greeting->in_key) == 0 &&
      sodium.pull(greeting->in, &nothing, &size, &tag, greeting->taken + EAGERX_HEAD, EAGERX_SEAL,
                  greeting->said, EAGERX_SAID) == 0 &&
      tag == kMessage;
  return greeting->is_done ? 0 : -1;
}

int eagerx_greeting_take(struct eagerx_greeting* greeting, const uint8_t* bytes, size_t size,
                         uint8_t* answer) {
  const size_t wanted = eagerx_greeting_wanted(greeting);
  const size_t count = size < wanted ? size : wanted;
  memcpy(greeting->taken + greeting->taken_size, bytes, count);
  greeting->taken_size += count;
  /* Reject a peer that begins differently at once. */
  const size_t title = greeting->taken_size < EAGERX_TITLE ? greeting->taken_size : EAGERX_TITLE;
  if (!greeting->has_said && memcmp(greeting->taken, kTitle, title) != 0) return -1;
  if (count < wanted || wanted == 0) return 0;
  greeting->taken_size = 0;
  return greeting->has_said ? check_proof(greeting) : make_answer(greeting, answer);
}

void eagerx_greeting_go_on(struct eagerx_greeting* greeting, struct eagerx_records* records) {
  memset(records, 0, sizeof *records);
  memcpy(records->out, greeting->out, sizeof records->out);
  memcpy(records->in, greeting->in, sizeof records->in);
  explicit_bzero(greeting, sizeof *greeting);
}
