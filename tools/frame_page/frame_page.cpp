#include "tools/frame_page/frame_page.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "runtime/recognition/model_lines.h"
#include "tools/frame_page/page_block.h"
#include "tools/frame_page/page_drawing.h"
#include "tools/frame_page/page_model.h"
#include "tools/frame_page/page_picture.h"
#include "tools/frame_page/page_source.h"

namespace aspect {

FramePage::FramePage(StreamedFile file, PageContents contents)
    : file_(std::move(file)), contents_(std::move(contents)) {}

Result<FramePage> FramePage::create(const std::filesystem::path& file, PageContents contents) {
  auto streamed = StreamedFile::create(file);
  if (!streamed) return Error{streamed.error()};
  FramePage page(std::move(streamed).value(), std::move(contents));
  std::string head(kPageHead);
  head += json_block(
      "data-batch", {{"title", page.contents_.title}, {"truth", page.contents_.truth.has_value()}});
  for (const ClassIndex& index : page.contents_.indexes)
    head += json_block("data-model", model_json(index));
  if (auto error = page.file_.write(head)) return *error;
  return page;
}

namespace {

// How far a hypothesis without a pose is turned against its view, which lines do not tell.
void add_rolls(const Recognition& recognition, nlohmann::json& objects) {
  for (std::size_t k = 0; k < objects.size() && k < recognition.objects.size(); ++k) {
    nlohmann::json& listed = objects[k]["hypotheses"];
    const auto hypotheses = recognition.objects[k].hypotheses;
    for (std::size_t i = 0; i < listed.size() && i < hypotheses.size(); ++i)
      if (hypotheses[i].pose == nullptr)
        listed[i]["roll"] = with_digits(static_cast<double>(hypotheses[i].roll_rad), 3);
  }
}

}  // namespace

std::optional<Error> FramePage::add(PageLine line, const PagePicture& picture) {
  if (const std::string edges = edges_of(line, picture.cameras); !edges.empty())
    line.summary["edges"] = edges;
  if (!picture.note.empty()) line.summary["note"] = picture.note;
  if (contents_.truth) line.summary["truth"] = contents_.truth->score(line.found);
  if (picture.recognition != nullptr) add_rolls(*picture.recognition, line.details["objects"]);
  if (picture.recognition != nullptr && picture.regions != nullptr)
    line.details["contours"] = contours_json(picture.recognition->graph, *picture.regions);
  const std::string uri = picture.frame == nullptr ? "" : picture_uri(*picture.frame);
  return file_.write(json_block("data-frame", line.summary) +
                     json_block("data-details", line.details) + text_block("data-picture", uri));
}

std::optional<Error> FramePage::add_unreadable(const std::string& name, std::uint64_t sequence,
                                               const std::string& error) {
  nlohmann::json summary = {
      {"name", name}, {"n", sequence}, {"error", error}, {"objects", nlohmann::json::array()}};
  if (contents_.truth) summary["truth"] = contents_.truth->score_unreadable(name);
  return file_.write(json_block("data-frame", summary) +
                     json_block("data-details", {{"objects", nlohmann::json::array()}}) +
                     text_block("data-picture", ""));
}

std::optional<Error> FramePage::finish() {
  nlohmann::json end = nlohmann::json::object();
  if (contents_.truth) end["missing"] = contents_.truth->missing();
  if (auto error = file_.write(json_block("data-end", end) + std::string(kPageTail))) return error;
  return file_.finish();
}

std::string FramePage::edges_of(const PageLine& line, std::span<const CameraModel> cameras) const {
  std::string path;
  for (const NamedPose& named : line.poses) {
    const auto& indexes = contents_.indexes;
    const auto own = std::find_if(indexes.begin(), indexes.end(), [&](const ClassIndex& index) {
      return index.object == named.object;
    });
    const auto place = static_cast<std::size_t>(own - indexes.begin());
    if (place >= cameras.size()) continue;
    path +=
        path_of(edges_seen(own->model, named.pose, cameras[place], line.width_px, line.height_px));
  }
  return path;
}

}  // namespace aspect
