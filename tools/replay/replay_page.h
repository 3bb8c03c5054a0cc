// The page that --html asks for.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "runtime/base/result.h"
#include "runtime/capture/frame_source.h"
#include "runtime/recognition/sized_recogniser.h"
#include "tools/replay/replay_options.h"

namespace aspect {

class ReplayPage {
 public:
  virtual ~ReplayPage() = default;

  // A frame that `recogniser` has just seen. The first error is the end of the page.
  [[nodiscard]] virtual std::optional<Error> add(const CapturedFrame& frame,
                                                 const Recognition& recognition,
                                                 const SizedRecogniser& recogniser) = 0;
  // One that could not be had.
  [[nodiscard]] virtual std::optional<Error> add_failed(const CapturedFrame& frame,
                                                        const std::string& error) = 0;
  [[nodiscard]] virtual std::optional<Error> finish() = 0;
};

// Makes the folder; null where no page is asked for. `indexes` must outlive it.
Result<std::unique_ptr<ReplayPage>> create_replay_page(const ReplayOptions& options,
                                                       std::span<const ClassIndex> indexes,
                                                       const RecogniserParameters& parameters);

}  // namespace aspect
