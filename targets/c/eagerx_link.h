/* Frames, checksums and sessions on the line to the hub. A program has one link. */
#ifndef EAGERX_LINK_H
#define EAGERX_LINK_H

#include <setjmp.h>
#include <stddef.h>
#include <stdint.h>

#include "eagerx_part.h"

/* What comes back to setjmp(eagerx_link_end). */
enum eagerx_ending { EAGERX_GOES_ON, EAGERX_SESSION_OVER, EAGERX_CLOSED, EAGERX_WRONG };
extern jmp_buf eagerx_link_end;
void eagerx_link_stop(enum eagerx_ending how, const char* why);
const char* eagerx_link_why(void);

/* Of a line that is open. 0: there is no memory. */
int eagerx_link_begin(const struct eagerx_part* part);
void eagerx_link_free(void);
/* Waits until a session begins, if none has just begun. */
void eagerx_link_wait(void);
/* Bytes of the hub's messages. */
void eagerx_link_get(uint8_t* bytes, size_t size);
/* Bytes for the hub. They go when the hub's next ones are needed, or a frame is full. */
void eagerx_link_put(const uint8_t* bytes, size_t size);
/* Frames that were dropped. */
uint32_t eagerx_link_damaged(void);

#endif
