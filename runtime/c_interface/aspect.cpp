// No exception leaves a function of this file.
#include "runtime/c_interface/aspect.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <string_view>
#include <utility>

#include "runtime/c_interface/opened_indexes.h"
#include "runtime/c_interface/plain_frame.h"
#include "runtime/c_interface/plain_results.h"
#include "runtime/recognition/sized_recogniser.h"

struct aspect_recogniser {
  explicit aspect_recogniser(aspect::OpenedIndexes opened_indexes)
      : opened(std::move(opened_indexes)), recogniser(opened.indexes, opened.parameters) {
    results.make_room(opened.indexes.size(), opened.parameters.top);
  }

  aspect::OpenedIndexes opened;
  aspect::SizedRecogniser recogniser;
  aspect::PlainResults results;
};

namespace {

void tell(std::string_view text, char* message) {
  if (message == nullptr) return;
  const std::size_t length = std::min<std::size_t>(text.size(), ASPECT_MESSAGE_BYTES - 1);
  std::memcpy(message, text.data(), length);
  message[length] = '\0';
}

}  // namespace

int aspect_api_version(void) {
  return ASPECT_API_VERSION;
}

const char* aspect_version(void) {
  return ASPECT_VERSION;
}

const char* aspect_status_text(aspect_status status) {
  switch (status) {
    case ASPECT_OK:
      return "done";
    case ASPECT_BAD_ARGUMENT:
      return "an argument is no good: a null pointer, a place beyond the last one, or rows shorter "
             "than "
             "their pixels";
    case ASPECT_WRONG_SIZE:
      return "the frame's size is not possible: sides of 1 to 8192 pixels, 16 million in all, even "
             "where pixels are in pairs";
    case ASPECT_WRONG_FORMAT:
      return "the frame's format is none, or of another sensor than the indexes were compiled for";
    case ASPECT_NO_MEMORY:
      return "there is not enough memory for frames of this size";
  }
  return "not a status";
}

aspect_recogniser* aspect_open(const aspect_source* sources, size_t source_count,
                               const char* configuration_file, const char* configuration,
                               char* message) {
  tell("", message);
  if (sources == nullptr && source_count > 0) {
    tell("sources are NULL; give as many as source_count says", message);
    return nullptr;
  }
  try {
    auto opened = aspect::open_indexes({sources, source_count}, configuration_file, configuration);
    if (opened) return std::make_unique<aspect_recogniser>(std::move(opened).value()).release();
    tell(opened.error(), message);
  } catch (const std::bad_alloc&) {
    tell("there is not enough memory to open the indexes", message);
  } catch (const std::exception& failure) {
    tell(failure.what(), message);
  }
  return nullptr;
}

void aspect_close(aspect_recogniser* recogniser) {
  delete recogniser;
}

const char* aspect_warning(const aspect_recogniser* recogniser, size_t n) {
  if (recogniser == nullptr || n >= recogniser->opened.warnings.size()) return nullptr;
  return recogniser->opened.warnings[n].c_str();
}

size_t aspect_known_object_count(const aspect_recogniser* recogniser) {
  return recogniser == nullptr ? 0 : recogniser->opened.indexes.size();
}

aspect_status aspect_known_object_at(const aspect_recogniser* recogniser, size_t n,
                                     aspect_known_object* known) {
  if (known == nullptr || n >= aspect_known_object_count(recogniser)) return ASPECT_BAD_ARGUMENT;
  const aspect::ClassIndex& index = recogniser->opened.indexes[n];
  *known = {};
  known->object = index.object.c_str();
  known->class_count = index.classes.size();
  known->diameter = index.extent.diameter;
  std::copy(index.extent.least.begin(), index.extent.least.end(), known->least);
  std::copy(index.extent.most.begin(), index.extent.most.end(), known->most);
  std::copy(index.extent.centre.begin(), index.extent.centre.end(), known->centre);
  return ASPECT_OK;
}

const char* aspect_verdict_name(aspect_verdict verdict) {
  switch (verdict) {
    case ASPECT_MATCH:
      return "match";
    case ASPECT_AMBIGUOUS:
      return "ambiguous";
    case ASPECT_UNKNOWN:
      return "unknown";
    case ASPECT_NO_VERDICT:
      break;
  }
  return "";
}

aspect_status aspect_recognise(aspect_recogniser* recogniser, const aspect_frame* frame,
                               aspect_recognition* recognition) {
  if (recognition != nullptr) *recognition = {};
  if (recogniser == nullptr || frame == nullptr || recognition == nullptr)
    return ASPECT_BAD_ARGUMENT;
  const auto [status, checked] =
      aspect::checked_frame(*frame, recogniser->opened.parameters.vision.sensor);
  if (status != ASPECT_OK) return status;
  try {
    recogniser->recogniser.make_room(checked.width_px, checked.height_px);
  } catch (const std::bad_alloc&) {
    return ASPECT_NO_MEMORY;
  }
  const int missed = std::clamp(frame->missed, 0, 1'000'000);
  const aspect::Recognition seen = recogniser->recogniser.recognise(checked, 1 + missed);
  *recognition =
      recogniser->results.of(seen, recogniser->opened.indexes, recogniser->recogniser.cameras());
  return ASPECT_OK;
}
