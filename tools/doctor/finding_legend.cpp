#include "tools/doctor/finding_legend.h"

#include <fmt/format.h>

#include <algorithm>

#include "tools/doctor/finding_badges.h"
#include "tools/doctor/finding_marks.h"
#include "tools/draw/paper.h"
#include "tools/draw/picture_text.h"

namespace aspect {
namespace {

constexpr int kGap_px = 12, kLine_px = 21, kLabels_px = 64;
constexpr std::size_t kMostEntries = 30;

TextStyle style_of_text() {
  return text_style_for({540, 540});
}

// Words that fit in a width; what does not fit in so many lines is cut.
std::vector<std::string> wrapped(const std::string& text, const TextStyle& style, int width_px,
                                 std::size_t most) {
  std::vector<std::string> lines(1);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t space = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, space - at);
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    at = space + 1;
    if (lines.back().empty() || text_size(longer, style).width <= width_px) {
      lines.back() = longer;
    } else if (lines.size() == most) {
      lines.back() += " ..";
      return lines;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

}  // namespace

FindingLegend::FindingLegend(std::span<const FindingLine> lines, std::span<const Shown> shown,
                             int width_px) {
  const int room_px = width_px - kLabels_px;
  for (std::size_t k = 0; k < std::min(lines.size(), kMostEntries); ++k) {
    const FindingLine& line = lines[k];
    Entry& entry = entries_.emplace_back();
    entry.label = line.label;
    entry.colour = shown[k].marked ? mark_colour(line.severity, k) : kQuietInk;
    const std::string text =
        fmt::format("{} {}: {}{}", severity_name(line.severity), line.code, line.text,
                    shown[k].has_place && !shown[k].marked ? " (not seen from here)" : "");
    entry.words = wrapped(text, style_of_text(), room_px, 3);
    entry.cure = wrapped("cure: " + line.cure, style_of_text(), room_px, 2);
  }
  if (lines.empty()) last_ = "nothing is wrong with it";
  if (lines.size() > entries_.size())
    last_ = fmt::format("and {} more, in the text", lines.size() - entries_.size());
}

int FindingLegend::height_px() const {
  std::size_t rows = last_.empty() ? 0 : 1;
  for (const Entry& entry : entries_) rows += entry.words.size() + entry.cure.size();
  return kGap_px * (1 + static_cast<int>(entries_.size())) + kLine_px * static_cast<int>(rows);
}

void FindingLegend::draw(cv::Mat& page, cv::Point corner) const {
  cv::Point at = corner + cv::Point(kLabels_px, 0);
  for (const Entry& entry : entries_) {
    draw_badge(page, {corner.x + 26, at.y + kLine_px / 2}, entry.label, entry.colour);
    for (const auto* part : {&entry.words, &entry.cure})
      for (const std::string& words : *part) {
        draw_dark_text(page, words, at, style_of_text(), part == &entry.cure ? kQuietInk : kInk);
        at.y += kLine_px;
      }
    at.y += kGap_px;
  }
  draw_dark_text(page, last_, at, style_of_text(), kQuietInk);
}

}  // namespace aspect
