#include "tools/aspectc/progress/progress_line.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "tools/aspectc/progress/time_left.h"

namespace aspect {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kTerminalPause{100}, kPlainPause{2000};

// A terminal that cannot erase a line is none.
bool is_terminal() {
  const char* kind = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && kind != nullptr && std::string_view(kind) != "dumb";
}

// Some terminals do not know.
std::size_t terminal_width() {
  winsize size{};
  constexpr std::size_t kUsual = 80;
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : kUsual;
}

std::string duration_text(double seconds) {
  const long whole = std::lround(std::min(seconds, 3.6e8));
  if (whole < 120) return fmt::format("{} s", whole);
  if (whole < 7200) return fmt::format("{} min", (whole + 30) / 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace

std::string progress_text(const std::string& object, int last_level, const Progress& p,
                          std::optional<double> left_s) {
  const std::size_t views_to_come = p.views_wanted - p.views_done;
  const std::string stage = p.border_round > 0
                                ? fmt::format("borders {}/{}", p.border_round, p.border_rounds)
                                : fmt::format("level {}/{}", p.level, last_level);
  std::string text =
      fmt::format("{} {}, {} of {} views, {:.1f} % covered", object, stage,
                  p.views_of_level - views_to_come, p.views_of_level, 100 * p.area_accepted);
  if (p.clusters > 0)
    text += fmt::format(", {} clusters, writing the index", p.clusters);
  else if (p.matches_wanted > 0)
    text += fmt::format(", {} of {} matches", p.matches_done, p.matches_wanted);
  if (p.clusters == 0 && left_s) text += fmt::format(", {} left", duration_text(*left_s));
  return text;
}

std::string cut_to_width(const std::string& text, std::size_t width) {
  std::string cut;
  std::size_t characters = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool goes_on = (byte & 0xC0U) == 0x80U;
    if (!goes_on && ++characters > width) break;
    cut += byte < 0x20 || byte == 0x7F ? '?' : c;
  }
  return cut;
}

ProgressLine::ProgressLine(std::string object, int last_level, ProgressMode mode)
    : object_(std::move(object)),
      last_level_(last_level),
      on_(mode != ProgressMode::never),
      terminal_(is_terminal()),
      quiet_(terminal_                      ? kTerminalPause
             : mode == ProgressMode::always ? milliseconds(0)
                                            : kPlainPause) {}

ProgressLine::~ProgressLine() {
  if (open_line_) std::fputs("\r\033[K", stderr);
}

// Hours of work do not fill a log: plain lines become as rare as a twentieth of the time so far.
bool ProgressLine::is_due(const Progress& progress, Clock::time_point now) const {
  if (now - created_ < quiet_) return false;
  if (!shown_at_) return true;
  if (terminal_) return now - *shown_at_ >= kTerminalPause || progress.clusters > 0;
  if (progress.level != shown_.level || progress.border_round != shown_.border_round ||
      progress.clusters != shown_.clusters)
    return true;
  return now - *shown_at_ >= std::max<Clock::duration>(kPlainPause, (now - created_) / 20);
}

void ProgressLine::print(const std::string& text) {
  if (terminal_)
    fmt::print(stderr, "\r\033[K{}", cut_to_width(text, terminal_width() - 1));
  else
    fmt::print(stderr, "{}\n", cut_to_width(text, text.size()));
  std::fflush(stderr);
  open_line_ = terminal_;
}

void ProgressLine::show(const Progress& progress) {
  if (!on_) return;
  const auto now = Clock::now();
  if (progress.views_total == 0) views_at_ = now;
  if (progress.matches_wanted > 0 && progress.level + progress.border_round != matched_level_) {
    matched_level_ = progress.level + progress.border_round;
    matches_at_ = now;
  }
  if (!is_due(progress, now)) return;
  const auto seconds = [now](Clock::time_point since) {
    return std::chrono::duration<double>(now - since).count();
  };
  print(progress_text(
      object_, last_level_, progress,
      seconds_left(progress, last_level_, {seconds(views_at_), seconds(matches_at_)})));
  shown_ = progress;
  shown_at_ = now;
}

}  // namespace aspect
