/* Frames, checksums and sessions: targets/PROTOCOL.md. */
#include "eagerx_link.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "eagerx_line.h"

enum { kHello = 1, kWelcome = 2, kRequest = 3, kAnswer = 4 };
enum { kProtocol = 1, kGreeting = 16, kHeader = 5, kCrc = 4, kMostBeforeGreeting = 65536, kRun = 254 };

jmp_buf eagerx_link_end;

static struct {
  const struct eagerx_part* part;
  uint8_t in[4096]; /* received bytes */
  size_t in_begin, in_end;
  uint8_t *encoded, *body, *answer; /* received frame; decoded frame; payload of the next answer */
  uint8_t *out, *kept;              /* frame to encode; last frames sent, by number */
  size_t* kept_size;
  size_t encoded_size, most_encoded, body_size, read, answer_size;
  int too_long, greeted, has_session;
  uint32_t session, number, crc_start, damaged;
  size_t before_greeting;
  const char* why;
} g;

void eagerx_link_stop(enum eagerx_ending how, const char* why) {
  g.why = why;
  longjmp(eagerx_link_end, (int)how);
}

const char* eagerx_link_why(void) { return g.why; }

uint32_t eagerx_link_damaged(void) { return g.damaged; }

static uint32_t crc32c(const uint8_t* bytes, size_t size, uint32_t start) {
  uint32_t crc = ~start;
  for (size_t i = 0; i < size; ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (0x82f63b78u & (0u - (crc & 1u)));
  }
  return ~crc;
}

static void put_number(uint8_t* bytes, uint64_t value, int size) {
  for (int i = 0; i < size; ++i) bytes[i] = (uint8_t)(value >> 8 * i);
}
static uint64_t get_number(const uint8_t* bytes, int size) {
  uint64_t value = 0;
  for (int i = 0; i < size; ++i) value |= (uint64_t)bytes[i] << 8 * i;
  return value;
}

static size_t cobs_encode(const uint8_t* bytes, size_t size, uint8_t* out) {
  size_t used = 0, begin = 0;
  for (;;) {
    size_t to = begin;
    while (to < size && to - begin < kRun && bytes[to] != 0) ++to;
    out[used++] = (uint8_t)(to - begin + 1);
    memcpy(out + used, bytes + begin, to - begin);
    used += to - begin;
    if (to == size) return used;
    begin = to - begin == kRun ? to : to + 1;
  }
}

/* Returns 0 if the bytes are not an encoded frame. */
static size_t cobs_decode(const uint8_t* bytes, size_t size, uint8_t* out) {
  size_t used = 0, at = 0;
  while (at < size) {
    const size_t run = bytes[at++];
    if (run == 0 || run - 1 > size - at) return 0;
    memcpy(out + used, bytes + at, run - 1);
    used += run - 1;
    at += run - 1;
    if (run <= kRun && at < size) out[used++] = 0;
  }
  return used;
}

static void send_kept(uint32_t number) {
  const uint32_t place = number % g.part->depth;
  if (!eagerx_line_write(g.kept + place * (g.most_encoded + 2), g.kept_size[place]))
    eagerx_link_stop(EAGERX_CLOSED, "the line is closed");
}

static void send_frame(int kind, uint32_t number, const uint8_t* payload, size_t size, uint32_t start) {
  uint8_t* const body = g.out;
  uint8_t* const frame = g.kept + number % g.part->depth * (g.most_encoded + 2);
  body[0] = (uint8_t)kind;
  put_number(body + 1, number, 4);
  memcpy(body + kHeader, payload, size);
  put_number(body + kHeader + size, crc32c(body, kHeader + size, start), kCrc);
  frame[0] = 0;
  size_t used = 1 + cobs_encode(body, kHeader + size + kCrc, frame + 1);
  frame[used++] = 0;
  g.kept_size[number % g.part->depth] = used;
  send_kept(number);
}

static uint8_t next_byte(void) {
  if (g.in_begin == g.in_end) {
    g.in_begin = 0;
    g.in_end = eagerx_line_read(g.in, sizeof g.in);
    if (g.in_end == 0) eagerx_link_stop(EAGERX_CLOSED, "the line is closed");
    if (!g.has_session && !eagerx_line_knows_peer()) g.before_greeting += g.in_end;
    if (g.before_greeting > kMostBeforeGreeting) eagerx_link_stop(EAGERX_WRONG, "the first bytes are not a greeting of a hub");
  }
  return g.in[g.in_begin++];
}

/* Reads into g.body the next bytes that may be a frame. */
static void next_frame(void) {
  for (;;) {
    const uint8_t byte = next_byte();
    if (byte != 0) {
      if (g.encoded_size < g.most_encoded)
        g.encoded[g.encoded_size++] = byte;
      else
        g.too_long = 1;
      continue;
    }
    const size_t size = g.encoded_size;
    const int too_long = g.too_long;
    g.encoded_size = 0;
    g.too_long = 0;
    if (size == 0 && !too_long) continue;
    g.body_size = too_long ? 0 : cobs_decode(g.encoded, size, g.body);
    if (g.body_size >= kHeader + kCrc) return;
    ++g.damaged;
  }
}

static int is_intact(uint32_t start) {
  const size_t size = g.body_size - kCrc;
  return get_number(g.body + size, kCrc) == crc32c(g.body, size, start);
}

static void write_greeting(uint8_t* bytes, uint32_t session) {
  bytes[0] = kProtocol;
  bytes[1] = 0;
  put_number(bytes + 2, g.part->runtime, 2);
  put_number(bytes + 4, g.part->hash, 8);
  put_number(bytes + 12, session, 4);
}

static void greet(void) {
  uint8_t own[kGreeting];
  const uint8_t* const hello = g.body + kHeader;
  if (!is_intact(0) || g.body_size != kHeader + kGreeting + kCrc) {
    ++g.damaged;
    return;
  }
  const uint32_t session = (uint32_t)get_number(hello + 12, 4);
  const int same = g.has_session && session == g.session;
  if (same && g.number > 0) return; /* a late duplicate */
  write_greeting(own, session);
  send_frame(kWelcome, 0, own, kGreeting, 0);
  if (same) return;
  g.number = 0;
  g.answer_size = 0;
  g.read = g.body_size = kHeader + kCrc; /* discards the rest of a request */
  g.has_session = hello[0] == own[0] && memcmp(hello + 2, own + 2, kGreeting - 2) == 0;
  g.before_greeting = 0;
  if (!g.has_session) {
    fprintf(stderr, "note: a hub of another graph or version was refused\n");
    return;
  }
  g.session = session;
  g.crc_start = crc32c(own, kGreeting, 0);
  g.greeted = 1;
  eagerx_link_stop(EAGERX_SESSION_OVER, "");
}

static void wait_for_request(void) {
  for (;;) {
    next_frame();
    const uint32_t number = (uint32_t)get_number(g.body + 1, 4);
    if (g.body[0] == kHello) {
      greet();
    } else if (g.body[0] != kRequest || !g.has_session || !is_intact(g.crc_start)) {
      ++g.damaged;
    } else if (number == (g.number == UINT32_MAX ? 1 : g.number + 1)) {
      g.number = number;
      g.read = kHeader;
      return;
    } else if (number > 0 && number <= g.number && g.number - number < g.part->depth) {
      send_kept(number);
    }
  }
}

static size_t left(void) { return g.body_size - kCrc > g.read ? g.body_size - kCrc - g.read : 0; }

static void next_request(void) {
  if (left() > 0) eagerx_link_stop(EAGERX_WRONG, "the hub sent what is not due");
  if (g.number > 0) send_frame(kAnswer, g.number, g.answer, g.answer_size, g.crc_start);
  g.answer_size = 0;
  wait_for_request();
}

void eagerx_link_get(uint8_t* bytes, size_t size) {
  while (size > 0) {
    const size_t count = left() < size ? left() : size;
    if (count == 0) {
      next_request();
      continue;
    }
    memcpy(bytes, g.body + g.read, count);
    g.read += count;
    bytes += count;
    size -= count;
  }
}

void eagerx_link_put(const uint8_t* bytes, size_t size) {
  while (size > 0) {
    const size_t room = g.part->most_to_hub - g.answer_size;
    const size_t count = room < size ? room : size;
    memcpy(g.answer + g.answer_size, bytes, count);
    g.answer_size += count;
    bytes += count;
    size -= count;
    if (size > 0) next_request();
  }
}

void eagerx_link_wait(void) {
  if (!g.greeted) wait_for_request(); /* a new session returns to setjmp() */
  g.greeted = 0;
}

int eagerx_link_begin(const struct eagerx_part* part) {
  size_t most = part->most_to_part > part->most_to_hub ? part->most_to_part : part->most_to_hub;
  if (most < kGreeting) most = kGreeting;
  memset(&g, 0, sizeof g);
  g.part = part;
  g.most_encoded = most + kHeader + kCrc + (most + kHeader + kCrc) / kRun + 1;
  g.encoded = malloc(g.most_encoded);
  g.body = malloc(g.most_encoded);
  g.answer = malloc(most);
  g.out = malloc(g.most_encoded);
  g.kept = malloc(part->depth * (g.most_encoded + 2));
  g.kept_size = calloc(part->depth, sizeof *g.kept_size);
  g.body_size = g.read = kHeader + kCrc;
  return g.encoded && g.body && g.answer && g.out && g.kept && g.kept_size;
}

void eagerx_link_free(void) {
  free(g.encoded);
  free(g.body);
  free(g.answer);
  free(g.out);
  free(g.kept);
  free(g.kept_size);
  memset(&g, 0, sizeof g);
}
