// Reads a Bob scene in four layers, each a class: BobSources holds the texts, BobLexer cuts one
// into words, BobPreprocessor joins them into a stream of expanded words, and BobParser makes the
// scene of it. Inside, errors are thrown (BobError); here they become a Result.
#include "compiler/scene/bob_reader.h"

#include <fmt/format.h>

#include "compiler/scene/bob_parser.h"
#include "compiler/scene/bob_sources.h"
#include "compiler/scene/bob_words.h"

namespace aspect {

Result<Scene> parse_bob(std::string_view text, const std::filesystem::path& name,
                        const std::vector<std::filesystem::path>& include_path,
                        const std::optional<Eigen::Vector3d>& missing_colour) {
  BobSources sources;
  if (text.size() > sources.bytes_left()) {
    return Error{fmt::format("{}: too large; a scene has at most {} MiB", name.string(),
                             BobSources::kMaxBytes >> 20)};
  }
  try {
    BobWords words(sources, sources.add(name, std::string(text)), include_path);
    Scene scene = BobParser(words, missing_colour).parse();
    scene.name = name.stem().string();
    scene.file = name.string();
    scene.files = sources.noted();
    return scene;
  } catch (const BobError& error) {
    return Error{error.what()};
  }
}

Result<Scene> read_bob(const std::filesystem::path& file,
                       const std::vector<std::filesystem::path>& include_path,
                       const std::optional<Eigen::Vector3d>& missing_colour) {
  Result<std::string> text = load_text(file, BobSources::kMaxBytes);
  if (!text.ok()) return Error{fmt::format("{}: {}", file.string(), text.error())};
  Result<Scene> scene = parse_bob(text.value(), file, include_path, missing_colour);
  if (scene) scene.value().files.push_back(file.string());
  return scene;
}

}  // namespace aspect
