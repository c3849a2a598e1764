#include "generator/tools/monitor/screen.hpp"

#ifdef EAGERX_NCURSES
#define NCURSES_NOMACROS  // names such as clear and erase
#include <curses.h>
#include <langinfo.h>

#include <algorithm>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace eagerx::gen {
namespace {

enum Pair : short { kWarningPair = 1, kTitlePair, kDimPair };

/// ncurses has one screen at a time.
class NcursesScreen final : public Screen {
 public:
  explicit NcursesScreen(SCREEN* screen) : screen_(screen) {
    set_term(screen_);
    cbreak();
    noecho();
    nonl();
    keypad(stdscr, TRUE);
    nodelay(stdscr, TRUE);
    set_escdelay(kEscapeMs);
    curs_set(0);
    const char* const without = std::getenv("NO_COLOR");
    if ((without == nullptr || *without == '\0') && has_colors() && start_color() == OK) {
      use_default_colors();
      init_pair(kWarningPair, COLOR_YELLOW, -1);
      init_pair(kTitlePair, COLOR_CYAN, -1);
      init_pair(kDimPair, COLOR_BLUE, -1);
      colours_ = true;
    }
  }
  ~NcursesScreen() override {
    endwin();
    delscreen(screen_);
  }
  NcursesScreen(const NcursesScreen&) = delete;
  NcursesScreen& operator=(const NcursesScreen&) = delete;

  ScreenSize size() override {
    return {static_cast<std::size_t>(std::max(getmaxy(stdscr), 0)),
            static_cast<std::size_t>(std::max(getmaxx(stdscr), 0)),
            std::strcmp(nl_langinfo(CODESET), "UTF-8") == 0};
  }

  void draw(const std::vector<ScreenLine>& lines) override {
    erase();
    for (std::size_t row = 0; row < lines.size(); ++row) {
      move(static_cast<int>(row), 0);
      for (const InkedText& part : lines[row]) {
        const attr_t attributes = attributes_of(part.ink);
        attr_on(attributes, nullptr);
        addnstr(part.text.data(), static_cast<int>(part.text.size()));
        attr_off(attributes, nullptr);
      }
    }
    refresh();
  }

  std::optional<KeyPress> key() override {
    while (true) {
      const int code = getch();
      if (code == ERR) return std::nullopt;
      if (const auto press = press_of(code)) return press;
    }
  }

 private:
  static constexpr int kEscapeMs = 25;

  [[nodiscard]] attr_t attributes_of(Ink ink) const {
    const auto pair = [&](Pair number) {
      return colours_ ? static_cast<attr_t>(COLOR_PAIR(number)) : attr_t{A_NORMAL};
    };
    switch (ink) {
      case Ink::title:
        return A_BOLD | pair(kTitlePair);
      case Ink::head:
        return A_UNDERLINE;
      case Ink::dim:
        return pair(kDimPair);
      case Ink::selected:
        return A_REVERSE;
      case Ink::warning:
        return A_BOLD | pair(kWarningPair);
      case Ink::plain:
        break;
    }
    return A_NORMAL;
  }

  static std::optional<KeyPress> press_of(int code) {
    constexpr int kEscape = 27, kDelete = 127, kBackspace = 8;
    switch (code) {
      case KEY_UP:
        return KeyPress{Key::up};
      case KEY_DOWN:
        return KeyPress{Key::down};
      case KEY_PPAGE:
        return KeyPress{Key::page_up};
      case KEY_NPAGE:
        return KeyPress{Key::page_down};
      case KEY_HOME:
        return KeyPress{Key::home};
      case KEY_END:
        return KeyPress{Key::end};
      case KEY_ENTER:
      case '\r':
      case '\n':
        return KeyPress{Key::enter};
      case KEY_BACKSPACE:
      case kDelete:
      case kBackspace:
        return KeyPress{Key::backspace};
      case kEscape:
        return KeyPress{Key::escape};
      default:
        break;
    }
    if (code < ' ' || code > '~')
      return std::nullopt;  // KEY_RESIZE too: what is next is drawn anew
    return KeyPress{Key::character, static_cast<char>(code)};
  }

  SCREEN* const screen_;
  bool colours_ = false;
};

}  // namespace

std::unique_ptr<Screen> open_screen(std::string& problem) {
  // Only what is drawn: numbers stay as they are everywhere.
  std::setlocale(LC_CTYPE, "");
  // initscr() would end the program where the terminal is not known.
  SCREEN* const screen = newterm(nullptr, stdout, stdin);
  if (screen == nullptr) {
    const char* const name = std::getenv("TERM");
    problem = std::string("error: nothing is known of the terminal `") +
              (name == nullptr ? "" : name) + "` (TERM)\nhelp: `--lines` prints lines";
    return nullptr;
  }
  return std::make_unique<NcursesScreen>(screen);
}

}  // namespace eagerx::gen

#else

namespace eagerx::gen {

std::unique_ptr<Screen> open_screen(std::string& problem) {
  problem =
      "error: this eagerx-gen was built without ncurses, so it has no screen\n"
      "help: `--lines` prints lines; for a screen build it where the package `libncurses-dev` is";
  return nullptr;
}

}  // namespace eagerx::gen
#endif
