#include "tools/explain/trials.h"

#include <algorithm>
#include <map>
#include <set>

#include "tools/eval/random_directions.h"
#include "tools/eval/test_bench.h"

namespace aspect {
namespace {

constexpr double kNotable = 0.2;  // share of a region's pixels

// The faces that make up a good part of every region, by label.
std::vector<std::vector<std::size_t>> faces_of_regions(const TestBench& bench, const Faces& faces) {
  const RegionMap& map = bench.regions();
  const Picture& picture = bench.picture();
  std::vector<std::map<std::size_t, double>> pixels(map.regions.size() + 1);
  std::vector<double> total(pixels.size(), 0);
  for (const Run& run : map.runs) {
    if (run.label == 0) continue;
    const std::size_t row =
        static_cast<std::size_t>(run.row) * static_cast<std::size_t>(picture.width_px);
    for (int x = run.begin; x < run.end; ++x) {
      const std::uint16_t id = picture.surface[row + static_cast<std::size_t>(x)];
      if (id == 0 || id >= faces.face_of.size()) continue;
      pixels[run.label][faces.face_of[id]] += 1;
      total[run.label] += 1;
    }
  }
  std::vector<std::vector<std::size_t>> notable(pixels.size());
  for (std::size_t label = 0; label < pixels.size(); ++label)
    for (const auto& [face, count] : pixels[label])
      if (count >= kNotable * total[label]) notable[label].push_back(face);
  return notable;
}

std::vector<std::size_t> faces_of_contour(const ClassIndex& index, const ClassContour& contour,
                                          const Faces& faces) {
  std::set<std::size_t> found;
  for (const std::uint16_t id : ClassIndex::part(index.surfaces, contour.surfaces))
    if (id > 0 && id < faces.face_of.size()) found.insert(faces.face_of[id]);
  return {found.begin(), found.end()};
}

std::vector<MatchedFaces> matched_faces(const EvaluatedObject& object, const Faces& faces,
                                        const TestBench& bench, const Recognition& recognition,
                                        const Hypothesis& answer) {
  const auto regions = faces_of_regions(bench, faces);
  const AspectClass& aspect = object.index.classes[answer.class_id];
  const auto contours = ClassIndex::part(object.index.class_contours, aspect.contours);
  std::vector<MatchedFaces> matched;
  for (const ContourMatch& match : answer.contours)
    matched.push_back({regions[recognition.graph.contours[match.contour].region],
                       faces_of_contour(object.index, contours[match.name], faces)});
  return matched;
}

}  // namespace

std::vector<Trial> run_trials(const EvaluatedObject& object, const Faces& faces,
                              const ExplainSettings& settings) {
  const ClassSymmetry symmetry(object.index, object.views, object.rotations);
  TestBench bench({&object.index, 1}, {});
  std::vector<Trial> trials;
  for (const Eigen::Vector3d& direction :
       random_directions(static_cast<std::size_t>(settings.views), settings.seed)) {
    const Recognition recognition = bench.recognise(object, direction);
    Trial trial;
    trial.outcome = judge(object, symmetry, direction, recognition);
    trial.right_aspect = trial.outcome.rank_with_symmetry == 1;
    if (!hypotheses_of(recognition).empty()) {
      const Hypothesis& answer = hypotheses_of(recognition).front();
      trial.found = true;
      trial.found_class = answer.class_id;
      trial.found_view =
          Eigen::Vector3f(answer.view[0], answer.view[1], answer.view[2]).cast<double>();
      if (trial.is_wrong())
        trial.contours = matched_faces(object, faces, bench, recognition, answer);
    }
    trials.push_back(std::move(trial));
  }
  return trials;
}

Accuracy accuracy_of(const std::vector<Trial>& trials) {
  const auto share = [&](const auto& test) {
    const auto count = std::count_if(trials.begin(), trials.end(), test);
    return share_of(static_cast<std::size_t>(count), trials.size());
  };
  const auto rank_within = [&](int most) {
    return share([most](const Trial& t) {
      return t.outcome.rank_with_symmetry >= 1 && t.outcome.rank_with_symmetry <= most;
    });
  };
  return {rank_within(1), rank_within(5), rank_within(10),
          share([](const Trial& t) { return t.outcome.error_deg <= Trial::kFar_deg; })};
}

}  // namespace aspect
