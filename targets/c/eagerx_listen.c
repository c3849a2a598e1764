/* Access control of sockets. */
#define _GNU_SOURCE
#include <arpa/inet.h>
#include <errno.h>
#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <time.h>
#include <unistd.h>

#include "eagerx_line.h"

enum { kMostUnknown = 16, kWaiting = 128 };

int64_t eagerx_now_ms(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (int64_t)now.tv_sec * 1000 + now.tv_nsec / 1000000;
}

int eagerx_is_tcp(const char* address) {
  return strncmp(address, "unix:", 5) != 0 && strchr(address, '/') == 0 &&
         strchr(address, ':') != 0;
}

/* True if a program listens on the socket: connecting a datagram socket to it fails, but only a
 * dead one refuses. */
static int is_alive(const struct sockaddr_un* address) {
  const int probe = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const int refused = connect(probe, (const struct sockaddr*)address, sizeof *address) != 0 &&
                      errno == ECONNREFUSED;
  close(probe);
  return !refused;
}

/* Two programs must not remove each other's socket. */
static int lock_folder(const char* path) {
  char folder[sizeof((struct sockaddr_un*)0)->sun_path];
  const char* const slash = strrchr(path, '/');
  const size_t size = slash == 0 ? 0 : (size_t)(slash - path) + 1;
  memcpy(folder, path, size);
  folder[size] = '\0';
  const int file = open(slash == 0 ? "." : folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file >= 0) flock(file, LOCK_EX);
  return file;
}

/* Returns 0 on failure, with the reason in errno. */
static int listen_at(int file, const char* path) {
  struct sockaddr_un address = {.sun_family = AF_UNIX};
  struct stat there;
  strcpy(address.sun_path, path);
  if (lstat(path, &there) ==
      0) { /* removes the socket of an earlier run, but no live socket and no other file */
    if (!S_ISSOCK(there.st_mode) || is_alive(&address)) return errno = EADDRINUSE, 0;
    unlink(path);
  }
  strcat(address.sun_path, "~");
  if (lstat(address.sun_path, &there) == 0 && S_ISSOCK(there.st_mode)) unlink(address.sun_path);
  return fchmod(file, 0600) == 0 && /* only its owner can connect, from the beginning */
         bind(file, (const struct sockaddr*)&address, sizeof address) == 0 &&
         listen(file, 1) == 0 &&
         rename(address.sun_path, path) == 0; /* a peer can connect once the socket is visible */
}

static int listen_unix(const char* path, char* problem) {
  if (strlen(path) + 1 >= sizeof((struct sockaddr_un*)0)->sun_path)
    return snprintf(problem, EAGERX_PROBLEM, "the path is too long for a socket"), -1;
  const int file = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int lock = lock_folder(path);
  const int good = listen_at(file, path), number = errno;
  close(lock);
  if (good) return fprintf(stderr, "listens on unix:%s\n", path), file;
  snprintf(problem, EAGERX_PROBLEM, "%s",
           number == EADDRINUSE ? "another program listens on it, or it is not a socket"
                                : strerror(number));
  close(file);
  return -1;
}

static int is_of_this_machine(const struct sockaddr* address) {
  if (address->sa_family == AF_INET)
    return ntohl(((const struct sockaddr_in*)address)->sin_addr.s_addr) >> 24 == 127;
  if (address->sa_family != AF_INET6) return 0;
  const struct in6_addr* const six = &((const struct sockaddr_in6*)address)->sin6_addr;
  return IN6_IS_ADDR_LOOPBACK(six) || (IN6_IS_ADDR_V4MAPPED(six) && six->s6_addr[12] == 127);
}

static void say_where(int file, int has_key) {
  struct sockaddr_storage address;
  socklen_t size = sizeof address;
  char host[NI_MAXHOST] = "", port[NI_MAXSERV] = "";
  getsockname(file, (struct sockaddr*)&address, &size);
  getnameinfo((struct sockaddr*)&address, size, host, sizeof host, port, sizeof port,
              NI_NUMERICHOST | NI_NUMERICSERV);
  const int six = strchr(host, ':') != 0;
  fprintf(stderr, "listens on %s%s%s:%s, %s\n", six ? "[" : "", host, six ? "]" : "", port,
          has_key ? "for holders of the key" : "for this machine only");
}

/* True for a decimal port number. getaddrinfo() would also accept other texts. */
static int is_port(const char* text) {
  unsigned long number = 0;
  if (*text == '\0' || strlen(text) > 5) return 0;
  for (; *text != '\0'; ++text) {
    if (*text < '0' || *text > '9') return 0;
    number = number * 10 + (unsigned long)(*text - '0');
  }
  return number <= 65535;
}

static int listen_tcp(const char* address, int has_key, char* problem) {
  char host[256] = "localhost";
  const char* const colon = strrchr(address, ':');
  if (colon == 0 || !is_port(colon + 1) || (size_t)(colon - address) >= sizeof host)
    return snprintf(problem, EAGERX_PROBLEM, "it is neither unix:PATH nor HOST:PORT"), -1;
  if (colon != address) {
    const int brackets = address[0] == '[' && colon[-1] == ']';
    snprintf(host, sizeof host, "%.*s", (int)(colon - address) - 2 * brackets, address + brackets);
  }
  const struct addrinfo hints = {.ai_socktype = SOCK_STREAM};
  struct addrinfo* found = 0;
  const int wrong = getaddrinfo(host, colon + 1, &hints, &found);
  if (wrong != 0) return snprintf(problem, EAGERX_PROBLEM, "%s", gai_strerror(wrong)), -1;
  int file = -1, yes = 1;
  for (const struct addrinfo* item = found; item != 0 && file < 0; item = item->ai_next) {
    if (!has_key && !is_of_this_machine(item->ai_addr)) {
      snprintf(problem, EAGERX_PROBLEM,
               "beyond this machine TCP needs a key\n"
               "help: `eagerx-gen key new FILE` writes one; both sides take it with `--key FILE`");
      break;
    }
    file = socket(item->ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
    setsockopt(file, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    if (bind(file, item->ai_addr, item->ai_addrlen) == 0 &&
        listen(file, has_key ? kWaiting : 1) == 0)
      break;
    snprintf(problem, EAGERX_PROBLEM, "%s", strerror(errno));
    close(file);
    file = -1;
  }
  freeaddrinfo(found);
  if (file >= 0) say_where(file, has_key);
  return file;
}

/* First peer that sends anything; later peers are rejected. */
static int accept_one(int listener) {
  for (;;) {
    const int file = accept4(listener, 0, 0, SOCK_CLOEXEC);
    if (file < 0) continue;
    struct pollfd item = {file, POLLIN, 0};
    uint8_t first;
    const int ready = poll(&item, 1, EAGERX_GREETING_MS) > 0;
    if (ready && recv(file, &first, 1, MSG_PEEK) > 0) return file;
    if (ready)
      fprintf(stderr, "note: a peer hung up before it sent anything\n");
    else
      fprintf(stderr, "note: a peer said nothing for %d s and was dropped\n",
              EAGERX_GREETING_MS / 1000);
    close(file);
  }
}

/* Connections that have not yet proved that they have the key. */
static struct {
  int file;
  int64_t until_ms;
  struct eagerx_greeting greeting;
} unknown[kMostUnknown];
static unsigned long dropped, next_note = 1;

static void drop(int which, const char* why) {
  close(unknown[which].file);
  unknown[which].file = -1;
  explicit_bzero(&unknown[which].greeting, sizeof unknown[which].greeting);
  if (++dropped != next_note) return; /* limits the log that repeated connections write */
  next_note *= 10;
  if (dropped == 1)
    fprintf(stderr, "note: dropped a peer that %s\n", why);
  else
    fprintf(stderr, "note: dropped a peer that %s; %lu dropped so far\n", why, dropped);
}

static void let_in(int listener, const struct eagerx_key* key) {
  const int file = accept4(listener, 0, 0, SOCK_CLOEXEC | SOCK_NONBLOCK);
  if (file < 0)
    return; /* the connection failed, which does not affect the listener or other connections */
  int place = 0;
  for (int i = 0; i < kMostUnknown; ++i) {
    if (unknown[i].file < 0) {
      place = i;
      break;
    }
    if (unknown[i].until_ms < unknown[place].until_ms) place = i;
  }
  if (unknown[place].file >= 0) drop(place, "waited longest of too many");
  unknown[place].file = file;
  unknown[place].until_ms = eagerx_now_ms() + EAGERX_GREETING_MS;
  eagerx_greeting_begin(&unknown[place].greeting, key);
}

/* Reads the available bytes of a greeting and answers them. Returns 1 if the peer has the key. */
static int is_known(int which) {
  const char* const hung_up = "hung up before it authenticated";
  struct eagerx_greeting* const greeting = &unknown[which].greeting;
  uint8_t bytes[EAGERX_HELLO], answer[EAGERX_ANSWER];
  const ssize_t count =
      recv(unknown[which].file, bytes, eagerx_greeting_wanted(greeting), MSG_DONTWAIT);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return 0;
  if (count <= 0) return drop(which, hung_up), 0;
  const int size = eagerx_greeting_take(greeting, bytes, (size_t)count, answer);
  if (size < 0) return drop(which, "does not have the key"), 0;
  /* A new connection has room for the answer. */
  if (size > 0 &&
      send(unknown[which].file, answer, (size_t)size, MSG_NOSIGNAL | MSG_DONTWAIT) != size)
    return drop(which, hung_up), 0;
  return greeting->is_done;
}

/* First peer that has the key. Others are dropped after EAGERX_GREETING_MS. */
static int accept_known(int listener, const struct eagerx_key* key,
                        struct eagerx_records* records) {
  fcntl(listener, F_SETFL, O_NONBLOCK);
  for (int i = 0; i < kMostUnknown; ++i) unknown[i].file = -1;
  for (int known = -1; known < 0;) {
    struct pollfd items[kMostUnknown + 1];
    int64_t until_ms = INT64_MAX;
    for (int i = 0; i < kMostUnknown; ++i) {
      items[i] = (struct pollfd){unknown[i].file, POLLIN, 0}; /* poll() ignores -1 */
      if (unknown[i].file >= 0 && unknown[i].until_ms < until_ms) until_ms = unknown[i].until_ms;
    }
    items[kMostUnknown] = (struct pollfd){listener, POLLIN, 0};
    const int64_t left = until_ms == INT64_MAX ? -1 : until_ms - eagerx_now_ms();
    const int ready = poll(items, kMostUnknown + 1,
                           until_ms == INT64_MAX ? -1
                           : left < 0            ? 0
                                                 : (int)left);
    for (int i = 0; i < kMostUnknown && known < 0; ++i)
      if (ready > 0 && unknown[i].file >= 0 && items[i].revents != 0 && is_known(i)) known = i;
    if (known >= 0) {
      const int file = unknown[known].file;
      eagerx_greeting_go_on(&unknown[known].greeting, records);
      unknown[known].file = -1;
      for (int i = 0; i < kMostUnknown; ++i)
        if (unknown[i].file >= 0) close(unknown[i].file);
      explicit_bzero(unknown, sizeof unknown);
      return file;
    }
    for (int i = 0; i < kMostUnknown; ++i)
      if (unknown[i].file >= 0 && unknown[i].until_ms <= eagerx_now_ms())
        drop(i, "did not authenticate within 5 s");
    if (ready > 0 && items[kMostUnknown].revents != 0) let_in(listener, key);
  }
  return -1;
}

int eagerx_listen(const char* address, const struct eagerx_key* key, struct eagerx_records* records,
                  char* problem) {
  const int yes = 1;
  const int is_unix = strncmp(address, "unix:", 5) == 0;
  const int listener =
      is_unix ? listen_unix(address + 5, problem) : listen_tcp(address, key != 0, problem);
  if (listener < 0) return -1;
  const int file = key != 0 ? accept_known(listener, key, records) : accept_one(listener);
  close(listener);
  setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes); /* has no effect on other sockets */
  return file;
}
