#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <targets/linux-sim/files.hpp>
#include <targets/linux-sim/identify.hpp>
#include <targets/linux-sim/text_file.hpp>

namespace eagerx::linux_sim {
namespace {

/// All of it, or what was there stays. Why it could not be done, as `errno` says it, or 0.
int write_whole(const std::string& path, const std::string& text) {
  struct stat found {};
  const bool is_device = stat(path.c_str(), &found) == 0 && !S_ISREG(found.st_mode);
  const std::string draft = is_device ? path : path + ".part";
  TextFile file;
  if (file.open(draft)) file.text(text);
  const bool is_written = file.close();
  if (is_written && (is_device || std::rename(draft.c_str(), path.c_str()) == 0)) return 0;
  const int error = is_written ? errno : file.error();
  if (!is_device) std::remove(draft.c_str());
  return error;
}

}  // namespace

int finish_identification(const Options& options, const std::string& report,
                          const std::string& yaml) {
  if (options.identify_out.empty()) return print(stdout, report + yaml) ? kDone : kBadFile;
  const int error = write_whole(options.identify_out, yaml);
  if (error == 0) return print(stdout, report) ? kDone : kBadFile;
  std::fprintf(stderr, "error: cannot write `%s`: %s\n", options.identify_out.c_str(),
               std::strerror(error));
  return kBadFile;
}

}  // namespace eagerx::linux_sim
