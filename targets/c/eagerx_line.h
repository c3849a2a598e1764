/* Byte stream to the hub: a socket, with or without a key, or a serial line. A program has one. */
#ifndef EAGERX_LINE_H
#define EAGERX_LINE_H

#include <stddef.h>
#include <stdint.h>

#include "eagerx_key.h"

struct eagerx_options {
  const char *listen, *link, *key; /* null: not given */
  long baud;
};
/* Opens the connection that the options specify, and waits for the hub. Returns 0 on success;
 * otherwise prints the problem and returns the exit code. */
int eagerx_line_open(const struct eagerx_options* options);
/* Waits for 1 to `size` bytes and returns their number, or 0 at the end of the connection. */
size_t eagerx_line_read(uint8_t* bytes, size_t size);
/* Drops bytes that the peer does not accept within a second: the hub sends its request again.
 * Returns 0 at the end of the connection. */
int eagerx_line_write(const uint8_t* bytes, size_t size);
/* True if only the peer can be at the other end: a serial line, or a socket with a key. */
int eagerx_line_knows_peer(void);
/* True if the connection has ended because the hub did not send the data received with a key. */
int eagerx_line_is_forged(void);
/* Announces a regular end, as opposed to an interrupted connection. */
void eagerx_line_close(void);

/* In eagerx_listen.c: socket of the only peer, or -1, with the reason in `problem`. With a key, the
 * peer has proved that it has the key, and `records` follow its greeting. */
enum { EAGERX_PROBLEM = 1024, EAGERX_GREETING_MS = 5000 };
int eagerx_listen(const char* address, const struct eagerx_key* key, struct eagerx_records* records,
                  char* problem);
/* True if an address has the form HOST:PORT. */
int eagerx_is_tcp(const char* address);
/* Milliseconds of CLOCK_MONOTONIC. */
int64_t eagerx_now_ms(void);

#endif
