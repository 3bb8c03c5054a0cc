#include <catch2/catch.hpp>

#include "tests/runtime/base/allocation_counter.h"
#include "tests/runtime/c_interface/opened.h"

namespace aspect {

TEST_CASE("frames are recognised without memory from the heap, once one of their size has come") {
  const Opened opened = open("recognition.track = true");
  const OwnedFrame frame = frame_of("cube");
  const aspect_frame given = plain(frame);
  recognised(opened, given);
  const std::uint64_t before = allocation_count();
  std::uint32_t track = 0;
  for (int i = 0; i < 20; ++i) {
    aspect_recognition seen;
    if (aspect_recognise(opened.get(), &given, &seen) == ASPECT_OK && seen.object_count > 0)
      track = seen.objects[0].track;
  }
  CHECK(allocation_count() - before == 0);
  CHECK(track > 0);
}

}  // namespace aspect
