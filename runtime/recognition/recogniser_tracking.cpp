// What is followed from frame to frame takes its place among what a frame shows.
#include <algorithm>

#include "runtime/recognition/recogniser.h"

namespace aspect {
namespace {

Box common(const Box& a, const Box& b) {
  const int x = std::max(a.x, b.x), y = std::max(a.y, b.y);
  const int width = std::min(a.x + a.width, b.x + b.width) - x,
            height = std::min(a.y + a.height, b.y + b.height) - y;
  return width > 0 && height > 0 ? Box{x, y, width, height} : Box{};
}

// More of either than not.
bool share_much(const Box& a, const Box& b) {
  const Box both = common(a, b);
  return 2 * both.width * both.height > std::max(a.width * a.height, b.width * b.height);
}

}  // namespace

// The tracked objects alone, each looked for in its part of the frame; nothing where all of the
// frame must be searched.
std::optional<Recognition> Recogniser::follow(const Frame& frame) {
  if (tracker_.is_search_due()) return std::nullopt;
  Recognition recognition;
  VisionParameters vision = parameters_.vision;
  const Box allowed = part_looked_at(frame, vision);
  for (std::size_t k = 0; k < tracker_.boxes().size(); ++k) {
    if (deadline_.is_over()) {
      tracker_.leave(k);
      continue;
    }
    vision.region_of_interest = common(tracker_.boxes()[k], allowed);
    if (vision.region_of_interest.empty() || !vision_.look(frame, vision)) continue;
    recognition.stages.convert += vision_.times().convert;
    recognition.stages.enhance += vision_.times().enhance;
    const auto start = std::chrono::steady_clock::now();
    tracker_.follow(vision_.colours(), vision.region_of_interest, k);
    recognition.stages.pose += std::chrono::steady_clock::now() - start;
  }
  tracker_.finish();
  if (tracker_.is_search_due()) {
    if (!deadline_.is_over()) return std::nullopt;
    left_undone_.searches = 1;
  }
  left_undone_.tracks = tracker_.left_count();
  recognition.objects = objects_.first(add_tracks(0));
  return recognition;
}

// Before the search, which may take all the time that there is.
void Recogniser::begin_track_search(const Frame& frame) {
  const auto start = std::chrono::steady_clock::now();
  tracker_.begin_search(vision_.colours(), part_looked_at(frame, parameters_.vision));
  left_undone_.tracks = tracker_.left_count();
  pose_time_ += std::chrono::steady_clock::now() - start;
}

// What a search has found gets its number; where a track knows better where it is, the track's word
// counts, and what was seen in its place is left out.
std::size_t Recogniser::join_tracks(std::size_t objects) {
  const auto start = std::chrono::steady_clock::now();
  const auto is_left_out = [&](SeenObject& object) {
    if (object.judgement.verdict != Verdict::match || object.hypotheses.front().pose == nullptr)
      return false;
    const Hypothesis& best = object.hypotheses.front();
    SceneAgreement agreement;
    agreement.score = static_cast<float>(best.score);
    agreement.box = object.box;
    const Tracker::Claimed claimed =
        tracker_.claim({best.index, best.pose->refined, agreement, best.start.light,
                        object.judgement.probability});
    if (claimed.claim == Tracker::Claim::found) object.track = claimed.track->number;
    return claimed.claim == Tracker::Claim::followed ||
           (claimed.claim == Tracker::Claim::refused && claimed.track != nullptr);
  };
  const auto all = objects_.first(objects);
  // In order, each once.
  std::size_t kept = 0;
  for (SeenObject& object : all)
    if (!is_left_out(object)) objects_[kept++] = object;
  tracker_.finish_search();
  kept = add_tracks(kept);
  pose_time_ += std::chrono::steady_clock::now() - start;
  return kept;
}

// Those that are followed, in place of what was seen there and could not be named.
std::size_t Recogniser::add_tracks(std::size_t objects) {
  for (const Track& track : tracker_.tracks()) {
    const auto before = objects_.first(objects);
    const auto is_it = [&](const SeenObject& object) { return object.track == track.number; };
    if (!track.is_followed || std::any_of(before.begin(), before.end(), is_it)) continue;
    const auto left = std::remove_if(before.begin(), before.end(), [&](const SeenObject& object) {
      return object.track == 0 && object.judgement.verdict != Verdict::match &&
             share_much(object.box, track.agreement.box);
    });
    objects = static_cast<std::size_t>(left - before.begin());
    // The smallest of those that are nothing known makes room.
    for (std::size_t k = objects; objects >= kMaxBlobs && k-- > 0;)
      if (objects_[k].judgement.verdict != Verdict::match) {
        std::move(objects_.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                  objects_.begin() + static_cast<std::ptrdiff_t>(objects),
                  objects_.begin() + static_cast<std::ptrdiff_t>(k));
        --objects;
      }
    if (objects >= kMaxBlobs || hypothesis_count_ == hypotheses_.size() ||
        pose_count_ == poses_.size())
      break;
    objects_[objects++] = seen_track(track);
  }
  return objects;
}

SeenObject Recogniser::seen_track(const Track& track) {
  SeenObject object = drawn_match({track.index, 0, 0, track.refined, track.agreement},
                                  track.probability, blob_at(track.agreement.box));
  Hypothesis& hypothesis = hypotheses_[hypothesis_count_ - 1];
  hypothesis.start.light = track.light;
  pose_search_.name(hypothesis, *hypothesis.pose);
  object.track = track.number;
  return object;
}

}  // namespace aspect
