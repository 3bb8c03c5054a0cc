// Three kinds of threads meet here. The loop's: it leaves frames in a slot and a recorder and takes
// changed values, all by trying. The page's, several at once: they draw under one lock and change
// the draft under another. Nobody holds a lock that the loop tries for longer than a copy.
#include "runtime/workbench/workbench_desk.h"

#include <fmt/format.h>
#include <algorithm>
#include <mutex>
#include <utility>

#include "runtime/base/input_file.h"
#include "runtime/workbench/camera_panel.h"
#include "runtime/workbench/frame_recorder.h"
#include "runtime/workbench/frame_slot.h"
#include "runtime/workbench/kept_file.h"
#include "runtime/workbench/state_text.h"
#include "runtime/workbench/view_drawing.h"

namespace aspect {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr int kDone = 200, kNothingNew = 204, kBad = 400, kUnknown = 404;

PageAnswer answer_of(const Json& json, int status = kDone) {
  return {status, "application/json",
          std::make_shared<const std::string>(
              json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n")};
}

// Of what is asked for as it should be and cannot be had: no fault of the page, whose browser would
// complain of another status in its console.
PageAnswer refused(const std::string& reason, int status = kDone) {
  return answer_of({{"refused", reason}}, status);
}

Result<std::string> text_of(const fs::path& file) {
  constexpr std::uint64_t kMostBytes = 1U << 20U;
  InputFile input(file);
  const auto bytes = input.size();
  if (!bytes || *bytes > kMostBytes)
    return Error{file.native() + ": cannot be read; check that it is still there"};
  std::string text(static_cast<std::size_t>(*bytes), '\0');
  if (!input.read(std::as_writable_bytes(std::span(text))))
    return Error{file.native() + ": cannot be read to its end; check the disk"};
  return text;
}

// What the drawing needs of the indexes, so that these may go.
struct Models {
  std::vector<ObjectModel> shapes;
  std::vector<ModelColours> colours;
};

class Desk final : public Workbench {
 public:
  explicit Desk(const WorkbenchParts& parts)
      : play_(parts.play), panel_(parts.calls != nullptr ? *parts.calls : kernel_calls()) {}

  bool wants_frame() const noexcept override { return slot_.wanted() || recorder_.wanted(); }
  void show(const Frame& frame, const Recognition& recognition,
            std::span<const CameraModel> cameras, std::uint64_t line) noexcept override;
  bool take_vision(VisionParameters& vision) noexcept override;
  bool take_controls(std::vector<CameraControl>& controls) noexcept override;
  void use(const WorkbenchSetup& setup) override;
  void use_camera(const CameraPlan* plan) override;

  PageAnswer state() override;
  PageAnswer view(std::optional<std::uint64_t> after) override;
  PageAnswer act(std::string_view action, const std::string& json) override;

 private:
  std::shared_ptr<const std::string> drawn(std::optional<std::uint64_t> after);
  void hand_over_vision();
  PageAnswer change(const Json& values);
  PageAnswer forget();
  PageAnswer set_control(const Json& asked);
  PageAnswer record();
  PageAnswer save();
  Result<fs::path> save_as(const fs::path& file, std::string& text);
  PageAnswer play(const Json& asked);

  PlayControl* const play_;
  FrameSlot slot_;
  FrameRecorder recorder_;
  CameraPanel panel_;

  std::mutex hand_over_;  // of what follows; the loop only ever tries it
  VisionParameters for_loop_;
  std::vector<CameraControl> controls_for_loop_;
  std::atomic<bool> has_vision_{false}, has_controls_{false};

  std::mutex mutex_;  // of what follows; before hand_over_
  SettingsDraft draft_;
  std::uint64_t settings_ = 1;  // number of the values that hold
  std::shared_ptr<const Models> models_ = std::make_shared<Models>();
  fs::path file_, record_;
  std::function<std::optional<Error>(const std::string&)> check_;
  SensorKind sensor_ = SensorKind::colour;
  bool has_camera_ = false;

  std::mutex drawing_;  // of what follows; before mutex_
  FrameCopy copy_;
  std::uint64_t line_ = 0;
  bool has_frame_ = false;
  ViewDrawing drawer_;
  std::shared_ptr<const std::string> view_text_;
  std::uint64_t view_ = 0, drawn_settings_ = 0;

  std::mutex recording_, saving_;
  std::atomic<int> waiting_{0};
};

void Desk::show(const Frame& frame, const Recognition& recognition,
                std::span<const CameraModel> cameras, std::uint64_t line) noexcept {
  if (slot_.wanted()) slot_.show(frame, recognition, cameras, line);
  if (recorder_.wanted()) recorder_.show(frame);
}

bool Desk::take_vision(VisionParameters& vision) noexcept {
  if (!has_vision_.load(std::memory_order_acquire)) return false;
  const std::unique_lock lock(hand_over_, std::try_to_lock);
  if (!lock.owns_lock()) return false;
  has_vision_.store(false, std::memory_order_relaxed);
  vision = for_loop_;
  return true;
}

bool Desk::take_controls(std::vector<CameraControl>& controls) noexcept {
  if (!has_controls_.load(std::memory_order_acquire)) return false;
  const std::unique_lock lock(hand_over_, std::try_to_lock);
  if (!lock.owns_lock()) return false;
  has_controls_.store(false, std::memory_order_relaxed);
  controls.swap(controls_for_loop_);
  return true;
}

void Desk::use(const WorkbenchSetup& setup) {
  auto models = std::make_shared<Models>();
  for (const ClassIndex& index : setup.indexes) {
    models->shapes.push_back(index.model);
    models->colours.push_back({index.object, index.model.shares});
  }
  // The parameters without what [segmentation] says.
  Configuration without = setup.configuration;
  without.segmentation = {};
  RecogniserParameters otherwise = setup.parameters;
  otherwise.vision = setup.indexes.front().vision;
  without.apply(otherwise);

  const std::lock_guard drawing(drawing_);
  const std::lock_guard lock(mutex_);
  slot_.empty();
  has_frame_ = false;
  models_ = std::move(models);
  draft_.start(setup.configuration, otherwise.vision);
  file_ = setup.file;
  record_ = setup.configuration.output.http ? setup.configuration.output.http->record : fs::path();
  check_ = setup.check;
  sensor_ = setup.parameters.vision.sensor;
  ++settings_;
  const std::lock_guard hand_over(hand_over_);
  has_vision_ = has_controls_ = false;
}

void Desk::use_camera(const CameraPlan* plan) {
  panel_.use(plan != nullptr ? plan->node : "");
  const std::lock_guard lock(mutex_);
  has_camera_ = plan != nullptr;
}

PageAnswer Desk::state() {
  const std::vector<AdjustableControl> controls = panel_.controls();
  const std::lock_guard lock(mutex_);
  return {kDone, "application/json",
          std::make_shared<const std::string>(
              state_text({draft_, settings_, sensor_, file_, record_, models_->colours, controls,
                          has_camera_, play_}))};
}

// Null where there is nothing but the view that the page has.
std::shared_ptr<const std::string> Desk::drawn(std::optional<std::uint64_t> after) {
  const std::lock_guard drawing(drawing_);
  const bool is_new = slot_.take(copy_, line_);
  has_frame_ = has_frame_ || is_new;
  if (!has_frame_) return nullptr;
  std::unique_lock lock(mutex_);
  const VisionParameters vision = draft_.values();
  const std::uint64_t settings = settings_;
  const auto models = models_;
  lock.unlock();
  if (is_new || settings != drawn_settings_) {
    view_text_ = std::make_shared<const std::string>(
        drawer_.draw(copy_, vision, models->shapes, {++view_, line_, settings}));
    drawn_settings_ = settings;
  }
  // Another number may be that of a program that ran before.
  return after && *after == view_ ? nullptr : view_text_;
}

PageAnswer Desk::view(std::optional<std::uint64_t> after) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kLongest{250}, kLook{10};
  // Some threads stay free for who asks for something else.
  constexpr int kMostWaiting = 3;
  const auto deadline = Clock::now() + kLongest;
  const bool may_wait = waiting_.fetch_add(1) < kMostWaiting;
  std::shared_ptr<const std::string> text = drawn(after);
  while (!text && may_wait && Clock::now() < deadline) {
    slot_.wait(kLook);
    text = drawn(after);
  }
  waiting_.fetch_sub(1);
  if (!text) return {kNothingNew, "", nullptr};
  return {kDone, "application/octet-stream", std::move(text)};
}

PageAnswer Desk::act(std::string_view action, const std::string& text) {
  // Nothing that is sent is deep, and what is deep takes the stack when it goes.
  constexpr int kMostDepth = 8;
  bool is_deep = false;
  const Json asked = Json::parse(
      text,
      [&](int depth, Json::parse_event_t, Json&) {
        is_deep = is_deep || depth > kMostDepth;
        return depth <= kMostDepth;
      },
      false);
  if (is_deep || !asked.is_object()) return refused("the body is no JSON object", kBad);
  if (action == "settings") return change(asked);
  if (action == "forget") return forget();
  if (action == "control") return set_control(asked);
  if (action == "record") return record();
  if (action == "save") return save();
  if (action == "play") return play(asked);
  return refused("there is nothing of that name to be done", kUnknown);
}

// With mutex_ held.
void Desk::hand_over_vision() {
  ++settings_;
  const std::lock_guard lock(hand_over_);
  for_loop_ = draft_.values();
  has_vision_.store(true, std::memory_order_release);
}

PageAnswer Desk::change(const Json& values) {
  std::unique_lock lock(mutex_);
  const auto error = draft_.change(values);
  if (error) return refused(error->message);
  hand_over_vision();
  const std::uint64_t settings = settings_;
  const bool changed = draft_.is_changed();
  lock.unlock();
  slot_.tell_news();
  return answer_of({{"settings", settings}, {"changed", changed}});
}

PageAnswer Desk::forget() {
  {
    const std::lock_guard lock(mutex_);
    draft_.forget_values();
    hand_over_vision();
  }
  slot_.tell_news();
  return answer_of(Json::object());
}

PageAnswer Desk::set_control(const Json& asked) {
  if (!asked.contains("name") || !asked["name"].is_string() || !asked.contains("value") ||
      !asked["value"].is_number_integer())
    return refused("a control needs a name and a whole number", kBad);
  auto set = panel_.set({asked["name"].get<std::string>(), asked["value"].get<std::int64_t>()});
  if (!set) return refused(set.error());
  const CameraPanel::Set& done = set.value();
  const PageAnswer answer = answer_of({{"value", done.control.value}, {"warnings", done.warnings}});
  if (done.is_button) return answer;
  const std::lock_guard lock(mutex_);
  draft_.change_control(done.control, done.is_automatic);
  std::vector<CameraControl> controls = draft_.controls();
  const std::lock_guard hand_over(hand_over_);
  controls_for_loop_.swap(controls);
  has_controls_.store(true, std::memory_order_release);
  return answer;
}

PageAnswer Desk::record() {
  constexpr std::chrono::seconds kPatience{4};
  const std::unique_lock recording(recording_, std::try_to_lock);
  if (!recording.owns_lock()) return refused("frames are being recorded already");
  std::unique_lock lock(mutex_);
  const fs::path folder = record_;
  lock.unlock();
  if (folder.empty())
    return refused(play_ != nullptr
                       ? "there is no folder for them; start with --record FOLDER"
                       : "there is no folder for them; give [output.http] record = \"FOLDER\"");
  const auto recorded = recorder_.record(folder, kPatience);
  if (!recorded) return refused(recorded.error());
  const Recorded& done = recorded.value();
  return answer_of({{"frames", done.frames},
                    {"folder", folder.string()},
                    {"first", done.first.filename().string()},
                    {"last", done.last.filename().string()}});
}

PageAnswer Desk::save() {
  const std::lock_guard saving(saving_);
  std::unique_lock lock(mutex_);
  const fs::path file = file_;
  if (file.empty())
    return refused("there is no configuration to write; start with --config FILE.toml");
  if (draft_.fault()) return refused(file.native() + ": " + draft_.fault()->message);
  if (!draft_.is_changed()) return refused("nothing has been changed");
  lock.unlock();
  std::string text;
  const auto kept = save_as(file, text);
  if (!kept) return refused(kept.error());
  lock.lock();
  // As the next start will read it.
  if (const auto configuration = parse_configuration(text, file.native())) {
    draft_.start(configuration.value(), VisionParameters(draft_.otherwise()));
    hand_over_vision();
  }
  return answer_of({{"file", file.string()}, {"kept", kept.value().string()}});
}

// What was written, too.
Result<fs::path> Desk::save_as(const fs::path& file, std::string& text) {
  auto before = text_of(file);
  if (!before) return Error{before.error()};
  std::unique_lock lock(mutex_);
  const std::vector<TomlEdit> edits = draft_.edits();
  const auto check = check_;
  lock.unlock();
  auto after = edited_toml(before.value(), file.native(), edits);
  if (!after) return Error{after.error()};
  text = std::move(after).value();
  if (auto error = check(text)) return *error;
  return replace_and_keep(file, text);
}

PageAnswer Desk::play(const Json& asked) {
  constexpr int kMostSteps = 1000;
  if (play_ == nullptr) return refused("a camera cannot be paused");
  if (asked.contains("paused")) {
    if (!asked["paused"].is_boolean()) return refused("paused is true or false", kBad);
    play_->paused = asked["paused"].get<bool>();
    play_->steps = 0;
  }
  if (asked.contains("steps")) {
    const Json& steps = asked["steps"];
    if (!steps.is_number_integer() || steps < 1 || steps > kMostSteps)
      return refused("steps is a whole number from 1 to 1000", kBad);
    play_->paused = true;
    play_->steps += steps.get<int>();
  }
  return answer_of({{"paused", play_->paused.load()}});
}

}  // namespace

std::unique_ptr<Workbench> make_workbench(const WorkbenchParts& parts) {
  return std::make_unique<Desk>(parts);
}

std::unique_ptr<Workbench> make_camera_workbench(V4l2Calls* calls) {
  return make_workbench({calls, nullptr});
}

}  // namespace aspect
