#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "generator/analysis/size/program_file.hpp"
#include "generator/analysis/size/size.hpp"
#include "generator/analysis/size/stack.hpp"
#include "generator/analysis/size/tools.hpp"
#include "generator/backend/program_map/program_map.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

struct Symbol {
  std::uint64_t address = 0, size = 0;
  char type = ' ';
  std::string name;
};

std::uint64_t hex(std::string_view text) {
  return std::strtoull(std::string(text).c_str(), nullptr, 16);
}

class Measurement {
 public:
  Measurement(const std::string& image, const std::string& prefix, Diagnostics& diagnostics)
      : image_(image), prefix_(prefix), diagnostics_(diagnostics) {}

  /// nullopt with a problem.
  std::optional<SizeReport> run() {
    SizeReport report;
    if (!read_total(report) || !read_symbols() || !read_addresses()) {
      diagnostics_
          .io_error("E0911", {}, fmt::format("cannot read `{}` with `{}nm`", image_, prefix_))
          .help = "install the board's compiler: toolchains/install-packages boards";
      return std::nullopt;
    }
    if (!read_map()) return std::nullopt;
    for (const auto& frames : addresses_) usage(report, owner(frames)).flash += 2;
    attribute_data(report);
    divide_shared(report);
    attribute_rest(report);
    return report;
  }

  /// Says whose each call is: its caller's line in program.hpp tells the node, and below a node all
  /// is the node's. Else it is the part's that the function belongs to.
  void name_calls(StackBound& stack) const {
    const StackCall* node = nullptr;
    for (StackCall& call : stack.calls) {
      Owner owner = owner_of_address(call.called_from);
      if (!owner.is_node && is_known(call.begin)) owner = owner_of_address(call.begin);
      if (!owner.is_node && node != nullptr) owner = {true, node->part};
      call.part = owner.name;
      call.of_node = owner.is_node;
      if (call.of_node) node = &call;
    }
  }

 private:
  bool read_total(SizeReport& report) {
    bool found = false;
    for_each_line({prefix_ + "size", image_}, [&](std::string_view line) {
      unsigned long long text = 0, data = 0, bss = 0;
      if (std::sscanf(std::string(line).c_str(), "%llu %llu %llu", &text, &data, &bss) != 3) return;
      report.flash = text + data;
      report.ram = data + bss;
      image_bytes_ = text + data + bss;
      found = true;
    });
    return found;
  }

  bool read_symbols() {
    for_each_line({prefix_ + "nm", "-S", "-C", "--defined-only", image_},
                  [&](std::string_view line) { read_symbol(line); });
    return !symbols_.empty();
  }

  /// "address size type name", or "address type name".
  void read_symbol(std::string_view line) {
    const auto first = line.find(' ');
    if (first == std::string_view::npos) return;
    const auto second = line.find(' ', first + 1);
    if (second == std::string_view::npos) return;
    if (second == first + 2) {
      ends_[std::string(line.substr(second + 1))] = hex(line.substr(0, first));
      return;
    }
    if (line.size() < second + 4 || line[second + 2] != ' ') return;
    Symbol symbol{hex(line.substr(0, first)), hex(line.substr(first + 1, second - first - 1)),
                  line[second + 1], std::string(line.substr(second + 3))};
    constexpr std::uint64_t kThumb = 1;
    if (is_code(symbol)) symbol.address &= ~kThumb;
    if (symbol.size > image_bytes_) return;  // of another image, or nonsense
    symbols_[symbol.address] = symbol;       // one of those that share an address
  }

  static bool is_code(const Symbol& symbol) {
    return std::string_view("tTwW").find(symbol.type) != std::string_view::npos;
  }

  /// The frames of every address of code; false if there is no room for a temporary file.
  bool read_addresses() {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> list(std::tmpfile(), std::fclose);
    if (list == nullptr) return false;
    for (const auto& [address, symbol] : symbols_) {
      if (!is_code(symbol)) continue;
      for (std::uint64_t at = address; at < address + symbol.size; at += 2)
        fmt::print(list.get(), "{:x}\n", at);
    }
    if (std::fflush(list.get()) != 0 || std::fseek(list.get(), 0, SEEK_SET) != 0) return false;
    addresses_.clear();
    places_.clear();
    const auto take = [&](std::string_view line) {
      if (line.starts_with("0x")) {
        addresses_.emplace_back();
        places_.push_back(hex(line.substr(2)));
      } else if (!addresses_.empty()) {
        addresses_.back().emplace_back(line);
      }
    };
    // One process for all: it reads the image's description once.
    for_each_line({prefix_ + "addr2line", "-a", "-i", "-e", image_}, take, fileno(list.get()));
    return true;
  }

  using Frames = std::vector<std::string>;
  using Owner = ProgramMap::Owner;

  /// The program.hpp that the image was compiled from; empty if there is none.
  std::string find_program() const {
    for (const auto& frames : addresses_) {
      for (const auto& frame : frames) {
        std::string file = frame.substr(0, frame.rfind(':'));
        if (file.ends_with("/program.hpp")) return file;
      }
    }
    return {};
  }

  /// The map next to program.hpp; it stays empty for an image of no generated program.
  bool read_map() {
    const std::string program = find_program();
    if (program.empty()) return true;
    auto map = map_of_program(program, image_, diagnostics_);
    if (!map) return false;
    map_ = std::move(*map);
    return true;
  }

  static Usage& usage(SizeReport& report, const Owner& owner) {
    return (owner.is_node ? report.nodes : report.others)[owner.name];
  }

  /// Frames go from what was inlined to what it was inlined into.
  Owner owner(const Frames& frames) const {
    for (const auto& frame : frames) {
      const auto colon = frame.rfind(':');
      if (!frame.substr(0, colon).ends_with("/program.hpp")) continue;
      const auto line = std::strtoul(frame.c_str() + colon + 1, nullptr, 10);
      if (const std::string* node = map_.node_of_line(static_cast<std::uint32_t>(line)))
        return {true, *node};
    }
    for (const auto& frame : frames) {
      Owner owner = owner_of_file(frame);
      if (!owner.name.empty()) return owner;
    }
    return {false, "libraries"};
  }

  bool is_known(std::uint64_t address) const { return ranges::contains(places_, address); }

  Owner owner_of_address(std::uint64_t address) const {
    const auto found = ranges::find(places_, address);
    if (found == places_.end()) return {false, "libraries"};
    return owner(addresses_[static_cast<std::size_t>(found - places_.begin())]);
  }

  Owner owner_of_file(const std::string& frame) const {
    const auto has = [&](std::string_view part) { return frame.find(part) != std::string::npos; };
    if (has("/models/")) return owner_of_model(frame);
    if (has("/eagerx/policy") || has("/policy.hpp")) return {false, "policy"};
    if (has("/program.hpp")) return {false, "schedule"};
    if (has("/runtime/eagerx/") || has("/src/eagerx/") || has("/graph.hpp"))
      return {false, "runtime"};
    if (has("/targets/") || has("/main.cpp")) return {false, "board"};
    return {};
  }

  /// Code of an entity that was not inlined: its node, if there is one of that type only.
  Owner owner_of_model(const std::string& frame) const {
    const auto slash = frame.rfind('/');
    std::string type;
    bool capital = true;
    for (const char c : frame.substr(slash + 1, frame.rfind('.') - slash - 1)) {
      if (c != '_') type += capital ? static_cast<char>(std::toupper(c)) : c;
      capital = c == '_';
    }
    Owner found;
    for (const auto& [node, its] : map_.type_of_node) {
      if (its != type) continue;
      if (found.is_node) return {false, "models/" + type};
      found = {true, node};
    }
    return found.is_node ? found : Owner{false, "models/" + type};
  }

  void attribute_data(SizeReport& report) {
    read_classes();
    for (const auto& [address, symbol] : symbols_) {
      if (is_code(symbol)) continue;
      const bool data = address >= ends_["eagerx_data_begin"] && address < ends_["eagerx_data_end"];
      const bool bss = address >= ends_["eagerx_bss_begin"] && address < ends_["eagerx_bss_end"];
      if (bss && is_program(symbol)) {
        attribute_program(report, symbol.size);
        continue;
      }
      const bool policy = symbol.name.find("::policy::") != std::string::npos;
      Usage& owner = report.others[policy ? "policy" : "board"];
      if (!bss) owner.flash += symbol.size;
      if (data || bss) owner.ram += symbol.size;
    }
  }

  /// The program object: of a program of eagerx-gen by its name, as a variable of the function that
  /// runs it; of a library, whose object has a name of the user's, by its class, which has members
  /// of the map.
  bool is_program(const Symbol& symbol) const {
    if (symbol.name.starts_with("eagerx::board::") && symbol.name.ends_with("::program"))
      return true;
    const auto found = classes_.find(symbol.size);
    return found != classes_.end() && std::ranges::any_of(found->second, [&](const auto& member) {
             return map_.owner_of_member.contains(member.second);
           });
  }

  using Members = std::map<std::uint64_t, std::string>;  // by their offset

  /// The classes of the image's description that have members: by their size, of several the one
  /// with the most members.
  void read_classes() {
    Members members;
    bool inside = false, in_member = false;
    std::uint64_t size = 0;
    std::string name;
    const auto value = [](std::string_view line) {
      return std::string(line.substr(line.rfind(' ') + 1));
    };
    const auto number = [&](std::string_view line) {
      return std::strtoull(value(line).c_str(), nullptr, 0);
    };
    const auto finish = [&] {
      std::erase_if(members, [&](const auto& member) { return member.first >= size; });
      if (members.size() > classes_[size].size()) classes_[size] = members;
      members.clear();
    };
    for_each_line({prefix_ + "readelf", "--debug-dump=info", "-W", image_},
                  [&](std::string_view line) {
                    if (line.find("Abbrev Number") != std::string_view::npos) {
                      in_member = inside && line.find("DW_TAG_member") != std::string_view::npos;
                      if (line.find("DW_TAG_class_type") != std::string_view::npos) {
                        finish();
                        inside = true;
                        size = 0;
                      }
                    } else if (!inside) {
                      return;
                    } else if (!in_member && size == 0 &&
                               line.find("DW_AT_byte_size") != std::string_view::npos) {
                      size = number(line);
                    } else if (in_member && line.find("DW_AT_name") != std::string_view::npos) {
                      name = value(line);
                    } else if (in_member &&
                               line.find("DW_AT_data_member_location") != std::string_view::npos) {
                      members[number(line)] = name;
                    }
                  });
    finish();
  }

  /// The members of the program object: from one offset to the next.
  void attribute_program(SizeReport& report, std::uint64_t size) {
    const Members& members = classes_[size];
    for (auto member = members.begin(); member != members.end(); ++member) {
      const auto next = std::next(member);
      const std::uint64_t bytes = (next == members.end() ? size : next->first) - member->first;
      usage(report, map_.owner(member->second)).ram += bytes;
    }
    if (members.empty()) report.others["schedule"].ram += size;
  }

  /// Nodes that are one loop have equal parts of it; what is left over is the first one's.
  void divide_shared(SizeReport& report) const {
    std::map<std::string, std::vector<std::string>> sharers;
    for (const auto& [node, owner] : map_.shares) sharers[owner].push_back(node);
    for (const auto& [owner, others] : sharers) {
      Usage& own = report.nodes[owner];
      const Usage part{own.flash / (others.size() + 1), own.ram / (others.size() + 1)};
      for (const auto& node : others) {
        report.nodes[node] = part;
        own.flash -= part.flash;
        own.ram -= part.ram;
      }
    }
  }

  static void attribute_rest(SizeReport& report) {
    Usage sum;
    for (const auto* part : {&report.nodes, &report.others}) {
      for (const auto& [name, usage] : *part) {
        sum.flash += usage.flash;
        sum.ram += usage.ram;
      }
    }
    // Constants without a symbol, what the linker adds, alignment.
    Usage& rest = report.others["other"];
    rest.flash += report.flash > sum.flash ? report.flash - sum.flash : 0;
    rest.ram += report.ram > sum.ram ? report.ram - sum.ram : 0;
  }

  std::string image_, prefix_;
  Diagnostics& diagnostics_;
  std::uint64_t image_bytes_ = 0;  // flash and RAM: no symbol can be larger
  std::map<std::uint64_t, Symbol> symbols_;
  std::map<std::string, std::uint64_t> ends_;
  std::vector<Frames> addresses_;
  std::vector<std::uint64_t> places_;  // of these
  ProgramMap map_;
  std::map<std::uint64_t, Members> classes_;
};

}  // namespace

std::optional<SizeReport> measure_image(const std::string& image, const std::string& build,
                                        Diagnostics& diagnostics) {
  std::error_code error;
  if (!fs::is_regular_file(image, error)) {
    diagnostics.io_error("E0911", {},
                         fmt::format("cannot read `{}`: {}", image,
                                     fs::exists(image, error) ? "not a file" : "no such file"));
    return std::nullopt;
  }
  // Of a program for Linux neither flash nor the stack's frames are known.
  const auto prefix = tool_prefix(image);
  if (!prefix || prefix->empty()) {
    diagnostics.io_error("E0911", {}, fmt::format("`{}` is not the image of a board", image)).help =
        "give the .elf file that was built for one";
    return std::nullopt;
  }
  Measurement measurement(image, *prefix, diagnostics);
  auto report = measurement.run();
  if (!report) return report;
  report->stack = stack_bound(*prefix, image, build);
  measurement.name_calls(report->stack);
  return report;
}

}  // namespace eagerx::gen
