/* Byte stream to the hub: targets/PROTOCOL.md. */
#define _GNU_SOURCE
#include "eagerx_line.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

enum { kExitBadFile = 3, kWriteMs = 1000 };

static struct {
  int file, is_socket, is_sealed, is_forged;
  struct eagerx_records records;
  uint8_t opened[EAGERX_RECORD]; /* bytes of the decrypted record */
  size_t begin, end;
  uint8_t sealed[EAGERX_SEALED]; /* the record being sent: records have an order, so its rest goes
                                    first */
  size_t sealed_begin, sealed_end;
} g = {.file = -1};

static speed_t speed_of(long baud) {
  static const long bauds[] = {9600,   19200,  38400,   57600,   115200,  230400,
                               460800, 921600, 1000000, 2000000, 3000000, 4000000};
  static const speed_t speeds[] = {B9600,   B19200,  B38400,   B57600,   B115200,  B230400,
                                   B460800, B921600, B1000000, B2000000, B3000000, B4000000};
  for (size_t i = 0; i < sizeof bauds / sizeof *bauds; ++i)
    if (bauds[i] == baud) return speeds[i];
  return B0;
}

/* Opens the serial line with exclusive access. Returns null on success, otherwise the reason. */
static const char* open_serial(const char* path, long baud) {
  struct termios settings;
  const speed_t speed = speed_of(baud);
  if (speed == B0) return "Linux has no such baud rate";
  g.file = open(path, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (g.file < 0) return strerror(errno);
  if (tcgetattr(g.file, &settings) != 0) return "it is not a serial line";
  if (flock(g.file, LOCK_EX | LOCK_NB) != 0)
    return "another program uses it"; /* also excludes root, to which TIOCEXCL does not apply */
  ioctl(g.file, TIOCEXCL);
  cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  settings.c_cflag &= ~(tcflag_t)(CSTOPB | CRTSCTS);
  cfsetspeed(&settings, speed);
  if (tcsetattr(g.file, TCSANOW, &settings) != 0) return strerror(errno);
  tcflush(g.file, TCIOFLUSH);
  return 0;
}

int eagerx_line_open(const struct eagerx_options* options) {
  static char problem[EAGERX_PROBLEM];
  const char* const address = options->listen != 0 ? options->listen : options->link;
  struct eagerx_key key;
  const char* why = 0;
  signal(SIGPIPE, SIG_IGN);
  if (options->key != 0 && (options->listen == 0 || !eagerx_is_tcp(options->listen))) {
    fprintf(stderr,
            "error: `--key %s` does nothing: it is for TCP, and serial lines and unix sockets need "
            "none\n"
            "help: leave it out\n",
            options->key);
    return kExitBadFile;
  }
  if (options->key != 0 && !eagerx_key_use(options->key, &key, problem, sizeof problem)) {
    fprintf(stderr, "error: %s\n", problem);
    return kExitBadFile;
  }
  if (options->listen == 0) {
    why = open_serial(options->link, options->baud);
  } else {
    g.file = eagerx_listen(options->listen, options->key != 0 ? &key : 0, &g.records, problem);
    why = g.file < 0 ? problem : 0;
    g.is_socket = 1;
    g.is_sealed = options->key != 0;
  }
  explicit_bzero(&key, sizeof key);
  if (why == 0) return fcntl(g.file, F_SETFL, O_NONBLOCK), 0;
  fprintf(stderr, "error: cannot open `%s`: %s\n", address, why);
  return kExitBadFile;
}

/* Waits for bytes of the file and returns their number, or -1 at the end of the connection. */
static ssize_t read_file(uint8_t* bytes, size_t size) {
  for (;;) {
    struct pollfd item = {g.file, POLLIN, 0};
    const ssize_t count = read(g.file, bytes, size);
    if (count > 0) return count;
    if (count == 0 || (errno != EINTR && errno != EAGAIN)) return -1;
    poll(&item, 1, -1);
  }
}

/* Returns the number of bytes written before the deadline, or -1 at the end of the connection. */
static ssize_t write_file(const uint8_t* bytes, size_t size, int64_t until_ms) {
  size_t sent = 0;
  while (sent < size) {
    const ssize_t count = write(g.file, bytes + sent, size - sent);
    if (count > 0) {
      sent += (size_t)count;
      continue;
    }
    if (errno != EINTR && errno != EAGAIN) return -1;
    const int64_t left = until_ms - eagerx_now_ms();
    if (left <= 0) break;
    struct pollfd item = {g.file, POLLOUT, 0};
    poll(&item, 1, (int)left);
  }
  return (ssize_t)sent;
}

size_t eagerx_line_read(uint8_t* bytes, size_t size) {
  while (g.is_sealed && g.begin == g.end) {
    g.begin = 0;
    const enum eagerx_found found = eagerx_open(&g.records, g.opened, &g.end);
    g.is_forged = found == EAGERX_FORGED;
    if (found == EAGERX_OPENED) break;
    if (found != EAGERX_NOTHING) return 0;
    const size_t there = g.records.taken_size;
    const ssize_t count = read_file(g.records.taken + there, sizeof g.records.taken - there);
    if (count < 0) return 0;
    g.records.taken_size += (size_t)count;
  }
  if (!g.is_sealed) {
    const ssize_t count = read_file(bytes, size);
    return count < 0 ? 0 : (size_t)count;
  }
  const size_t count = g.end - g.begin < size ? g.end - g.begin : size;
  memcpy(bytes, g.opened + g.begin, count);
  g.begin += count;
  return count;
}

/* Sends the rest of a record. Returns 1 if all of it is sent, 0 if not, or -1 at the end of the
 * connection. */
static int send_sealed(int64_t until_ms) {
  const ssize_t count =
      write_file(g.sealed + g.sealed_begin, g.sealed_end - g.sealed_begin, until_ms);
  if (count < 0) return -1;
  g.sealed_begin += (size_t)count;
  return g.sealed_begin == g.sealed_end;
}

int eagerx_line_write(const uint8_t* bytes, size_t size) {
  const int64_t until_ms = eagerx_now_ms() + kWriteMs;
  if (!g.is_sealed) return write_file(bytes, size, until_ms) >= 0;
  while (size > 0) {
    const int gone = send_sealed(until_ms);
    if (gone != 1) return gone == 0; /* late data is dropped before encryption */
    const size_t count = size < EAGERX_RECORD ? size : EAGERX_RECORD;
    g.sealed_begin = 0;
    g.sealed_end = eagerx_seal(&g.records, bytes, count, g.sealed);
    bytes += count;
    size -= count;
  }
  return send_sealed(until_ms) >= 0;
}

int eagerx_line_knows_peer(void) {
  return !g.is_socket || g.is_sealed;
}

int eagerx_line_is_forged(void) {
  return g.is_forged;
}

void eagerx_line_close(void) {
  if (g.is_sealed && g.sealed_begin == g.sealed_end) {
    g.sealed_begin = 0;
    g.sealed_end = eagerx_seal(&g.records, 0, 0, g.sealed);
    send_sealed(0);
  }
  if (!g.is_socket) ioctl(g.file, TIOCNXCL);
  close(g.file);
  g.file = -1;
  explicit_bzero(&g.records, sizeof g.records);
}
