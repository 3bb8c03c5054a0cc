// A page for a batch of frames: one file that any browser shows without a network. It grows frame
// by frame, so that a batch may be larger than memory, and is there when it is finished.
//
// What was recognised is in it as aspect-replay's own lines say it, shortened; what is drawn over
// the pictures, as paths; the objects' models, so that the page draws views of them itself: 24 KB a
// frame of photographs, where pictures of ten classes each would take ten times as much.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "runtime/base/result.h"
#include "runtime/recognition/recogniser.h"
#include "tools/frame_page/page_line.h"
#include "tools/frame_page/page_truth.h"
#include "tools/frame_page/streamed_file.h"

namespace aspect {

struct PageContents {
  std::string title;                    // what the frames are: a folder, a file
  std::span<const ClassIndex> indexes;  // may be empty: no model is drawn then
  std::optional<PageTruth> truth;
};

// What there is of a frame beyond its line.
struct PagePicture {
  const Frame* frame = nullptr;  // null: left out,
  std::string note;              // and why
  // How each index's objects were looked for; empty: their edges are not drawn.
  std::span<const CameraModel> cameras;
  // Of the recogniser that has just seen it; null: there are no contours.
  const Recognition* recognition = nullptr;
  const RegionMap* regions = nullptr;
};

class FramePage {
 public:
  // `file` must be in a folder that is there.
  static Result<FramePage> create(const std::filesystem::path& file, PageContents contents);

  [[nodiscard]] std::optional<Error> add(PageLine line, const PagePicture& picture);
  // A frame that could not be read, and why.
  [[nodiscard]] std::optional<Error> add_unreadable(const std::string& name, std::uint64_t sequence,
                                                    const std::string& error);
  // Nothing is added after it.
  [[nodiscard]] std::optional<Error> finish();

 private:
  FramePage(StreamedFile file, PageContents contents);
  std::string edges_of(const PageLine& line, std::span<const CameraModel> cameras) const;

  StreamedFile file_;
  PageContents contents_;
};

}  // namespace aspect
