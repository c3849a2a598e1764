/* Frames, checksums and sessions of the connection to the hub. A program has one link. */
#ifndef EAGERX_LINK_H
#define EAGERX_LINK_H

#include <setjmp.h>
#include <stddef.h>
#include <stdint.h>

#include "eagerx_part.h"

/* Values that setjmp(eagerx_link_end) returns. */
enum eagerx_ending { EAGERX_GOES_ON, EAGERX_SESSION_OVER, EAGERX_CLOSED, EAGERX_WRONG };
extern jmp_buf eagerx_link_end;
void eagerx_link_stop(enum eagerx_ending how, const char* why);
const char* eagerx_link_why(void);

/* Call this after the connection is open. Returns 0 if there is no memory. */
int eagerx_link_begin(const struct eagerx_part* part);
void eagerx_link_free(void);
/* Waits until a session begins, unless one has just begun. */
void eagerx_link_wait(void);
/* Reads bytes of the hub's messages. */
void eagerx_link_get(uint8_t* bytes, size_t size);
/* Adds bytes for the hub. They are sent when the next request is needed, or a frame is full. */
void eagerx_link_put(const uint8_t* bytes, size_t size);
/* Number of dropped frames. */
uint32_t eagerx_link_damaged(void);

#endif
