#include "generator/tools/serve/router.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "generator/support/diagnostics/search.hpp"
#include "generator/tools/serve/status.hpp"

namespace eagerx::gen::serve {
namespace {

constexpr double kLongPollS = 20.0;

constexpr std::array kGets = {"", "state", "changes", "library", "schema", "run", "result", "loop"};
constexpr std::array kPosts = {"edit", "undo", "redo", "layout", "run", "stop"};

template <std::size_t N>
bool is_among(const std::array<const char*, N>& words, std::string_view word) {
  return ranges::contains(words, word);
}

/// Takes as long for every text of this length.
bool is_same(std::string_view a, std::string_view b) {
  unsigned difference = a.size() == b.size() ? 0U : 1U;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    difference |=
        static_cast<unsigned>(static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]));
  return difference == 0;
}

/// The path after its first part: "/TOKEN/state" is "state".
std::string_view rest_of(std::string_view path, std::string_view token) {
  const std::size_t size = std::min(path.size(), token.size() + 2);
  return path.substr(size);
}

bool is_json(std::string_view type) {
  constexpr std::string_view kJson = "application/json";
  if (type.substr(0, kJson.size()) != kJson) return false;
  return type.size() == kJson.size() || type[kJson.size()] == ';' || type[kJson.size()] == ' ';
}

/// A whole number that is a parameter; `otherwise` where there is none, nothing where it is none.
std::optional<std::int64_t> whole(const Asked& asked, const std::string& name,
                                  std::int64_t otherwise) {
  const auto found = ranges::find(asked.query, name, &std::pair<std::string, std::string>::first);
  if (found == asked.query.end()) return otherwise;
  const std::string* const text = &found->second;
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), number);
  if (error != std::errc() || end != text->data() + text->size() || number < 0) return std::nullopt;
  return number;
}

Answer answer_of(const Reply& reply) {
  return {reply.status, "application/json", dump_json(reply.body)};
}
/// An error in the form that all have.
Answer refused(int status, const std::string& problem, const std::string& help = {}) {
  return answer_of(failure(status, problem, help));
}
Answer html(std::string text) {
  return {200, "text/html; charset=utf-8", std::move(text)};
}

}  // namespace

Router::Router(Session& session, Programs& programs, std::string token, int port)
    : session_(session),
      programs_(programs),
      token_(std::move(token)),
      hosts_{fmt::format("127.0.0.1:{}", port), fmt::format("localhost:{}", port)} {}

std::string Router::address() const {
  return fmt::format("http://{}/{}/", hosts_.front(), token_);
}

Answer Router::error(int status) const {
  return refused(
      status, status == kTooLarge ? "the body is too large" : "the request is none that is known");
}

std::optional<Answer> Router::refusal(const Asked& asked) const {
  if (!ranges::contains(hosts_, asked.host))
    return refused(kForbidden, "the request is for another host");
  if (!asked.origin.empty() && asked.origin != "http://" + asked.host)
    return refused(kForbidden, "the request comes from another page");
  constexpr std::size_t kNone = std::string_view::npos;
  const std::string_view path = asked.path;
  const std::size_t end = path.find('/', std::min<std::size_t>(1, path.size()));
  const std::string_view token =
      path.substr(std::min<std::size_t>(1, path.size()), end == kNone ? kNone : end - 1);
  if (end == kNone || !is_same(token, token_))
    return refused(kForbidden, "the address has no valid token",
                   "open the address that eagerx-gen serve has printed");
  const std::string_view what = rest_of(path, token_);
  const bool gets = is_among(kGets, what), posts = is_among(kPosts, what);
  if (!gets && !posts) return refused(kNotFound, fmt::format("there is no `{}`", what));
  if ((asked.method != "GET" || !gets) && (asked.method != "POST" || !posts))
    return refused(kWrongMethod, fmt::format("`{}` is not for {}", what, asked.method));
  if (asked.method == "POST" && !is_json(asked.type))
    return refused(kWrongType, "the body is not application/json");
  return std::nullopt;
}

Answer Router::answer(const Asked& asked) {
  const std::string what(rest_of(asked.path, token_));
  if (asked.method == "GET") return get(what, asked);
  const auto request = parse_json(asked.body);
  if (!request || !request->is<Json::Object>())
    return refused(kBadRequest, "the body is not a JSON object");
  return post(what, *request);
}

Answer Router::get(const std::string& what, const Asked& asked) {
  if (what == "state") {
    const auto page = whole(asked, "page", -1);
    if (!page) return refused(kBadRequest, "`page` is not a revision");
    return answer_of(session_.state(*page, programs_.running()));
  }
  if (what == "changes") {
    const auto revision = whole(asked, "revision", 0);
    if (!revision) return refused(kBadRequest, "`revision` is not a revision");
    return answer_of(session_.changes(*revision, kLongPollS));
  }
  if (what == "run") {
    const auto after = whole(asked, "after", 0), row = whole(asked, "row", 0);
    if (!after || !row) return refused(kBadRequest, "`after` or `row` is not a number");
    return answer_of(programs_.output(static_cast<std::uint64_t>(*after),
                                      static_cast<std::uint64_t>(*row), kLongPollS));
  }
  if (what == "library") return answer_of({200, session_.library()});
  if (what == "schema") return answer_of({200, session_.schema()});
  if (what == "result") {
    auto page = programs_.result();
    return page ? html(std::move(*page)) : refused(kNotFound, "no page has been made");
  }
  if (what == "loop") {
    auto loop = programs_.loop();
    return loop ? Answer{200, "application/json", std::move(*loop)}
                : refused(kNotFound, "no loop has been linearized");
  }
  std::string problem;
  auto page = session_.page(problem);
  return page ? html(std::move(*page)) : refused(kFailed, problem);
}

Answer Router::post(const std::string& what, const Json& request) {
  if (what == "edit") return answer_of(session_.edit(request, programs_.running()));
  if (what == "undo") return answer_of(session_.undo(request, programs_.running()));
  if (what == "redo") return answer_of(session_.redo(request, programs_.running()));
  if (what == "layout") return answer_of(session_.set_layout(request));
  if (what == "run") return answer_of(programs_.start(request));
  return answer_of(programs_.stop());
}

}  // namespace eagerx::gen::serve
