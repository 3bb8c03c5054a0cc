#include "tools/replay/replay_options.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdio>
#include <map>
#include <string>
#include <system_error>

#include "tools/command_line/command_line.h"
#include "tools/command_line/terminal_colour.h"

namespace aspect {
namespace {

constexpr const char* kDescription =
    "Recognises objects in recorded frames: one JSON object a line for each frame.";

constexpr const char* kFooter = R"(
A frame is a picture, a folder of pictures (in the order of their names), a video or a file of raw
camera frames, NAME.WIDTHxHEIGHT.FOURCC as clip.640x480.YUYV. NNNNNN in the name of a picture written
is the frame's sequence. On a device: raw frames and binary PPM and PGM pictures only.
Values given here win over those of --config, and those over what the index was compiled with.

The output has the keys frame, sequence, width, height, elapsed_ms, stages_ms and objects, the
largest first: [{box: [x, y, width, height], regions, verdict: match, ambiguous (another object
explains the picture as well) or unknown, probability, rivals: places in hypotheses of what explains
it as well, hypotheses, the best first: [{object, class, score, matched, unmatched, view: unit vector
from the object's centre to the camera, pose: {quaternion: [w, x, y, z], translation,
reprojection_px, covariance}, contours: [[number in the frame, name in the class], ...]}]}].

--track follows objects from frame to frame. A match then has track, a number from 1 on that stays:
through frames in which the object is hidden or out of the picture, for 90 of them, and never given
to another one. Between searches only what is followed is looked for and listed, nearest first,
each with one hypothesis without contours; its probability is that of its last recognition.
With --explain every frame is searched.

--time-limit-ms gives the best answer that is found within so long of a frame. Seeing its regions
(convert to features in stages_ms) is not cut short, so that no limit below that is kept. Where
something was left undone the line has left_undone: {objects: seen and not looked at to the end,
which makes them unknown; indexes: whose objects were not looked for before any background; starts:
places where such an object may be that were not tried; tracks: followed objects that were not
looked for, which keep their numbers; searches: 1 where new objects were due to be looked for}, only
those that are not 0.

--explain adds explanation to each object, of its best hypothesis: {contours: [{contour: number in
the frame, name: in the class, surfaces: primitives of the scene from 1, colour: shares of red,
green and blue}], missing: what the model shows in that pose and the picture does not [{name,
surfaces, colour, area_px, covered: share of it that has its colour}], contradicts: what shows
another colour than the model [{contour, colour, drawn, left out where the model shows nothing,
which speaks against those only that stand alone, area_px}]}. Without a pose missing and contradicts
are contours without a match. With NAME there is also expected, why that one was not chosen:
{reason, chosen, on_shortlist, least_cost: of each of its views, by colours, sizes and places (ranked
by classes: matched, its contours at most, and needed for the shortlist); and of its best hypothesis,
object, class, rank from 1 where it is on the shortlist, score, agreement: share of the picture
explained where it was tried or is now, contours, missing, contradicts}. Frames are looked at twice
then. A word after --explain that is a file or folder is a frame; --explain=NAME is always a name.

--bop writes the rows of the BOP benchmark's results (scene_id,im_id,obj_id,score,R,t,time, a line of
these names first) to standard output in place of lines: one for each object that is a match or
ambiguous, with its probability for a score; --min-confidence 0 gives all. im_id is the number that a
picture's name ends with, or a frame's of a video; a frame that has none fails. Lengths are those of
the scene, for BOP's own models millimetres.

--html writes one file that any browser shows without a network, while the lines go to standard
output as ever: every frame with what was found drawn over it, to be filtered by object, verdict and
error, sorted and searched; behind each its regions as segmented, the first ten classes as the
index's model shows them, what matched which surface, what is missing, what contradicts, and why
none of the other loaded objects was chosen (not with --track). Frames that cannot be read are in it
as such. Frames are looked at twice then. The page is there when all frames are done; it takes 10 to
40 KB a frame. With --truth it has the errors that aspect-score would tell.

--serve shows the frames on the page that aspectd has for its camera, over and over, at 15 a second
or at --pace, until it is interrupted: picture, regions and what was recognised side by side, a
slider for every value of [segmentation], a region of interest to be drawn, recording, pause and
step. Its address is printed, with a token without which nothing can be changed; other pages and
other machines cannot. [output.http] of --config gives address, port and record, unless they are
given here. What is changed holds until it is written to the file of --config, which the page does
when it is told to, and keeps the old one as FILE.toml.1.

--thesis-index writes .index of the thesis's appendix A.2 in place of JSON: for each object seen a
line with the frame's name (:2 and so on behind it for further objects of a frame; blanks and % as
%20 and %25), then one for each class, the best first: its number, from 1 on as in the files of
aspect-export, its score, and its matches SEEN-KNOWN(WEIGHT): number in the frame, in the class from
0 on, and in how many views of the class that contour is of that type. Classes are ranked by their
score alone; --matching simple is the thesis's findclass, weighted its findclass_weighted. For one
index of one object.

Exit code: 0 all frames were processed, or all indexes passed the self test; 1 a frame or an index
failed (one line each on standard error; the others are processed all the same), 2 wrong usage.

Examples:
  aspect-replay --index cube.aspect frame.png
  aspect-replay --index cube.aspect --index truck.aspect --config camera.toml frames/ > seen.jsonl
  aspect-replay --index cube.aspect --self-test
  aspect-replay --index cube.aspect --index truck.aspect --explain truck frame.png
  aspect-replay --index cube.aspect --top 3 --overlay pictures/ --pace 25 clip.avi
  aspect-replay --index duck.aspect --config camera.toml --bop 2 9 test/000002/rgb > duck.csv
  aspect-replay --index cube.aspect --html page/ --truth truth.csv frames/ > seen.jsonl
  aspect-replay --index cube.aspect --config aspectd.toml --serve frames/
)";

// --explain without a name, for CLI11: see with_names_attached.
constexpr const char* kExplainChosen = "--explain-chosen";

// CLI11 would take the first frame for the name that --explain may do without.
std::vector<std::string> with_names_attached(int argc, const char* const* argv) {
  std::vector<std::string> words(argv, argv + argc);
  std::vector<std::string> attached;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (words[k] == "--") {
      attached.insert(attached.end(), words.begin() + static_cast<std::ptrdiff_t>(k), words.end());
      break;
    }
    if (words[k] != "--explain") {
      attached.push_back(words[k]);
      continue;
    }
    std::error_code ignored;
    const bool has_name = k + 1 < words.size() && !words[k + 1].empty() &&
                          words[k + 1].front() != '-' &&
                          !std::filesystem::exists(words[k + 1], ignored);
    attached.push_back(has_name ? "--explain=" + words[++k] : kExplainChosen);
  }
  return attached;
}

// What CLI11 makes of the command line; an absent option is an empty or zero value here.
struct RawOptions {
  ReplayOptions options;
  std::string configuration, overlay, dump, page, truth, symmetries, record;
  std::vector<std::string> indexes, frames, bop;
  double bop_unit_mm = 1;
};

template <typename Value>
CLI::Option* add_choice(CLI::App& app, const std::string& name, std::optional<Value>& value,
                        const std::map<std::string, Value>& words, const std::string& help) {
  std::vector<std::string> known;
  for (const auto& [word, meaning] : words) known.push_back(word);
  return take_words(
      app.add_option_function<std::string>(
          name, [&value, words](const std::string& word) { value = words.at(word); }, help),
      known);
}

// CLI11's own range check lets "nan" through.
std::string fault_of_number(const std::string& text, const char* meaning, double least,
                            double most) {
  double number = 0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, number);
  const bool is_number = parsed.ec == std::errc() && parsed.ptr == end;
  if (is_number && number >= least && number <= most) return {};
  return fmt::format("{} is not {} from {} to {}", text, meaning, least, most);
}

void add_inputs(CLI::App& app, RawOptions& raw) {
  app.add_option("--index", raw.indexes,
                 "class index of an object or of several; repeat it for more")
      ->required()
      ->type_name("FILE.aspect")
      ->allow_extra_args(false)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  app.add_option("--config", raw.configuration,
                 "[camera], [segmentation] and [recognition] in TOML")
      ->type_name("FILE.toml");
  CLI::Option* frames =
      app.add_option("frames", raw.frames, "pictures, raw frames, folders of them, videos")
          ->type_name("FRAME");
  app.add_flag("--self-test", raw.options.self_test,
               "test every index with its golden frame, one line each, and nothing else")
      ->excludes(frames);
  app.final_callback([&raw] {
    if (raw.frames.empty() && !raw.options.self_test) throw CLI::RequiredError("frames");
    if (!raw.bop.empty() && raw.bop[0].find(',') != std::string::npos)
      throw CLI::ValidationError("--bop", raw.bop[0] + " is more than one scene");
    if (!raw.bop.empty() && raw.options.explain)
      throw CLI::ValidationError("--bop", "has no room for what --explain says");
    if (raw.options.serve && raw.options.explain) throw CLI::ExcludesError("--explain", "--serve");
  });
}

void add_recognition(CLI::App& app, RawOptions& raw) {
  using Ranking = RecogniserParameters::Ranking;
  RecognitionOverrides& overrides = raw.options.recognition;
  app.add_option_function<int>(
         "--top", [&overrides](int top) { overrides.top = top; },
         fmt::format("hypotheses for each object seen, 1 to {} [10]", kMaxHypotheses))
      ->check(CLI::Range(1, kMaxHypotheses).description(""))
      ->type_name("N");
  app.add_option_function<double>(
         "--min-confidence",
         [&overrides](double probability) { overrides.confidence_min = probability; },
         "probability from which an object is a match, 0 to 1 [0.5]")
      ->check(CLI::Range(0.0, 1.0).description(""))
      ->type_name("P");
  app.add_flag_function(
      "--track", [&overrides](std::int64_t) { overrides.track = true; },
      "follow objects from frame to frame: each keeps a number, and costs a fraction");
  app.add_option_function<int>(
         "--search-every", [&overrides](int frames) { overrides.search_every = frames; },
         "with --track: all of every N-th frame is searched for new objects, 1: of each [10]")
      ->check(CLI::Range(1, kMostSearchEvery).description(""))
      ->type_name("N");
  app.add_option_function<double>(
         "--time-limit-ms", [&overrides](double limit) { overrides.time_limit_ms = limit; },
         "the best answer within so long of each frame, but for seeing its regions [none]")
      ->check([](const std::string& text) {
        return fault_of_number(text, "a time", kLeastTimeLimit_ms, kMostTimeLimit_ms);
      })
      ->type_name("T");
  add_choice<Matching>(app, "--matching", overrides.matching,
                       {{"simple", Matching::simple}, {"weighted", Matching::weighted}},
                       "match most contours, or of those the best scored [weighted]");
  add_choice<Ranking>(app, "--ranking", overrides.ranking,
                      {{"views", Ranking::views}, {"classes", Ranking::classes}},
                      "order by the best key view, or by the class's score alone [views]");
}

void add_thesis_index(CLI::App& app, RawOptions& raw) {
  CLI::Option* option = app.add_flag("--thesis-index", raw.options.thesis_index,
                                     "write results in the thesis's format in place of JSON");
  for (const char* other : {"--ranking", "--track", "--self-test", "--bop", "--html", "--serve"})
    option->excludes(app.get_option(other));
}

void add_outputs(CLI::App& app, RawOptions& raw) {
  constexpr double kMostFps = 1000, kLeastFps = 0.001;
  app.add_option("--overlay", raw.overlay,
                 "write frames with what was seen drawn over, NNNNNN_NAME.png")
      ->type_name("FOLDER");
  app.add_option(
         "--dump", raw.dump,
         "write a picture a stage: NNNNNN_1_input.png, _2_regions (one colour each, black: none), "
         "_3_overlay, _4_numbers (of the contours)")
      ->type_name("FOLDER");
  CLI::Option* page = app.add_option("--html", raw.page,
                                     "write a page of all frames, FOLDER/index.html: pictures with "
                                     "what was seen, filters, and for each frame why")
                          ->type_name("FOLDER");
  CLI::Option* truth =
      app.add_option("--truth", raw.truth, "with --html: what is right, as aspect-score takes it")
          ->needs(page)
          ->type_name("FILE.csv");
  app.add_option("--symmetries", raw.symmetries,
                 "with --truth: rotations that leave objects as they are")
      ->needs(truth)
      ->type_name("FILE");
  app.add_option_function<std::string>(
         "--explain", [&raw](const std::string& name) { raw.options.explain = name; },
         "tell why each object is taken for what it is, and why not for NAME: an object, a class's "
         "number, or OBJECT:CLASS")
      ->type_name("[NAME]");
  app.add_flag_function(
         kExplainChosen,
         [&raw](std::int64_t) { raw.options.explain = raw.options.explain.value_or(""); }, "")
      ->group("");
  app.add_option_function<double>(
         "--pace", [&raw](double fps) { raw.options.pace_fps = fps; },
         "start frames at this rate a second, and tell how it went [as fast as possible]")
      ->check([](const std::string& text) {
        return fault_of_number(text, "a rate", kLeastFps, kMostFps);
      })
      ->type_name("FPS");
}

std::vector<std::uint32_t> whole_numbers(const std::string& text) {
  std::vector<std::uint32_t> numbers;
  const char *at = text.data(), *end = at + text.size();
  for (;; ++at) {
    std::uint32_t number = 0;
    const auto parsed = std::from_chars(at, end, number);
    if (parsed.ec != std::errc()) return {};
    numbers.push_back(number);
    at = parsed.ptr;
    if (at == end) return numbers;
    if (*at != ',') return {};
  }
}

void add_bop(CLI::App& app, RawOptions& raw) {
  CLI::Option* bop =
      app.add_option("--bop", raw.bop,
                     "write poses as the BOP benchmark's CSV instead of lines; OBJ_ID of the "
                     "object, or with commas of each that is loaded")
          ->type_name("SCENE_ID OBJ_ID")
          ->expected(2)
          ->allow_extra_args(false)
          ->check([](const std::string& text) {
            return whole_numbers(text).empty() ? text + " is no number that BOP has for an id" : "";
          });
  app.add_option("--bop-unit-mm", raw.bop_unit_mm,
                 "with --bop: millimetres in a unit of the scenes, 1000 for metres [1]")
      ->needs(bop)
      ->check([](const std::string& text) { return fault_of_number(text, "a length", 1e-6, 1e6); })
      ->type_name("MM");
}

BopIds bop_ids(const RawOptions& raw) {
  return {whole_numbers(raw.bop[0]).front(), whole_numbers(raw.bop[1]), raw.bop_unit_mm};
}

void add_page(CLI::App& app, RawOptions& raw) {
  constexpr int kMostPort = 65535;
  CLI::Option* serve =
      app.add_flag("--serve", raw.options.serve,
                   "show the frames over and over on a page with sliders, instead of lines")
          ->group("Page")
          ->excludes("--self-test")
          ->excludes("--explain")
          ->excludes("--overlay")
          ->excludes("--dump")
          ->excludes("--html")
          ->excludes("--bop");
  app.add_option_function<std::string>(
         "--address", [&raw](const std::string& address) { raw.options.address = address; },
         "where the page is served, 0.0.0.0: on every interface [127.0.0.1]")
      ->type_name("ADDRESS")
      ->group("Page")
      ->needs(serve);
  app.add_option_function<int>(
         "--port", [&raw](int port) { raw.options.port = port; },
         "port of the page, 0: any that is free [8080]")
      ->check(CLI::Range(0, kMostPort).description(""))
      ->type_name("PORT")
      ->group("Page")
      ->needs(serve);
  app.add_option("--record", raw.record, "where the page records frames to [nowhere]")
      ->type_name("FOLDER")
      ->group("Page")
      ->needs(serve);
}

std::string fault_of_thesis_index(const RawOptions& raw) {
  if (!raw.options.thesis_index) return {};
  if (raw.options.explain) return "excludes --explain; leave one of them out";
  if (raw.indexes.size() > 1) return "numbers the classes of one object; give one --index";
  return {};
}

ReplayOptions finished(RawOptions raw) {
  ReplayOptions options = std::move(raw.options);
  options.indexes.assign(raw.indexes.begin(), raw.indexes.end());
  options.frames.assign(raw.frames.begin(), raw.frames.end());
  if (!raw.configuration.empty()) options.configuration = raw.configuration;
  if (!raw.overlay.empty()) options.overlay_folder = raw.overlay;
  if (!raw.dump.empty()) options.dump_folder = raw.dump;
  if (!raw.page.empty()) options.page_folder = raw.page;
  if (!raw.truth.empty()) options.truth = raw.truth;
  if (!raw.symmetries.empty()) options.symmetries = raw.symmetries;
  if (!raw.bop.empty()) options.bop = bop_ids(raw);
  if (!raw.record.empty()) options.record_folder = raw.record;
  return options;
}

}  // namespace

std::variant<ReplayOptions, int> parse_replay_options(int argc, const char* const* argv) {
  CLI::App app(kDescription, "aspect-replay");
  app.footer(kFooter);
  app.set_version_flag("--version", "aspect-replay " ASPECT_VERSION);
  RawOptions raw;
  add_inputs(app, raw);
  add_recognition(app, raw);
  add_outputs(app, raw);
  add_bop(app, raw);
  add_page(app, raw);
  add_thesis_index(app, raw);
  const std::vector<std::string> words = with_names_attached(argc, argv);
  std::vector<const char*> word_starts;
  word_starts.reserve(words.size());
  for (const std::string& word : words) word_starts.push_back(word.c_str());
  if (const auto exit_code =
          parse_command_line(app, static_cast<int>(word_starts.size()), word_starts.data()))
    return *exit_code;
  if (const std::string fault = fault_of_thesis_index(raw); !fault.empty()) {
    print_failure("aspect-replay", "--thesis-index: " + fault);
    return kUsageError;
  }
  return finished(std::move(raw));
}

}  // namespace aspect
