// The program for Linux.
#include <cstdio>

#include "loop.hpp"

int main() {
  if (!controller::Graph::self_test()) {
    std::fputs("bits differ on this machine: is something linked with -ffast-math?\n", stderr);
    return 1;
  }
  Controller program;
  Motor motor;
  run(program, motor, 2000);
  program.guard.for_each_count([](const char* name, unsigned long long count) {
    if (count > 0) std::printf("%s %llu\n", name, count);
  });
  std::printf("angle in millirad %d\n", static_cast<int>(motor.angle() * 1000.0F));
  std::printf("trace hash 0x%016llx\n", static_cast<unsigned long long>(program.hooks.hash()));
}
