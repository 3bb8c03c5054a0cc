// A recogniser with its memory, which grows where a larger frame comes.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "runtime/recognition/recogniser.h"

namespace aspect {

class SizedRecogniser {
 public:
  // `indexes` must outlive it.
  SizedRecogniser(std::span<const ClassIndex> indexes, const RecogniserParameters& parameters)
      : indexes_(indexes), parameters_(parameters) {}

  // Before recognise(): has room for such a frame, or throws std::bad_alloc.
  void make_room(int width_px, int height_px);
  Recognition recognise(const Frame& frame) noexcept { return recogniser_.recognise(frame); }
  const RegionMap& regions() const { return recogniser_.regions(); }

 private:
  // Arenas align to lines, counted from the beginning of their storage.
  struct alignas(64) Line {
    std::array<std::byte, 64> bytes;
  };

  std::span<const ClassIndex> indexes_;
  RecogniserParameters parameters_;
  int width_px_ = 0, height_px_ = 0;
  std::vector<Line> storage_;
  Recogniser recogniser_;
};

}  // namespace aspect
