/* Program of a part: its options and exit codes. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "eagerx_line.h"
#include "eagerx_part.h"

enum { kExitUsage = 2, kExitLine = 3, kBaud = 115200 };

/* Returns 0 if the usage is wrong. */
static int read_options(int argc, char** argv, struct eagerx_options* options) {
  for (int i = 1; i + 1 < argc; i += 2) {
    char* rest = "";
    if (strcmp(argv[i], "--listen") == 0)
      options->listen = argv[i + 1];
    else if (strcmp(argv[i], "--link") == 0)
      options->link = argv[i + 1];
    else if (strcmp(argv[i], "--key") == 0)
      options->key = argv[i + 1];
    else if (strcmp(argv[i], "--baud") == 0)
      options->baud = strtol(argv[i + 1], &rest, 10);
    else
      return 0;
    if (*rest != '\0') return 0;
  }
  return argc % 2 == 1 && (options->listen == 0) != (options->link == 0);
}

int eagerx_serve(int argc, char** argv, const struct eagerx_part* part) {
  struct eagerx_options options = {0, 0, 0, kBaud};
  if (!read_options(argc, argv, &options)) {
    fprintf(stderr,
            "error: wrong usage\n"
            "help: %s --listen unix:PATH, :PORT (for this machine only) or HOST:PORT, which beyond this machine needs "
            "--key FILE; or --link TTY, a serial line, with --baud N (115200); serves part `%s` of `%s`\n",
            argv[0], part->name, part->of_graph);
    return kExitUsage;
  }
  int code = eagerx_line_open(&options);
  if (code != 0) return code;
  code = eagerx_run(part);
  if (eagerx_line_is_forged()) {
    fprintf(stderr,
            "error: the line `%s` is closed: a third party changed, repeated or removed data\n",
            options.listen);
    code = kExitLine;
  }
  eagerx_line_close();
  return code;
}
