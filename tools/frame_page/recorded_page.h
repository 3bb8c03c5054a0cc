// The page of frames that were recognised before: from the lines that aspect-replay wrote.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "runtime/base/result.h"
#include "runtime/recognition/recogniser.h"
#include "tools/frame_page/page_truth.h"

namespace aspect {

struct RecordedPage {
  std::filesystem::path lines;  // a JSON object a line, with explanations or without
  std::filesystem::path page;   // the file to write
  // Of the objects: with them the page draws their models. May be empty.
  std::span<const ClassIndex> indexes;
  std::optional<CalibratedCamera> camera;  // nothing: the indexes' own fields of view
  std::optional<PageTruth> truth;
  // Before each frame: how many there were, and its name. May be empty.
  std::function<void(std::uint64_t, std::string_view)> progress;
};

struct RecordedPageCounts {
  std::uint64_t frames = 0, without_picture = 0;
};

// Pictures are looked for where the lines name them, then from the folder of the lines' file; a
// frame whose picture is gone, or another one now, is there without it. A line that is none of
// aspect-replay's is an error that names file and line, and no page is written.
Result<RecordedPageCounts> write_recorded_page(RecordedPage recorded);

}  // namespace aspect
