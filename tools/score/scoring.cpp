#include "tools/score/scoring.h"

#include <algorithm>

namespace aspect {
namespace {

namespace fs = std::filesystem;

bool is_same_file(const std::string& file, const fs::path& folder, const std::string& frame) {
  std::error_code code;
  return frame == file || frame.ends_with("/" + file) || fs::equivalent(frame, folder / file, code);
}

// Things seen in one frame, and what has become of them.
class Things {
 public:
  explicit Things(std::span<const FoundObject> things)
      : things_(things), taken_(things.size(), false), shown_(things.size(), false) {}

  // The one named so that overlaps most; it is taken then.
  const FoundObject* take(const TrueObject& object) {
    std::size_t best = things_.size();
    double most = 0;
    for (std::size_t k = 0; k < things_.size(); ++k) {
      if (taken_[k] || !things_[k].is_named || things_[k].object != object.object) continue;
      const double share = box_overlap(object.box, things_[k].box);
      if (share < kLeastOverlap || share <= most) continue;
      most = share;
      best = k;
    }
    if (best == things_.size()) return nullptr;
    taken_[best] = true;
    return &things_[best];
  }

  // What another thing in an object's place is called; empty where there is none.
  std::string name_in_place_of(const TrueObject& object) {
    for (std::size_t k = 0; k < things_.size(); ++k) {
      if (taken_[k] || shown_[k] || !things_[k].is_named) continue;
      if (box_overlap(object.box, things_[k].box) < kLeastOverlap) continue;
      shown_[k] = true;
      return things_[k].object;
    }
    return {};
  }

  // Those named that are nobody's.
  std::size_t count_false() const {
    std::size_t count = 0;
    for (std::size_t k = 0; k < things_.size(); ++k)
      count += things_[k].is_named && !taken_[k] ? 1U : 0U;
    return count;
  }
  void add_unshown(std::vector<ScoredObject>& objects) const {
    for (std::size_t k = 0; k < things_.size(); ++k)
      if (things_[k].is_named && !taken_[k] && !shown_[k])
        objects.push_back({{}, things_[k].object, false, false, kNotFound_deg});
  }

 private:
  std::span<const FoundObject> things_;
  std::vector<bool> taken_, shown_;
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

// The errors and times that one summary is made of.
struct Collected {
  std::size_t right = 0;
  std::vector<double> errors_deg, times_ms;

  ScoreSummary summary() const {
    ScoreSummary summary;
    summary.objects = errors_deg.size();
    summary.right = right;
    if (!times_ms.empty()) summary.median_ms = median(times_ms);
    if (errors_deg.empty()) return summary;
    const auto within = [&](double most) {
      const auto count = std::count_if(errors_deg.begin(), errors_deg.end(),
                                       [&](double error) { return error <= most; });
      return static_cast<double>(count) / static_cast<double>(errors_deg.size());
    };
    summary.median_deg = median(errors_deg);
    summary.within_5 = within(5);
    summary.within_10 = within(10);
    summary.within_20 = within(20);
    return summary;
  }
};

void summarise(Score& score) {
  std::map<std::string, Collected> by_name;
  Collected all;
  for (const ScoredFrame& frame : score.frames) {
    const bool has_time = frame.line != nullptr && frame.line->elapsed_ms.has_value();
    const double time_ms = has_time ? *frame.line->elapsed_ms : 0;
    if (has_time) all.times_ms.push_back(time_ms);
    std::map<std::string, bool> is_timed;
    for (const ScoredObject& object : frame.objects) {
      if (!object.counts) continue;
      Collected& own = by_name[object.truth];
      for (Collected* collected : {&own, &all}) {
        collected->errors_deg.push_back(object.error_deg);
        collected->right += object.right ? 1U : 0U;
      }
      if (has_time && is_timed.try_emplace(object.truth, true).second)
        own.times_ms.push_back(time_ms);
    }
  }
  for (const auto& [name, collected] : by_name) score.objects[name] = collected.summary();
  score.all = all.summary();
}

}  // namespace

double box_overlap(const PixelBox& a, const PixelBox& b) {
  const double width = std::min(a[0] + a[2], b[0] + b[2]) - std::max(a[0], b[0]);
  const double height = std::min(a[1] + a[3], b[1] + b[3]) - std::max(a[1], b[1]);
  if (width <= 0 || height <= 0) return 0;
  return width * height / (a[2] * a[3] + b[2] * b[3] - width * height);
}

double ScoreSummary::right_share() const {
  return objects == 0 ? 0 : static_cast<double>(right) / static_cast<double>(objects);
}

std::size_t frame_of_result(std::span<const TrueFrame> truth, const fs::path& folder,
                            const std::string& frame) {
  auto found = std::find_if(truth.begin(), truth.end(), [&](const TrueFrame& t) {
    return is_same_file(t.file, folder, frame);
  });
  if (found == truth.end())
    found = std::find_if(truth.begin(), truth.end(), [&](const TrueFrame& t) {
      return fs::path(t.file).filename() == fs::path(frame).filename();
    });
  return static_cast<std::size_t>(found - truth.begin());
}

ScoredFrame score_frame(const TrueFrame& truth, const FoundFrame* line,
                        const KnownRotations& rotations, std::size_t& falsely_named) {
  ScoredFrame scored{truth.file, line, {}};
  Things things(line == nullptr ? std::span<const FoundObject>() : std::span(line->objects));
  for (const TrueObject& object : truth.objects) {
    ScoredObject entry{object.object, {}, object.visible >= kLeastVisible, false, kNotFound_deg};
    if (const FoundObject* thing = things.take(object)) {
      entry.right = true;
      entry.found = thing->object;
      entry.error_deg = rotations.view_error_deg(object.object, object.view, thing->view);
    }
    scored.objects.push_back(std::move(entry));
  }
  for (std::size_t k = 0; k < truth.objects.size(); ++k)
    if (!scored.objects[k].right)
      scored.objects[k].found = things.name_in_place_of(truth.objects[k]);
  falsely_named += things.count_false();
  things.add_unshown(scored.objects);
  return scored;
}

Score score_results(std::span<const TrueFrame> truth, const fs::path& truth_folder,
                    std::span<const FoundFrame> results, const KnownRotations& rotations) {
  std::vector<const FoundFrame*> line_of(truth.size(), nullptr);
  for (const FoundFrame& line : results) {
    const std::size_t place = frame_of_result(truth, truth_folder, line.frame);
    if (place < truth.size()) line_of[place] = &line;
  }
  Score score;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    score.missing += line_of[k] == nullptr ? 1U : 0U;
    score.frames.push_back(score_frame(truth[k], line_of[k], rotations, score.falsely_named));
  }
  summarise(score);
  return score;
}

}  // namespace aspect
