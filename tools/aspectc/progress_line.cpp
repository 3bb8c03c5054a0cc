#include "tools/aspectc/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace aspect {

ProgressLine::ProgressLine(std::string object, int last_level, ProgressMode mode)
    : object_(std::move(object)),
      last_level_(last_level),
      on_(mode != ProgressMode::never),
      terminal_(isatty(STDERR_FILENO) == 1) {
  if (mode == ProgressMode::automatic) on_ = terminal_;
}

ProgressLine::~ProgressLine() {
  if (open_line_) std::fputs("\r\033[K", stderr);
}

std::string ProgressLine::text(const Progress& p) const {
  constexpr int kBarWidth = 24;
  const double done = p.views_wanted == 0
                          ? 1.0
                          : static_cast<double>(p.views_done) / static_cast<double>(p.views_wanted);
  const double level_s = std::chrono::duration<double>(Clock::now() - level_start_).count();
  const double level_left_s = done > 0 ? level_s * (1 - done) / done : 0;
  // Past the first levels, patches along borders double from level to level.
  double left_s = level_left_s;
  double next_s = level_s + level_left_s;
  for (int level = p.level; level < last_level_; ++level) left_s += next_s *= 2;
  const auto filled = static_cast<std::size_t>(done * kBarWidth);
  return fmt::format("{} level {}/{} [{}{}] {} of {} views, {:.1f} % of the sphere, {} s left",
                     object_, p.level, last_level_, std::string(filled, '#'),
                     std::string(kBarWidth - filled, '.'), p.views_done, p.views_wanted,
                     100 * p.area_accepted, static_cast<int>(left_s + 0.5));
}

void ProgressLine::show(const Progress& progress) {
  if (!on_) return;
  const auto now = Clock::now();
  const bool new_level = progress.level != shown_level_;
  if (new_level) {
    shown_level_ = progress.level;
    level_start_ = now;
  }
  const auto pause = terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(2000);
  if (!new_level && now - shown_ < pause && progress.views_done < progress.views_wanted) return;
  shown_ = now;
  if (terminal_)
    fmt::print(stderr, "\r\033[K{}", text(progress));
  else
    fmt::print(stderr, "{}\n", text(progress));
  open_line_ = terminal_;
  std::fflush(stderr);
}

}  // namespace aspect
