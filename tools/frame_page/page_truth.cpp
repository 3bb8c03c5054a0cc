#include "tools/frame_page/page_truth.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tools/frame_page/page_block.h"
#include "tools/score/scoring.h"

namespace aspect {

Result<PageTruth> PageTruth::read(const std::filesystem::path& truth,
                                  const std::optional<std::filesystem::path>& symmetries) {
  auto frames = read_truth(truth);
  if (!frames) return Error{frames.error()};
  PageTruth table;
  table.folder_ = truth.parent_path();
  table.frames_ = std::move(frames).value();
  table.taken_.assign(table.frames_.size(), false);
  if (!symmetries) return table;
  auto rotations = KnownRotations::read(*symmetries);
  if (!rotations) return Error{rotations.error()};
  table.rotations_ = std::move(rotations).value();
  return table;
}

nlohmann::json PageTruth::score(const FoundFrame& found) {
  return score(found.frame, &found);
}

nlohmann::json PageTruth::score_unreadable(const std::string& frame) {
  return score(frame, nullptr);
}

nlohmann::json PageTruth::score(const std::string& frame, const FoundFrame* found) {
  const std::size_t place = frame_of_result(frames_, folder_, frame);
  if (place == frames_.size()) return nullptr;
  taken_[place] = true;
  std::size_t falsely_named = 0;
  const ScoredFrame scored = score_frame(frames_[place], found, rotations_, falsely_named);
  nlohmann::json objects = nlohmann::json::array();
  for (std::size_t k = 0; k < scored.objects.size(); ++k) {
    const ScoredObject& object = scored.objects[k];
    nlohmann::json entry = {{"counts", object.counts}, {"right", object.right}};
    if (!object.truth.empty()) entry["truth"] = object.truth;
    if (!object.found.empty()) entry["found"] = object.found;
    if (object.right) entry["deg"] = with_digits(object.error_deg, 3);
    if (k < frames_[place].objects.size())
      for (const double part : frames_[place].objects[k].view)
        entry["view"].push_back(with_digits(part, 4));
    objects.push_back(std::move(entry));
  }
  return objects;
}

std::size_t PageTruth::missing() const {
  return static_cast<std::size_t>(std::count(taken_.begin(), taken_.end(), false));
}

}  // namespace aspect
