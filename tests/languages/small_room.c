/* Loaded before a part (LD_PRELOAD): the sockets that it accepts have room for some kilobytes only. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <sys/socket.h>

int accept4(int listener, struct sockaddr* address, socklen_t* size, int flags) {
  int (*next)(int, struct sockaddr*, socklen_t*, int) = 0;
  const int bytes = 4096;
  *(void**)&next = dlsym(RTLD_NEXT, "accept4");
  const int file = next(listener, address, size, flags);
  if (file >= 0) setsockopt(file, SOL_SOCKET, SO_SNDBUF, &bytes, sizeof bytes);
  return file;
}
