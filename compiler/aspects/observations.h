// Views and matches of one run: those that the store remembers, and the others computed on all
// threads and kept.
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "compiler/aspects/subdivision.h"

namespace aspect {

using ViewPair = std::pair<VertexId, VertexId>;

class Observations {
 public:
  // Both must outlive it; all that is found goes into `found`.
  Observations(const Workshop& workshop, Subdivision& found);

  // Reads what the store holds.
  Result<Done> remember();

  // Takes the views that are not there yet from these directions, and numbers them as asked.
  struct Wanted {
    VertexId view{};
    Eigen::Vector3d direction;
  };
  Result<Done> observe(const std::vector<Wanted>& wanted);

  // Matches the pairs that were not matched yet; pairs of unequal node counts are passed over. A
  // pair is always matched from the lower view to the higher.
  Result<Done> match(const std::vector<ViewPair>& pairs);

  void complete_statistics();  // of what was found, once all is done

  Progress progress;

 private:
  // Directions as map keys, by their bits.
  using Key = std::array<double, 3>;
  struct KeyHash {
    std::size_t operator()(const Key& direction) const;
  };
  struct Remembered {
    std::unordered_map<Key, ObservedView, KeyHash> views;
    std::unordered_map<Key, std::unordered_map<Key, GraphMatch, KeyHash>, KeyHash> matches;
  };

  static Key key_of(const Eigen::Vector3d& direction);
  bool stopped() const { return workshop_.stop != nullptr && workshop_.stop->load(); }
  void show() const;
  Result<Done> flush_and_stop();
  std::vector<ViewPair> missing(const std::vector<ViewPair>& pairs);
  bool fits(const GraphMatch& match, VertexId from) const;
  bool recall(VertexId from, VertexId to);
  Result<Done> keep_view(VertexId view);
  Result<Done> keep_match(const ViewPair& pair, GraphMatch match);

  const Workshop& workshop_;
  Subdivision& found_;
  Remembered remembered_;
  std::vector<bool> observed_;
  std::unordered_set<std::uint64_t> asked_;
  tbb::enumerable_thread_specific<Observer> observers_;
};

}  // namespace aspect
