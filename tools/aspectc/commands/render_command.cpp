#include "tools/aspectc/commands/render_command.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "compiler/aspects/observer.h"
#include "tools/aspectc/commands/command_failure.h"
#include "tools/aspectc/commands/whole_file.h"
#include "tools/aspectc/project/prepared_object.h"
#include "tools/command_line/command_line.h"
#include "tools/draw/frame_canvas.h"
#include "tools/draw/region_draw.h"

namespace aspect {
namespace {

// `name` has passed the option's check.
SensorKind sensor_named(const std::string& name) {
  const auto* found = std::find(kSensorNames.begin(), kSensorNames.end(), name);
  return static_cast<SensorKind>(found - kSensorNames.begin());
}

}  // namespace

CLI::App* add_render_command(CLI::App& app, RenderCommand& command) {
  CLI::App* render = app.add_subcommand("render", "Render one view of a scene.");
  render->add_option("scene", command.scene, "scene (.b) or mesh, or a project with one (.toml)")
      ->required()
      ->type_name("SCENE|FILE.toml");
  render
      ->add_option("--from", command.from,
                   "direction from the scene's centre to the camera, of any length")
      ->type_name("X,Y,Z")
      ->delimiter(',')
      ->expected(3)
      ->required();
  render->add_flag("--segmented", command.segmented,
                   "what is seen: regions in false colours with contour ids");
  render->add_option("-o,--output", command.output, "picture to write")
      ->required()
      ->type_name("FILE.png");
  const std::vector<std::string> sensors(kSensorNames.begin(), kSensorNames.end());
  take_words(render->add_option("--sensor", command.sensor,
                                "what the picture is of [the project's, or colour]"),
             sensors);
  render->footer(
      "Examples:\n  aspectc render part.b --from 1,0.5,0.3 -o view.png\n"
      "  aspectc render part.b --from 0,0,1 --segmented -o regions.png");
  return render;
}

int run_render(const RenderCommand& command) {
  const Result<PreparedObject> object = read_prepared_object(command.scene);
  if (!object) return fail(object.error());
  const Scene& scene = object.value().scene;
  const Result<Renderer> renderer = Renderer::create(scene);
  if (!renderer) return fail(command.scene + ": " + renderer.error());
  const Eigen::Vector3d from(command.from[0], command.from[1], command.from[2]);
  if (!(from.norm() > 0) || !from.allFinite())
    return refuse_usage("--from needs a direction other than 0,0,0");
  Observer observer(renderer.value(), scene.studio,
                    command.sensor.empty() ? object.value().settings.options.vision
                                           : default_parameters(sensor_named(command.sensor)));
  observer.observe(from.normalized());
  const Frame& frame = observer.frame();
  const cv::Mat drawn = command.segmented
                            ? draw_numbered_regions(observer.regions(), observer.graph(),
                                                    frame.width_px, frame.height_px)
                            : recorded_picture(frame);
  std::vector<std::uint8_t> png;
  if (!cv::imencode(".png", drawn, png))
    return fail(command.output + ": the picture could not be encoded");
  const Result<Done> done = write_whole_file(command.output, png);
  return done ? 0 : fail(done.error());
}

}  // namespace aspect
