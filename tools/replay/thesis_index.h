// What was recognised in a frame in the thesis's format of results, .index: see pose_file.h.
#pragma once

#include <string>
#include <string_view>

#include "runtime/recognition/recogniser.h"

namespace aspect {

// Ranks as the thesis does (3.5.1): all classes, by their score alone. Of an index with more than
// the recogniser compares only those that match almost as many contours as the best.
void rank_as_thesis(const ClassIndex& index, RecogniserParameters& parameters);

// Of a frame ranked so: a picture for each object seen, the first with the frame's name, the others
// with :2, :3 and so on behind it; one without proposals where nothing was. Classes count from 1,
// as in the .class that aspect-export writes; regions of the picture have the numbers that they
// have in the lines of JSON.
std::string thesis_index_text(std::string_view frame, const Recognition& recognition,
                              const ClassIndex& index);

}  // namespace aspect
