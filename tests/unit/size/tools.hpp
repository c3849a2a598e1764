// A folder with programs that stand for the compiler's: each prints a text that a test chose.
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace eagerx::gen {

class Tools {
 public:
  Tools() : folder_(std::filesystem::temp_directory_path() / unique()), path_(std::getenv("PATH")) {
    std::filesystem::create_directories(folder_);
    setenv("PATH", (folder_.string() + ":" + path_).c_str(), 1);
    for (const char* name : {"size", "nm", "addr2line", "objdump", "readelf"}) says(name, "");
    image_ = file("image.elf", elf(kArm));
  }
  ~Tools() {
    setenv("PATH", path_.c_str(), 1);
    std::filesystem::remove_all(folder_);
  }
  Tools(const Tools&) = delete;
  Tools& operator=(const Tools&) = delete;

  /// `arm-none-eabi-NAME` prints this.
  void says(const std::string& name, const std::string& text) {
    const std::string program = (folder_ / ("arm-none-eabi-" + name)).string();
    std::ofstream(program) << "#!/bin/sh\ncat <<'END'\n" << text << "END\n";
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  }
  std::string file(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }

  static constexpr int kArm = 40;
  /// The head of an ELF file for a machine.
  static std::string elf(int machine) {
    std::string head(20, '\0');
    head.replace(0, 4,
                 "\x7f"
                 "ELF");
    head[18] = static_cast<char>(machine);
    return head;
  }
  [[nodiscard]] const std::string& image() const { return image_; }
  [[nodiscard]] std::string folder() const { return folder_.string(); }

 private:
  static std::string unique() {
    static int count = 0;
    return "eagerx-gen-size-test." + std::to_string(getpid()) + "." + std::to_string(++count);
  }
  std::filesystem::path folder_;
  std::string path_, image_;
};

}  // namespace eagerx::gen
