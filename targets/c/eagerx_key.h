/* A line with a key, of which this is the end that listens: its file, the greeting, and records, as
   the section "With a key" of targets/PROTOCOL.md says them. All that is cryptography is
   libsodium's, which is looked for when a key is used. No sockets are in here: bytes go in and out.
 */
#ifndef EAGERX_KEY_H
#define EAGERX_KEY_H

#include <stddef.h>
#include <stdint.h>

/* Of libsodium's headers, version 1.0.18: Debian 12 and 13. */
enum { EAGERX_NUMBER = 32, EAGERX_HEAD = 24, EAGERX_SEAL = 17, EAGERX_STATE = 52 };
enum {
  EAGERX_TITLE = 16,
  EAGERX_HELLO = EAGERX_TITLE + EAGERX_NUMBER,
  EAGERX_SAID = EAGERX_HELLO + EAGERX_NUMBER
};
enum { EAGERX_PROOF = EAGERX_HEAD + EAGERX_SEAL, EAGERX_ANSWER = EAGERX_NUMBER + EAGERX_PROOF };
enum { EAGERX_RECORD = 4096, EAGERX_SEALED = 2 + EAGERX_RECORD + EAGERX_SEAL };

struct eagerx_key {
  uint8_t bytes[EAGERX_NUMBER];
};

/* Reads a file that `eagerx-gen key new` wrote and that is this user's alone, and looks for
   libsodium. 0: `problem`, of `room` bytes, says what is wrong. */
int eagerx_key_use(const char* path, struct eagerx_key* key, char* problem, size_t room);

/* Records of at most EAGERX_RECORD bytes each way, each sealed on its own. */
struct eagerx_records {
  uint8_t out[EAGERX_STATE], in[EAGERX_STATE];
  uint8_t taken[EAGERX_SEALED]; /* what has come */
  size_t taken_size;
  int is_over;
};
enum eagerx_found { EAGERX_NOTHING, EAGERX_OPENED, EAGERX_END, EAGERX_FORGED };
/* One record of `size` bytes; that of none is the last one. Returns how many bytes it is of
   `sealed`, which has room for EAGERX_SEALED. */
size_t eagerx_seal(struct eagerx_records* records, const uint8_t* bytes, size_t size,
                   uint8_t* sealed);
/* Opens the next record of what is taken into `bytes`, which has room for EAGERX_RECORD.
   EAGERX_FORGED: it is not what the other end sent next; nothing after it is read. */
enum eagerx_found eagerx_open(struct eagerx_records* records, uint8_t* bytes, size_t* size);

/* The first bytes each way. The peer has shown that it has the key, and is there now, when
 * `is_done`. */
struct eagerx_greeting {
  struct eagerx_key key;
  uint8_t own[EAGERX_NUMBER], secret[EAGERX_NUMBER], in_key[EAGERX_NUMBER];
  uint8_t in[EAGERX_STATE], out[EAGERX_STATE];
  uint8_t said[EAGERX_SAID]; /* of who connects and who listens: all that was said in the open */
  uint8_t taken[EAGERX_HELLO];
  size_t taken_size;
  int has_said, is_done;
};
void eagerx_greeting_begin(struct eagerx_greeting* greeting, const struct eagerx_key* key);
/* How many bytes are missing until something happens; 0: nothing more is read. */
size_t eagerx_greeting_wanted(const struct eagerx_greeting* greeting);
/* Takes at most as many. Returns how many bytes of `answer`, which has room for EAGERX_ANSWER, are
   to be sent now; -1: the sender does not have the key. */
int eagerx_greeting_take(struct eagerx_greeting* greeting, const uint8_t* bytes, size_t size,
                         uint8_t* answer);
/* The records that follow. Nothing secret stays in the greeting. */
void eagerx_greeting_go_on(struct eagerx_greeting* greeting, struct eagerx_records* records);

#endif
