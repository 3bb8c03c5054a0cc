// A recogniser with its memory, which grows where a larger frame comes.
#pragma once

#include <span>

#include "runtime/base/planned_memory.h"
#include "runtime/recognition/recogniser.h"

namespace aspect {

class SizedRecogniser {
 public:
  // `indexes` must outlive it.
  SizedRecogniser(std::span<const ClassIndex> indexes, const RecogniserParameters& parameters)
      : indexes_(indexes), parameters_(parameters) {}

  // Before recognise(): has room for such a frame, or throws std::bad_alloc.
  void make_room(int width_px, int height_px);
  // See Recogniser::cut_with. Where that is not enough, all memory is taken anew, and what was
  // followed is forgotten; throws std::bad_alloc.
  void cut_with(const VisionParameters& vision);
  Recognition recognise(const Frame& frame, int steps = 1) noexcept {
    return recogniser_.recognise(frame, steps);
  }
  const RegionMap& regions() const { return recogniser_.regions(); }
  const Planes& colours() const { return recogniser_.colours(); }
  std::span<const CameraModel> cameras() const { return recogniser_.cameras(); }

 private:
  std::span<const ClassIndex> indexes_;
  RecogniserParameters parameters_;
  int width_px_ = 0, height_px_ = 0;
  PlannedMemory memory_;
  Recogniser recogniser_;
};

}  // namespace aspect
