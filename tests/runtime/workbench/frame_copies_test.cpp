#include <catch2/catch.hpp>
#include <numeric>
#include <thread>

#include "runtime/workbench/frame_slot.h"

namespace aspect {
namespace {

// Rows and planes with gaps between them, in which there is something else.
struct Gapped {
  static constexpr int kWidth_px = 6, kHeight_px = 4;
  PixelFormat format;
  std::vector<std::uint8_t> memory = std::vector<std::uint8_t>(400, 0xEE);

  explicit Gapped(PixelFormat f) : format(f) {
    std::uint8_t next = 0;
    const auto fill = [&](std::size_t start, std::size_t rows, std::size_t bytes) {
      for (std::size_t y = 0; y < rows; ++y)
        for (std::size_t x = 0; x < bytes; ++x) memory[start + 40 * y + x] = next++;
    };
    fill(0, kHeight_px, static_cast<std::size_t>(kWidth_px * bytes_per_pixel(format)));
    if (has_chroma_plane(format)) fill(200, kHeight_px / 2, kWidth_px);
  }
  Frame frame() const {
    return {memory.data(), kWidth_px, kHeight_px, 40, format, memory.data() + 200, 40, {}};
  }
};

}  // namespace

TEST_CASE("a copy has every pixel and no gaps, in every kind of format") {
  for (const PixelFormat format : {PixelFormat::grey8, PixelFormat::bgr8, PixelFormat::rgbx8,
                                   PixelFormat::yuyv8, PixelFormat::nv12, PixelFormat::depth16}) {
    INFO(static_cast<int>(format));
    const Gapped gapped(format);
    FrameCopy copy;
    CHECK_FALSE(copy.copy(gapped.frame()));
    copy.make_room(FrameCopy::bytes_of(gapped.frame()));
    REQUIRE(copy.copy(gapped.frame()));
    std::vector<std::uint8_t> expected(copy.bytes().size());
    std::iota(expected.begin(), expected.end(), std::uint8_t{0});
    CHECK(std::equal(expected.begin(), expected.end(), copy.bytes().begin()));
    // It stays whole when its owner moves.
    const FrameCopy moved = std::move(copy);
    CHECK(moved.frame().data == moved.bytes().data());
    CHECK(moved.frame().width_px == Gapped::kWidth_px);
    if (format == PixelFormat::nv12)
      CHECK(moved.frame().chroma == moved.bytes().data() + Gapped::kWidth_px * Gapped::kHeight_px);
  }
}

TEST_CASE("a slot has the newest frame, and only for who looks") {
  Gapped gapped(PixelFormat::grey8);
  FrameSlot slot;
  FrameCopy copy;
  std::uint64_t line = 0;
  CHECK_FALSE(slot.wanted());
  CHECK_FALSE(slot.take(copy, line));
  CHECK(slot.wanted());
  // The first frame tells how much memory it needs.
  slot.show(gapped.frame(), {}, {}, 1);
  CHECK_FALSE(slot.take(copy, line));
  for (std::uint64_t number = 2; number < 5; ++number) {
    gapped.memory[0] = static_cast<std::uint8_t>(100 + number);
    slot.show(gapped.frame(), {}, {}, number);
  }
  REQUIRE(slot.take(copy, line));
  CHECK(line == 4);
  CHECK(copy.bytes()[0] == 104);
  CHECK_FALSE(slot.take(copy, line));
  slot.show(gapped.frame(), {}, {}, 5);
  slot.empty();
  CHECK_FALSE(slot.take(copy, line));
}

TEST_CASE("frames that are shown while others are taken come in their order") {
  const Gapped gapped(PixelFormat::grey8);
  FrameSlot slot;
  std::atomic<bool> done{false};
  std::thread taker([&] {
    FrameCopy copy;
    std::uint64_t line = 0, last = 0;
    while (!done)
      if (slot.take(copy, line)) {
        CHECK(line > last);
        last = line;
      }
  });
  for (std::uint64_t number = 1; number < 20'000; ++number)
    slot.show(gapped.frame(), {}, {}, number);
  done = true;
  taker.join();
}

}  // namespace aspect
