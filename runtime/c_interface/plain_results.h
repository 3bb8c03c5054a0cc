// A Recognition as the plain structs of aspect.h.
#pragma once

#include <span>
#include <vector>

#include "runtime/c_interface/aspect.h"
#include "runtime/recognition/recogniser.h"

namespace aspect {

class PlainResults {
 public:
  // Takes room for the results of any frame, `top` hypotheses an object; may throw
  // std::bad_alloc. 0.5 MB for 10.
  void make_room(std::size_t indexes, int top);

  // Allocates nothing. The result lives until the next call, and no longer than what it points to.
  aspect_recognition of(const Recognition& recognition, std::span<const ClassIndex> indexes,
                        std::span<const CameraModel> cameras) noexcept;

 private:
  void add(const SeenObject& object, std::span<const ClassIndex> indexes);
  void add(const Hypothesis& hypothesis, std::span<const ClassIndex> indexes);
  void add(const Contour& contour);

  std::vector<aspect_object> objects_;
  std::vector<aspect_hypothesis> hypotheses_;
  std::vector<aspect_pose> poses_;
  std::vector<aspect_contour_match> matches_;
  std::vector<aspect_contour> contours_;
  std::vector<aspect_camera> cameras_;
};

}  // namespace aspect
