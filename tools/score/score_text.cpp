#include "tools/score/score_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "tools/command_line/terminal_colour.h"

namespace aspect {
namespace {

// Columns as wide as their widest cell; the first `left` ones are aligned to the left.
class Table {
 public:
  Table(std::vector<std::string> head, std::size_t left) : left_(left) {
    rows_.push_back(std::move(head));
  }
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  // Of the row added last.
  void tone(std::size_t column, Tone tone) { tones_[{rows_.size() - 1, column}] = tone; }

  std::string text(bool colours = false) const {
    std::vector<std::size_t> widths(rows_.front().size(), 0);
    for (const auto& row : rows_)
      for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
    std::string text;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      std::string line;
      for (std::size_t k = 0; k < rows_[r].size(); ++k) {
        const std::string blanks(widths[k] - rows_[r][k].size(), ' ');
        const auto tone = tones_.find({r, k});
        const std::string cell =
            tone == tones_.end() ? rows_[r][k] : toned(rows_[r][k], tone->second, colours);
        line += (k > 0 ? "  " : "") + (k < left_ ? cell + blanks : blanks + cell);
      }
      text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return text;
  }

 private:
  std::vector<std::vector<std::string>> rows_;
  std::map<std::pair<std::size_t, std::size_t>, Tone> tones_;  // of row and column
  std::size_t left_;
};

std::string or_dash(const std::string& text) {
  return text.empty() ? "-" : text;
}

std::string time_text(const std::optional<double>& time_ms) {
  return time_ms ? fmt::format("{:.2f}", *time_ms) : "-";
}

std::vector<std::string> summary_row(const std::string& name, const ScoreSummary& summary) {
  const auto percent = [](double share) { return fmt::format("{:.1f}", 100 * share); };
  if (summary.objects == 0)
    return {name, "0", "-", "-", "-", "-", "-", time_text(summary.median_ms)};
  return {name,
          fmt::format("{}", summary.objects),
          percent(summary.right_share()),
          fmt::format("{:.2f}", summary.median_deg),
          percent(summary.within_5),
          percent(summary.within_10),
          percent(summary.within_20),
          time_text(summary.median_ms)};
}

}  // namespace

std::string score_table(const Score& score, bool colours) {
  Table table({"frame", "true", "found", "error deg", "ms"}, 3);
  for (const ScoredFrame& frame : score.frames) {
    const std::string time =
        time_text(frame.line == nullptr ? std::nullopt : frame.line->elapsed_ms);
    if (frame.objects.empty()) table.add({frame.file, "-", "-", "-", time});
    for (const ScoredObject& object : frame.objects) {
      const bool is_hidden = !object.truth.empty() && !object.counts;
      table.add({frame.file, is_hidden ? "(" + object.truth + ")" : or_dash(object.truth),
                 frame.line == nullptr ? "(missing)" : or_dash(object.found),
                 object.right ? fmt::format("{:.2f}", object.error_deg) : "-", time});
      if (!is_hidden) table.tone(2, object.right ? Tone::good : Tone::bad);
    }
  }
  return table.text(colours);
}

std::string score_summary(const Score& score) {
  Table table(
      {"object", "number", "right %", "median deg", "<= 5 %", "<= 10 %", "<= 20 %", "median ms"},
      1);
  for (const auto& [name, summary] : score.objects) table.add(summary_row(name, summary));
  table.add(summary_row("all", score.all));
  return table.text() + fmt::format("{} frames, {} missing, {} things named where they are not\n",
                                    score.frames.size(), score.missing, score.falsely_named);
}

}  // namespace aspect
