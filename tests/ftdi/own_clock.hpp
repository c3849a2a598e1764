// For builds with sanitizers, which look at the clock before the emulator can be there: included
// before everything else in the emulator and in its test, gives the functions that the emulator
// replaces names of their own.
#pragma once

#include <sched.h>
#include <sys/mman.h>

#include <ctime>

extern "C" {
int emulated_clock_gettime(clockid_t clock, timespec* time);
int emulated_clock_nanosleep(clockid_t clock, int flags, const timespec* until, timespec* left);
int emulated_sched_setscheduler(pid_t process, int policy, const sched_param* parameters);
int emulated_mlockall(int flags);
}

#define clock_gettime emulated_clock_gettime
#define clock_nanosleep emulated_clock_nanosleep
#define sched_setscheduler emulated_sched_setscheduler
#define mlockall emulated_mlockall
