// Preloaded into a rank: kills it in a phase of a training that the environment names.
//   KILL_RANK=1 KILL_PHASE=rollout|update|evaluation KILL_ITERATION=7   in the iteration of this
//   number, from 1 on KILL_RANK=0 KILL_PHASE=checkpoint KILL_ITERATION=2                  when the
//   2nd file is renamed to KILL_FILE
// A training asks its ranks for one byte each before an iteration, gathers eight bytes (sizes)
// before what was seen, and exchanges gradients in updates only: this distinguishes the phases.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <mpi.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int iteration = 0, updates = 0, renamed = 0;

static int is_in(const char* phase, int number) {
  const char* const wanted = getenv("KILL_PHASE");
  const char* const victim = getenv("KILL_RANK");
  const char* const rank = getenv("OMPI_COMM_WORLD_RANK");
  return wanted && victim && rank && strcmp(wanted, phase) == 0 && strcmp(victim, rank) == 0 &&
         number == atoi(getenv("KILL_ITERATION"));
}

static void die(void) {
  fprintf(stderr, "killed in %s %s\n", getenv("KILL_PHASE"), getenv("KILL_ITERATION"));
  raise(SIGKILL);
}

int MPI_Iallgatherv(const void* out, int count, MPI_Datatype type, void* in, const int counts[],
                    const int places[], MPI_Datatype in_type, MPI_Comm comm, MPI_Request* request) {
  if (count == 1) {
    ++iteration;
    updates = 0;
  }
  if (count == 8 && updates == 0 && is_in("rollout", iteration)) die();
  if (count == 8 && updates > 0 && is_in("evaluation", iteration)) die();
  return PMPI_Iallgatherv(out, count, type, in, counts, places, in_type, comm, request);
}

int MPI_Ialltoallv(const void* out, const int counts[], const int places[], MPI_Datatype type,
                   void* in, const int in_counts[], const int in_places[], MPI_Datatype in_type,
                   MPI_Comm comm, MPI_Request* request) {
  if (++updates == 3 && is_in("update", iteration)) die();
  return PMPI_Ialltoallv(out, counts, places, type, in, in_counts, in_places, in_type, comm,
                         request);
}

int rename(const char* from, const char* to) {
  int (*next)(const char*, const char*) = dlsym(RTLD_NEXT, "rename");
  const char* const file = getenv("KILL_FILE");
  if (file && strcmp(to, file) == 0 && is_in("checkpoint", ++renamed)) die();
  return next(from, to);
}
