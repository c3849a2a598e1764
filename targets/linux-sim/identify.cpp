#include <cstdio>
#include <cstring>
#include <targets/linux-sim/identify.hpp>
#include <targets/linux-sim/text_file.hpp>

namespace eagerx::linux_sim {

int finish_identification(const Options& options, const std::string& report,
                          const std::string& yaml) {
  std::fputs(report.c_str(), stdout);
  if (options.identify_out.empty()) {
    std::fputs(yaml.c_str(), stdout);
    return std::fflush(stdout) == 0 ? kDone : kBadFile;
  }
  TextFile file;
  if (file.open(options.identify_out)) file.text(yaml);
  if (file.close() && std::fflush(stdout) == 0) return kDone;
  std::fprintf(stderr, "error: cannot write `%s`: %s\n", options.identify_out.c_str(),
               std::strerror(file.error()));
  return kBadFile;
}

}  // namespace eagerx::linux_sim
