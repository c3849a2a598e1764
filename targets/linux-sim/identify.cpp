#include <cstdio>
#include <cstring>
#include <targets/linux-sim/files.hpp>
#include <targets/linux-sim/identify.hpp>
#include <targets/linux-sim/text_file.hpp>

namespace eagerx::linux_sim {

int finish_identification(const Options& options, const std::string& report,
                          const std::string& yaml) {
  if (options.identify_out.empty()) return print(stdout, report + yaml) ? kDone : kBadFile;
  TextFile file;
  if (file.open(options.identify_out)) file.text(yaml);
  if (file.close()) return print(stdout, report) ? kDone : kBadFile;
  std::fprintf(stderr, "error: cannot write `%s`: %s\n", options.identify_out.c_str(),
               std::strerror(file.error()));
  return kBadFile;
}

}  // namespace eagerx::linux_sim
