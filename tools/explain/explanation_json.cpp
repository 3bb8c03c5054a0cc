#include <nlohmann/json.hpp>

#include "tools/explain/explanation.h"

namespace aspect {
namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

Json share_json(const Share& share) {
  return {{"share", share.share}, {"low", share.low}, {"high", share.high}};
}

Json accuracy_json(const Accuracy& a) {
  return {{"rank_1", share_json(a.rank_1)},
          {"rank_5", share_json(a.rank_5)},
          {"rank_10", share_json(a.rank_10)},
          {"within_20_deg", share_json(a.within_20_deg)}};
}

Json spots_json(const std::vector<Spot>& spots) {
  Json list = Json::array();
  for (const Spot& spot : spots) {
    list.push_back({{"centre", vector_json(spot.centre)},
                    {"share", spot.share},
                    {"radius_deg", spot.radius_deg}});
    if (!spot.reason.empty()) list.back()["reason"] = spot.reason;
  }
  return list;
}

Json face_json(const Face& face) {
  Json json{{"surfaces", face.primitives}, {"colour", vector_json(face.colour)}};
  if (!face.name.empty()) json["name"] = face.name;
  return json;
}

Json faces_json(const std::vector<Face>& faces) {
  Json list = Json::array();
  for (const Face& face : faces) list.push_back(face_json(face));
  return list;
}

Json confusions_json(const Explanation& e) {
  Json list = Json::array();
  for (const AspectConfusion& c : e.confusions)
    list.push_back({{"aspect", c.aspect},
                    {"taken_for", c.taken_for},
                    {"views", c.views},
                    {"seen_from", vector_json(c.seen_from)},
                    {"believed_from", vector_json(c.believed_from)},
                    {"faces", faces_json(c.faces)},
                    {"faces_believed", faces_json(c.faces_believed)}});
  return list;
}

Json face_confusions_json(const Explanation& e) {
  Json list = Json::array();
  for (const FaceConfusion& c : e.face_confusions)
    list.push_back({{"face", face_json(e.faces[c.face])},
                    {"taken_for", face_json(e.faces[c.taken_for])},
                    {"views", c.views},
                    {"separation", c.separation}});
  return list;
}

void add_presence(const ColourPresence& presence, Commonness commonness, Json& json) {
  json["pixels"] = presence.pixels;
  json["pictures"] = presence.pictures;
  json["commonness"] = name_of(commonness);
}

Json backgrounds_json(const BackgroundColours& backgrounds) {
  Json colours = Json::array();
  for (const BackgroundColour& c : backgrounds.colours) {
    Json json = face_json(c.face);
    add_presence(c.presence, c.commonness, json);
    if (c.better) {
      const PaletteColour& paint = c.better->paint;
      Json& better = json["better"] = {{"colour", vector_json(paint.colour)},
                                       {"colour_name", paint.name},
                                       {"separation", c.better->separation}};
      add_presence(paint.presence, paint.commonness, better);
    }
    colours.push_back(std::move(json));
  }
  return {{"folder", backgrounds.folder}, {"pictures", backgrounds.pictures}, {"colours", colours}};
}

Json cure_json(const Explanation& e) {
  Json changes = Json::array();
  for (const ColourChange& c : e.cure.changes)
    changes.push_back({{"face", face_json(e.faces[c.face])},
                       {"colour", vector_json(c.colour)},
                       {"colour_name", c.colour_name},
                       {"separation", c.separation}});
  return {{"changes", changes},
          {"level", e.cure.level},
          {"wrong_before", e.cure.wrong_before},
          {"wrong_after", e.cure.wrong_after},
          {"cured", e.cure.cured},
          {"accuracy", accuracy_json(e.cure.after)}};
}

}  // namespace

std::string explanation_json(const Explanation& e) {
  Json json{{"object", e.object},
            {"store", e.store},
            {"views", e.views},
            {"aspects", e.aspects},
            {"symmetries", e.symmetries},
            {"symmetry_axes", e.symmetry_axes},
            {"accuracy", accuracy_json(e.accuracy)},
            {"neighbour_views", e.neighbour_views},
            {"wrong_views", e.wrong_views},
            {"blind_share", e.blind_share},
            {"blind_spots", spots_json(e.blind_spots)},
            {"failing_spots", spots_json(e.failing_spots)},
            {"confusions", confusions_json(e)},
            {"face_confusions", face_confusions_json(e)}};
  if (e.merged_colours) json["merged_colours"] = *e.merged_colours;
  if (e.crowded)
    json["crowded_colours"] = {{"colours", e.crowded->colours},
                               {"share", e.crowded->share},
                               {"merge_colours", e.crowded->enough}};
  if (e.backgrounds) json["backgrounds"] = backgrounds_json(*e.backgrounds);
  if (!e.cure.changes.empty()) json["cure"] = cure_json(e);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace aspect
