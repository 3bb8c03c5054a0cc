// A recogniser with the memory that it needs.
#pragma once

#include <memory>
#include <span>

#include "runtime/base/planned_memory.h"
#include "runtime/recognition/recogniser.h"

namespace aspect {

class OwnedRecogniser {
 public:
  // `indexes` must outlive it.
  OwnedRecogniser(std::span<const ClassIndex> indexes, const RecogniserParameters& parameters,
                  int width_px, int height_px)
      : recogniser_(std::make_unique<Recogniser>()) {
    memory_.plan([&](Arena& arena) {
      recogniser_->prepare(arena, indexes, parameters, width_px, height_px);
    });
  }

  Recognition recognise(const Frame& frame, int steps = 1) {
    return recogniser_->recognise(frame, steps);
  }
  bool cut_with(const VisionParameters& vision) { return recogniser_->cut_with(vision); }
  std::size_t arena_bytes() const { return memory_.bytes(); }

 private:
  std::unique_ptr<Recogniser> recogniser_;
  PlannedMemory memory_;
};

}  // namespace aspect
