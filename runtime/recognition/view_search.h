// From classes to views: the key views of each class on the shortlist are fitted to what is seen,
// and the best ones say from where the object is seen, how it is turned and in what light.
#pragma once

#include <array>
#include <span>

#include "runtime/base/deadline.h"
#include "runtime/recognition/class_index.h"
#include "runtime/recognition/hypothesis.h"
#include "runtime/recognition/view_fit.h"

namespace aspect {

class ViewSearch {
 public:
  // `indexes` must outlive the search.
  void prepare(std::span<const ClassIndex> indexes) { indexes_ = indexes; }

  // The first `count` hypotheses of `room` say what their classes cost at the very least, in
  // ascending order. Scores each by its class's best key view, as long as it may fit about as well
  // as the best; the others are taken away. Behind come, as far as there is room, second views of
  // the same classes, seen from elsewhere, that fit about as well. Returns how many there are then.
  // What the deadline leaves no time for has score 0.
  std::size_t run(std::span<const ContourFeature> seen, std::span<Hypothesis> room,
                  std::size_t count, const Deadline& deadline = {});

 private:
  static constexpr std::size_t kMostFitted = 512;  // key views of a class

  // A class's key views that were fitted, and what they cost.
  struct Fitted {
    std::array<const KeyView*, kMostFitted> views{};
    std::array<float, kMostFitted> costs{};
    std::size_t count = 0;

    void add(const KeyView& view, float cost);
    float cost_nearest(const KeyView& view, std::size_t among) const;
    Vector3 mean_about(const KeyView& best, float best_cost) const;
    const KeyView* elsewhere(std::span<const KeyView* const> taken, float most_cost) const;
  };
  struct Best {
    ViewFit fit;
    const KeyView* view = nullptr;  // null: none was fitted
  };

  Best fit_class(const ClassIndex& index, const AspectClass& aspect, float least_cost);
  void raise_neighbours(std::span<Hypothesis> list) const;

  std::span<const ClassIndex> indexes_;
  ViewFitter fitter_;
  Fitted fitted_;
};

}  // namespace aspect
