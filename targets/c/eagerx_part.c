/* The timetable of a part, and its line to the hub: targets/PROTOCOL.md. */
#define _GNU_SOURCE
#include "eagerx_part.h"

#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

enum { kHello = 1, kWelcome = 2, kRequest = 3, kAnswer = 4 };
enum { kStep = 1, kReset = 2, kFinish = 3, kSafeStep = 4 };
enum { kProtocol = 1, kGreeting = 16, kHeader = 5, kCrc = 4, kGreetingMs = 5000, kMostBeforeGreeting = 65536 };
enum { kEpisode = 17, kReport = 9, kRun = 254 };
enum ending { kGoesOn, kSessionOver, kClosed, kWrong };

/* One part a program: all of its state. */
static struct {
  const struct eagerx_part* part;
  int file;
  uint8_t in[4096]; /* bytes of the line */
  size_t in_begin, in_end;
  uint8_t *encoded, *body, *answer, *last; /* a frame as it comes; decoded; the payload being made; the last sent */
  size_t encoded_size, most_encoded, body_size, read, answer_size, last_size;
  int too_long, greeted, has_session;
  uint32_t session, number, crc_start, damaged;
  size_t before_greeting;
  uint64_t time, ticks[64];
  const char* why;
  jmp_buf end;
} g;

static void end(enum ending how, const char* why) {
  g.why = why;
  longjmp(g.end, (int)how);
}

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

/* 0 if it is no encoded frame. */
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

static void write_all(const uint8_t* bytes, size_t size) {
  while (size > 0) {
    const ssize_t count = send(g.file, bytes, size, MSG_NOSIGNAL);
    if (count > 0) {
      bytes += count;
      size -= (size_t)count;
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      return; /* nobody reads for a second: the hub asks again */
    } else if (errno != EINTR) {
      end(kClosed, "the line is closed");
    }
  }
}

static void send_frame(int kind, uint32_t number, const uint8_t* payload, size_t size, uint32_t start) {
  uint8_t* const body = g.last + g.most_encoded + 2; /* behind the frame that it becomes */
  body[0] = (uint8_t)kind;
  put_number(body + 1, number, 4);
  memcpy(body + kHeader, payload, size);
  put_number(body + kHeader + size, crc32c(body, kHeader + size, start), kCrc);
  g.last[0] = 0;
  g.last_size = 1 + cobs_encode(body, kHeader + size + kCrc, g.last + 1);
  g.last[g.last_size++] = 0;
  write_all(g.last, g.last_size);
}

static uint8_t next_byte(void) {
  while (g.in_begin == g.in_end) {
    const ssize_t count = recv(g.file, g.in, sizeof g.in, 0);
    if (count > 0) {
      g.in_begin = 0;
      g.in_end = (size_t)count;
      g.before_greeting += g.has_session ? 0 : (size_t)count;
      if (g.before_greeting > kMostBeforeGreeting) end(kWrong, "what came is no greeting of a hub");
    } else if (count == 0 || (errno != EINTR && errno != EAGAIN && errno != EWOULDBLOCK)) {
      end(kClosed, "the line is closed");
    }
  }
  return g.in[g.in_begin++];
}

/* Fills g.body with something that may be a frame. */
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
  g.read = g.body_size = kHeader + kCrc; /* nothing is left of a request */
  g.has_session = hello[0] == own[0] && memcmp(hello + 2, own + 2, kGreeting - 2) == 0;
  g.before_greeting = 0;
  if (!g.has_session) {
    fprintf(stderr, "note: a hub of another graph or version was refused\n");
    return;
  }
  g.session = session;
  g.crc_start = crc32c(own, kGreeting, 0);
  g.greeted = 1;
  end(kSessionOver, "");
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
    } else if (number == g.number && number > 0) {
      write_all(g.last, g.last_size);
    }
  }
}

static size_t left(void) { return g.body_size - kCrc > g.read ? g.body_size - kCrc - g.read : 0; }

static void next_request(void) {
  if (left() > 0) end(kWrong, "the hub sent what is not due");
  if (g.number > 0) send_frame(kAnswer, g.number, g.answer, g.answer_size, g.crc_start);
  g.answer_size = 0;
  wait_for_request();
}

static void get_bytes(uint8_t* bytes, size_t size) {
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

static void put_bytes(const uint8_t* bytes, size_t size) {
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

static int64_t floor_div(int64_t x, int64_t y) { return x >= 0 ? x / y : -((-x + y - 1) / y); }

uint32_t eagerx_take(struct eagerx_input* input, uint64_t n) {
  const int64_t tick = (int64_t)n;
  const uint64_t before = input->received;
  const int64_t sent = floor_div(input->a * tick - input->x, input->b) + 1;
  if (!input->skip) {
    input->received = sent < 1 ? 1 : (uint64_t)sent;
  } else if (n > 0) {
    const int64_t ahead = tick + input->off;
    const int64_t more = floor_div(input->a * ahead - input->x, input->b) -
                         floor_div(input->a * (ahead - 1) - input->x, input->b);
    const int64_t arriving = more < sent ? more : sent;
    input->received += arriving > 0 ? (uint64_t)arriving : 0;
  }
  uint64_t size = input->received - before;
  if (input->size > 0) size = input->received < input->size ? input->received : input->size;
  const struct eagerx_message* const message = input->message;
  for (uint64_t i = 0; i < size; ++i) {
    const uint64_t seq = input->received - size + i;
    memcpy((uint8_t*)input->window + i * message->bytes, message->ring + seq % message->keep * message->bytes,
           message->bytes);
  }
  return (uint32_t)size;
}

void eagerx_put(const struct eagerx_message* message, uint64_t n, const void* bytes) {
  uint8_t* const place = message->ring + n % message->keep * message->bytes;
  memcpy(place, bytes, message->bytes);
  put_bytes(place, message->bytes);
}

static void receive(const struct eagerx_message* message, uint64_t n) {
  uint8_t* const place = message->ring + n % message->keep * message->bytes;
  get_bytes(place, message->bytes);
  for (uint32_t i = 0; message->is_bool && i < message->bytes; ++i) place[i] = place[i] != 0;
}

static int is_due(uint32_t rate) { return g.time % g.part->periods[rate] == 0; }

static void take_turns(const struct eagerx_turn* turns, uint32_t count) {
  for (uint32_t i = 0; i < count; ++i) {
    if (!is_due(turns[i].rate)) continue;
    const uint64_t n = g.ticks[turns[i].rate] - 1;
    if (turns[i].run != 0) turns[i].run(n);
    for (uint32_t k = 0; turns[i].run == 0 && k < turns[i].count; ++k)
      receive(&g.part->messages[turns[i].messages[k]], n);
  }
}

static void begin_slot(void) {
  for (uint32_t rate = 0; rate < g.part->rates; ++rate) g.ticks[rate] += is_due(rate) ? 1 : 0;
  take_turns(g.part->before, g.part->before_count);
}

static void reset(void) {
  uint8_t episode[kEpisode]; /* states that are drawn are of parts in C++ */
  get_bytes(episode, sizeof episode);
  g.time = 0;
  memset(g.ticks, 0, sizeof g.ticks);
  g.part->reset();
  begin_slot();
}

static void step(void) {
  uint8_t late;
  get_bytes(&late, 1);
  for (uint32_t i = 0; i < g.part->action_count; ++i)
    receive(&g.part->messages[g.part->actions[i]], g.ticks[g.part->step_rate] - 1);
  do {
    take_turns(g.part->after, g.part->after_count);
    uint64_t next = UINT64_MAX;
    for (uint32_t rate = 0; rate < g.part->rates; ++rate) {
      const uint64_t tick = (g.time / g.part->periods[rate] + 1) * g.part->periods[rate];
      next = tick < next ? tick : next;
    }
    g.time = next;
    begin_slot();
  } while (!is_due(g.part->step_rate));
}

static void run_session(void) {
  int has_begun = 0;
  for (;;) {
    uint8_t command;
    get_bytes(&command, 1);
    if (command == kReset) {
      reset();
      has_begun = 1;
    } else if (has_begun && (command == kStep || (command == kSafeStep && g.part->safe_steps))) {
      step();
    } else if (command == kFinish) {
      uint8_t report[kReport] = {0};
      put_number(report + 4, g.damaged, 4);
      put_bytes(report, sizeof report);
    } else {
      end(kWrong, "no hub of this graph sends this command");
    }
  }
}

static int listen_unix(const char* path) {
  struct sockaddr_un address = {.sun_family = AF_UNIX};
  struct stat there;
  if (strlen(path) + 1 >= sizeof address.sun_path) return errno = ENAMETOOLONG, -1;
  strcpy(address.sun_path, path);
  if (lstat(path, &there) == 0) { /* one of an earlier run goes; what somebody listens on, or is no socket, stays */
    const int probe = socket(AF_UNIX, SOCK_DGRAM, 0);
    const int dead = S_ISSOCK(there.st_mode) && connect(probe, (struct sockaddr*)&address, sizeof address) != 0 &&
                     errno == ECONNREFUSED;
    close(probe);
    if (!dead) return errno = EADDRINUSE, -1;
    unlink(path);
  }
  strcat(address.sun_path, "~");
  if (lstat(address.sun_path, &there) == 0 && S_ISSOCK(there.st_mode)) unlink(address.sun_path);
  const int file = socket(AF_UNIX, SOCK_STREAM, 0);
  if (fchmod(file, 0600) != 0 || bind(file, (struct sockaddr*)&address, sizeof address) != 0 || listen(file, 1) != 0 ||
      rename(address.sun_path, path) != 0) /* whoever sees the socket can connect */
    return -1;
  fprintf(stderr, "listens on unix:%s\n", path);
  return file;
}

static int listen_here(const char* port) {
  char* rest;
  const unsigned long number = strtoul(port, &rest, 10);
  if (*port == '\0' || *rest != '\0' || number > 65535) return errno = EINVAL, -1;
  struct sockaddr_in address = {.sin_family = AF_INET, .sin_port = htons((uint16_t)number)};
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int file = socket(AF_INET, SOCK_STREAM, 0), yes = 1;
  setsockopt(file, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  if (bind(file, (struct sockaddr*)&address, sizeof address) != 0 || listen(file, 1) != 0) return -1;
  socklen_t size = sizeof address;
  getsockname(file, (struct sockaddr*)&address, &size);
  fprintf(stderr, "listens on 127.0.0.1:%d, for this machine only\n", ntohs(address.sin_port));
  return file;
}

/* The peer that says something first; others are refused from then on. */
static void accept_one(int listener) {
  for (;;) {
    g.file = accept(listener, 0, 0);
    if (g.file < 0) continue;
    struct pollfd item = {g.file, POLLIN, 0};
    uint8_t first;
    if (poll(&item, 1, kGreetingMs) > 0 && recv(g.file, &first, 1, MSG_PEEK) > 0) break;
    fprintf(stderr, "note: a peer said nothing and was dropped\n");
    close(g.file);
  }
  close(listener);
  const struct timeval second = {1, 0};
  const int yes = 1;
  setsockopt(g.file, SOL_SOCKET, SO_SNDTIMEO, &second, sizeof second);
  setsockopt(g.file, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes); /* of no effect on others */
}

int eagerx_serve(int argc, char** argv, const struct eagerx_part* part) {
  const char* const address = argc == 3 && strcmp(argv[1], "--listen") == 0 ? argv[2] : "";
  const int is_unix = strncmp(address, "unix:", 5) == 0;
  if (!is_unix && address[0] != ':') {
    fprintf(stderr, "error: wrong usage\nhelp: %s --listen unix:PATH, or :PORT for this machine only; serves part `%s` of `%s`\n",
            argv[0], part->name, part->of_graph);
    return 2;
  }
  const size_t most = part->most_to_part > part->most_to_hub ? part->most_to_part : part->most_to_hub;
  g.part = part;
  g.most_encoded = most + kHeader + kCrc + (most + kHeader + kCrc) / kRun + 1;
  g.encoded = malloc(g.most_encoded);
  g.body = malloc(g.most_encoded);
  g.answer = malloc(most);
  g.last = malloc(2 * g.most_encoded + 2);
  if (!g.encoded || !g.body || !g.answer || !g.last || part->rates > 64) return 1;
  g.body_size = g.read = kHeader + kCrc;
  const int listener = is_unix ? listen_unix(address + 5) : listen_here(address + 1);
  if (listener < 0) {
    fprintf(stderr, "error: cannot open `%s`: %s\n", address, strerror(errno));
    return 3;
  }
  signal(SIGPIPE, SIG_IGN);
  accept_one(listener);
  const enum ending how = (enum ending)setjmp(g.end);
  if (how == kClosed) return 0;
  if (how == kWrong) {
    fprintf(stderr, "error: %s\n", g.why);
    return 1;
  }
  if (!g.greeted) wait_for_request(); /* until a session begins, which comes back here */
  g.greeted = 0;
  run_session();
  return 0;
}
