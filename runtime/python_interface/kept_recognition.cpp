#include "runtime/python_interface/kept_recognition.h"

#include <span>
#include <utility>

namespace aspect {
namespace {

// Where the copy of `all` begins in `kept`, whose room was taken before.
template <typename T>
const T* keep(std::span<const T> all, std::vector<T>& kept) {
  const std::size_t first = kept.size();
  kept.insert(kept.end(), all.begin(), all.end());
  return kept.data() + first;
}

struct Counts {
  std::size_t hypotheses = 0, poses = 0, matches = 0, rivals = 0, chains = 0;
  explicit Counts(const aspect_recognition& seen) {
    for (const aspect_object& object : std::span(seen.objects, seen.object_count)) {
      hypotheses += object.hypothesis_count;
      rivals += object.rival_count;
      for (const aspect_hypothesis& h : std::span(object.hypotheses, object.hypothesis_count)) {
        poses += h.pose != nullptr ? 1U : 0U;
        matches += h.contour_count;
      }
    }
    for (const aspect_contour& contour : std::span(seen.contours, seen.contour_count))
      chains += contour.chain_length;
  }
};

}  // namespace

KeptRecognition::KeptRecognition(const aspect_recognition& seen, std::shared_ptr<const void> names)
    : owner(std::move(names)),
      objects(seen.objects, seen.objects + seen.object_count),
      contours(seen.contours, seen.contours + seen.contour_count),
      cameras(seen.cameras, seen.cameras + seen.camera_count),
      dropped_regions(seen.dropped_regions),
      elapsed_ms(seen.elapsed_ms),
      left_undone(seen.left_undone) {
  const Counts counts(seen);
  hypotheses.reserve(counts.hypotheses);
  poses.reserve(counts.poses);
  matches.reserve(counts.matches);
  rivals.reserve(counts.rivals);
  chains.reserve(counts.chains);
  for (aspect_object& object : objects) {
    const std::size_t first = hypotheses.size();
    object.hypotheses = keep(std::span(object.hypotheses, object.hypothesis_count), hypotheses);
    object.rivals = keep(std::span(object.rivals, object.rival_count), rivals);
    for (aspect_hypothesis& hypothesis : std::span(hypotheses).subspan(first)) {
      if (hypothesis.pose != nullptr) hypothesis.pose = &poses.emplace_back(*hypothesis.pose);
      hypothesis.contours = keep(std::span(hypothesis.contours, hypothesis.contour_count), matches);
    }
  }
  for (aspect_contour& contour : contours)
    contour.chain = keep(std::span(contour.chain, contour.chain_length), chains);
}

}  // namespace aspect
