/* The line of bytes to the hub: a socket, also with a key, or a serial line. A program has one. */
#ifndef EAGERX_LINE_H
#define EAGERX_LINE_H

#include <stddef.h>
#include <stdint.h>

#include "eagerx_key.h"

struct eagerx_options {
  const char *listen, *link, *key; /* null: not given */
  long baud;
};
/* Opens what the options say, and waits for the hub. 0: it is open; else the exit code, and what is
 * wrong has been said. */
int eagerx_line_open(const struct eagerx_options* options);
/* At least one of at most `size` bytes; waits for them. 0: the line is over. */
size_t eagerx_line_read(uint8_t* bytes, size_t size);
/* Bytes that the peer does not take within a second are dropped: the hub asks again. 0: the line is
 * over. */
int eagerx_line_write(const uint8_t* bytes, size_t size);
/* Whether only the peer can be at the other end: a serial line, or a socket with a key. */
int eagerx_line_knows_peer(void);
/* Whether it is over because what came with a key is not what the hub sent. */
int eagerx_line_is_forged(void);
/* Announces a regular end, as opposed to a cut line. */
void eagerx_line_close(void);

/* Of eagerx_listen.c: the socket of the one peer that comes; -1: `problem` says why there is none.
   With a key that peer has it, and the records are those that follow its greeting. */
enum { EAGERX_PROBLEM = 1024, EAGERX_GREETING_MS = 5000 };
int eagerx_listen(const char* address, const struct eagerx_key* key, struct eagerx_records* records,
                  char* problem);
/* Whether it has the form of HOST:PORT. */
int eagerx_is_tcp(const char* address);
/* Milliseconds of CLOCK_MONOTONIC. */
int64_t eagerx_now_ms(void);

#endif
