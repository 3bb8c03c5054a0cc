#include "tools/eval/eval_options.h"

#include <catch2/catch.hpp>

namespace aspect {
namespace {

std::variant<EvalOptions, int> parsed(std::vector<const char*> more) {
  std::vector<const char*> words = {"aspect-eval", "--index", "a.aspect", "--scene", "a.b"};
  words.insert(words.end(), more.begin(), more.end());
  return parse_eval_options(static_cast<int>(words.size()), words.data());
}

}  // namespace

TEST_CASE("What frames in clutter are made of is asked for with --clutter alone") {
  const std::vector<std::vector<const char*>> wrong = {
      {"--backgrounds", "."},           {"--hidden", "0.3"},
      {"--dump", "x"},                  {"--recall", "x.svg"},
      {"--clutter", "--hidden", "0.8"}, {"--clutter", "--hidden", "-0.1"},
      {"--clutter", "--hidden", "x"},   {"--clutter", "--reliability", "x.svg"},
      {"--clutter", "--ranking", "classes"}};
  for (const auto& words : wrong) {
    INFO(words.front());
    const auto options = parsed(words);
    REQUIRE(std::holds_alternative<int>(options));
    CHECK(std::get<int>(options) == 2);
  }
  const auto right = parsed({"--clutter", "--backgrounds", "b", "--hidden", "0.3", "--dump", "d",
                             "--recall", "r.svg", "--views", "7"});
  REQUIRE(std::holds_alternative<EvalOptions>(right));
  const auto& options = std::get<EvalOptions>(right);
  CHECK(options.clutter);
  CHECK(options.backgrounds == "b");
  CHECK(options.hidden_max == 0.3);
  CHECK(options.dump == "d");
  CHECK(options.recall == "r.svg");
  CHECK(options.views == 7);
}

}  // namespace aspect
