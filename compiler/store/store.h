// The compiler's work on disk, so that a run that was killed resumes where it was: every view that
// was rendered and every match that was computed, in one SQLite file. What a view's or a mapping's
// bytes mean is the caller's business.
//
// A store belongs to one scene and one set of options, and to one process at a time: it is locked
// from open() until the Store is gone. A view is known by the exact bits of its direction.
//
// What is added is committed at the first add half a second or more after the first uncommitted
// one, by flush() and by the destructor. A killed process loses at most that; a power cut may lose
// more, but leaves a store that opens.
//
// Every failure is one line that begins with the file's name. One thread at a time.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "compiler/store/done.h"
#include "runtime/base/result.h"

namespace aspect {

// What the work depends on: other inputs, other store.
struct StoreKey {
  std::string scene_hash;
  std::string options;  // all that change a view or a match, in a form that a human can compare
  std::string compiler = {};  // its version: another one may see other views
  std::string object = {};    // for people; not compared
};

// A model whose views and matches are all in the store.
struct FinishedRun {
  int level = 0, min_level = 0;
  double threshold = 0;
  std::size_t views = 0;
};

struct StoreContents {
  StoreKey key;
  std::size_t views = 0, matches = 0;
  std::vector<FinishedRun> runs;  // by level, min_level, threshold
};

// By its name or its first bytes.
bool is_store(const std::filesystem::path& file);

class Store {
 public:
  using Bytes = std::span<const std::byte>;
  using VisitView = std::function<void(const Eigen::Vector3d& direction, Bytes view)>;
  using VisitMatch = std::function<void(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                        double cost, Bytes mapping)>;

  // Opens the store, or creates it where there is no file or an empty one. Anything else that is
  // not a sound store of this version for this key is refused and left as it is. The folder must
  // exist. Reads the whole file once to find damage.
  static Result<Store> open(const std::filesystem::path& path, const StoreKey& key);

  // Opens a store that is there already, whatever it belongs to.
  static Result<Store> open_existing(const std::filesystem::path& path);

  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;
  ~Store();  // commits as flush() does, but cannot say if that fails

  // Visit all that was added, uncommitted or not: views in order of their first add, matches in
  // order of their views. The bytes live until the visit returns; a visit must not add.
  Result<Done> each_view(const VisitView& visit) const;
  Result<Done> each_match(const VisitMatch& visit) const;

  // What is there already is replaced.
  Result<Done> add_view(const Eigen::Vector3d& direction, Bytes view);

  // Both views must be there, and differ. There is one match for two views, whichever of them is
  // named first; each_match names them as the last add did, since a mapping has a direction.
  Result<Done> add_match(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double cost,
                         Bytes mapping);

  Result<Done> add_finished_run(const FinishedRun& run);  // and commits

  // Text kept under a name, for whoever takes the store up later; empty where there is none.
  Result<Done> set_note(const std::string& name, const std::string& text);
  Result<std::string> note(const std::string& name) const;

  Result<Done> flush();

  Result<StoreContents> contents() const;

 private:
  struct State;
  explicit Store(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

}  // namespace aspect
