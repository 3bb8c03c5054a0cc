// A recogniser with the memory that it needs.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "runtime/recognition/recogniser.h"

namespace aspect {

class OwnedRecogniser {
 public:
  // `indexes` must outlive it.
  OwnedRecogniser(std::span<const ClassIndex> indexes, const RecogniserParameters& parameters,
                  int width_px, int height_px)
      : recogniser_(std::make_unique<Recogniser>()) {
    Arena counting;
    recogniser_->prepare(counting, indexes, parameters, width_px, height_px);
    arena_bytes_ = counting.used_bytes();
    storage_.resize(arena_bytes_ + 64);
    void* first = storage_.data();
    std::size_t space = storage_.size();
    std::align(64, arena_bytes_, first, space);
    // Exactly what was counted: a byte more asked for aborts.
    Arena arena({static_cast<std::byte*>(first), arena_bytes_});
    recogniser_->prepare(arena, indexes, parameters, width_px, height_px);
    arena.seal();
  }

  Recognition recognise(const Frame& frame) { return recogniser_->recognise(frame); }
  std::size_t arena_bytes() const { return arena_bytes_; }

 private:
  std::unique_ptr<Recogniser> recogniser_;
  std::size_t arena_bytes_ = 0;
  std::vector<std::byte> storage_;
};

}  // namespace aspect
