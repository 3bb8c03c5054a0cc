#include "tools/replay/replay_page.h"

#include <fmt/format.h>
#include <string>
#include <system_error>
#include <utility>

#include "runtime/service/recognition_json.h"
#include "tools/frame_page/frame_page.h"
#include "tools/replay/frame_explainer.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

// Its lines are those of standard output with an explanation each, whether asked for there or not.
class WrittenPage : public ReplayPage {
 public:
  WrittenPage(FramePage page, std::span<const ClassIndex> indexes,
              const RecogniserParameters& parameters)
      : page_(std::move(page)),
        indexes_(indexes),
        explainer_(indexes),
        line_(std::make_unique_for_overwrite<char[]>(kMostLineBytes)) {
    // What is followed in one look is found anew, or not, in the next.
    if (!parameters.tracking.on) explainer_.expect_others(parameters);
  }

  std::optional<Error> add(const CapturedFrame& frame, const Recognition& recognition,
                           const SizedRecogniser& recogniser) override {
    const Frame view = frame.view();
    const std::vector<std::string> explanations = explainer_.explain(view, recognition, recogniser);
    const FrameLabel label = {frame.name, frame.sequence, frame.width_px, frame.height_px};
    const std::size_t length = write_recognition_json(label, recognition, indexes_,
                                                      {line_.get(), kMostLineBytes}, explanations);
    auto line = read_page_line({line_.get(), length}, frame.name);
    if (!line) return Error{line.error()};
    return page_.add(std::move(line).value(),
                     {&view, "", recogniser.cameras(), &recognition, &recogniser.regions()});
  }

  std::optional<Error> add_failed(const CapturedFrame& frame, const std::string& error) override {
    return page_.add_unreadable(frame.name, frame.sequence, error);
  }

  std::optional<Error> finish() override { return page_.finish(); }

 private:
  FramePage page_;
  std::span<const ClassIndex> indexes_;
  FrameExplainer explainer_;
  std::unique_ptr<char[]> line_;
};

std::string title_of(const std::vector<fs::path>& frames) {
  const fs::path& first = frames.front();
  const std::string name = (first.has_filename() ? first : first.parent_path()).filename();
  return frames.size() == 1 ? name : fmt::format("{} and {} more", name, frames.size() - 1);
}

}  // namespace

Result<std::unique_ptr<ReplayPage>> create_replay_page(const ReplayOptions& options,
                                                       std::span<const ClassIndex> indexes,
                                                       const RecogniserParameters& parameters) {
  if (!options.page_folder) return std::unique_ptr<ReplayPage>();
  const fs::path& folder = *options.page_folder;
  PageContents contents{title_of(options.frames), indexes, {}};
  if (options.truth) {
    auto truth = PageTruth::read(*options.truth, options.symmetries);
    if (!truth) return Error{truth.error()};
    contents.truth = std::move(truth).value();
  }
  std::error_code code;
  fs::create_directories(folder, code);
  if (code || !fs::is_directory(folder, code))
    return Error{folder.native() + ": cannot be made a folder" +
                 (code ? ": " + code.message() : std::string()) + "; give another one"};
  auto page = FramePage::create(folder / "index.html", std::move(contents));
  if (!page) return Error{page.error()};
  return std::unique_ptr<ReplayPage>(
      std::make_unique<WrittenPage>(std::move(page).value(), indexes, parameters));
}

}  // namespace aspect
