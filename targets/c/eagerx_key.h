/* Connection with a key, on the listening side: the key file, the greeting, and records, as
 * specified in the section "With a key" of targets/PROTOCOL.md. libsodium, which is loaded when a
 * key is used, provides all cryptography. These functions handle bytes and open no sockets. */
#ifndef EAGERX_KEY_H
#define EAGERX_KEY_H

#include <stddef.h>
#include <stdint.h>

/* From the headers of libsodium 1.0.18, the version in Debian 12 and 13. */
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

/* Reads a key file that `eagerx-gen key new` wrote and that only this user can access, and loads
 * libsodium. Returns 0 on failure, with the reason in `problem`, which has `room` bytes. */
int eagerx_key_use(const char* path, struct eagerx_key* key, char* problem, size_t room);

/* Records of at most EAGERX_RECORD bytes in each direction, each encrypted and authenticated. */
struct eagerx_records {
  uint8_t out[EAGERX_STATE], in[EAGERX_STATE];
  uint8_t taken[EAGERX_SEALED]; /* received bytes */
  size_t taken_size;
  int is_over;
};
enum eagerx_found { EAGERX_NOTHING, EAGERX_OPENED, EAGERX_END, EAGERX_FORGED };
/* Encrypts one record of `size` bytes; an empty record is the last one. Returns the number of bytes
 * in `sealed`, which has room for EAGERX_SEALED. */
size_t eagerx_seal(struct eagerx_records* records, const uint8_t* bytes, size_t size,
                   uint8_t* sealed);
/* Decrypts the next received record into `bytes`, which has room for EAGERX_RECORD. EAGERX_FORGED:
 * the peer did not send it; nothing after it is read. */
enum eagerx_found eagerx_open(struct eagerx_records* records, uint8_t* bytes, size_t* size);

/* First bytes in each direction. `is_done`: the peer has proved that it has the key and is live. */
struct eagerx_greeting {
  struct eagerx_key key;
  uint8_t own[EAGERX_NUMBER], secret[EAGERX_NUMBER], in_key[EAGERX_NUMBER];
  uint8_t in[EAGERX_STATE], out[EAGERX_STATE];
  uint8_t said[EAGERX_SAID]; /* title and both public keys: all that is sent in plain text */
  uint8_t taken[EAGERX_HELLO];
  size_t taken_size;
  int has_said, is_done;
};
void eagerx_greeting_begin(struct eagerx_greeting* greeting, const struct eagerx_key* key);
/* Number of bytes needed before the next action; 0 if the greeting reads no more. */
size_t eagerx_greeting_wanted(const struct eagerx_greeting* greeting);
/* Takes at most that many bytes. Returns the number of bytes to send in `answer`, which has room
 * for EAGERX_ANSWER, or -1 if the peer does not have the key. */
int eagerx_greeting_take(struct eagerx_greeting* greeting, const uint8_t* bytes, size_t size,
                         uint8_t* answer);
/* Begins the records that follow. Erases all secrets in the greeting. */
void eagerx_greeting_go_on(struct eagerx_greeting* greeting, struct eagerx_records* records);

#endif
