#include <sys/stat.h>
#include <unistd.h>

#include <cstring>
#include <runtime/host/base/files.hpp>
#include <targets/linux-sim/files.hpp>
#include <vector>

namespace eagerx::linux_sim {
namespace {

/// A name on the command line; what it is called in messages.
struct Named {
  std::string option;
  std::string path;
};

/// The file behind a name or a descriptor.
struct Place {
  std::string name;
  struct stat status;
};

bool is_same(const Place& a, const Place& b) {
  return a.status.st_dev == b.status.st_dev && a.status.st_ino == b.status.st_ino;
}

std::string quoted(const Named& named) {
  return "`" + named.option + " " + named.path + "`";
}

/// Files on a disk only; a terminal or a pipe may be whatever it is.
void add_descriptor(std::vector<Place>& places, int descriptor, const char* name) {
  Place place{name, {}};
  if (fstat(descriptor, &place.status) == 0 && S_ISREG(place.status.st_mode))
    places.push_back(place);
}

}  // namespace

std::string problem_with_files(const Options& options) {
  const bool reads_actions = options.agent == target::Agent::csv;
  std::vector<Named> inputs = {{"--agent", reads_actions ? options.action_file : ""},
                               {"--replay", options.replay},
                               {"--identify", options.identify},
                               {"--publish-key", options.publish_key}};
  for (const std::string& key : options.keys) {
    inputs.push_back({"--key", key});
    inputs.push_back({"--key", key.substr(key.find('=') + 1)});
  }
  std::vector<Named> outputs = {
      {"--csv", options.csv}, {"--trace", options.trace}, {"--identify-out", options.identify_out}};
  for (const Destination& to : options.publish) {
    if (!to.file.empty()) outputs.push_back({"--publish", to.file});
  }
  std::vector<Place> places;
  for (const Named& input : inputs) {
    Place place{quoted(input), {}};
    if (!input.path.empty() && stat(input.path.c_str(), &place.status) == 0)
      places.push_back(place);
  }
  bool prints = true;  // the standard output is no output of a run, but where the summary goes
  for (const Named& output : outputs) prints = prints && output.path != "-";
  if (prints) add_descriptor(places, STDOUT_FILENO, "the standard output");
  add_descriptor(places, STDERR_FILENO, "the standard error");
  for (const Named& output : outputs) {
    if (output.path.empty()) continue;
    Place place{quoted(output), {}};
    const bool is_descriptor = output.path == "-";
    if (is_descriptor ? fstat(STDOUT_FILENO, &place.status) != 0
                      : stat(output.path.c_str(), &place.status) != 0)
      continue;  // there is none yet; what is wrong with its folder is said when it is made
    if (host::is_dev_null(place.status)) continue;
    if (!is_descriptor && !S_ISREG(place.status.st_mode) && !host::takes_output(place.status))
      return "error: " + place.name +
             " is not a file, FIFO or character device\nhelp: `-` writes to the standard output";
    if (is_descriptor && !S_ISREG(place.status.st_mode)) continue;
    for (const Place& other : places) {
      if (is_same(place, other))
        return "error: " + place.name + " and " + other.name +
               " are one file\nhelp: give each its own";
    }
    places.push_back(place);
  }
  return {};
}

bool print(std::FILE* out, const std::string& text) {
  const int error = host::print(out, text);
  if (error != 0)
    std::fprintf(stderr, "error: cannot write to the standard %s: %s\n",
                 out == stderr ? "error" : "output", std::strerror(error));
  return error == 0;
}

}  // namespace eagerx::linux_sim
