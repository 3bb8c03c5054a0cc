#include "tools/plot/svg_plot.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/tools/plot/drawn_svg.h"

namespace aspect {

using Json = nlohmann::json;

TEST_CASE("Names may hold anything, and the plot is XML all the same") {
  const std::string all_bytes = [] {
    std::string bytes;
    for (int k = 1; k < 256; ++k) bytes += static_cast<char>(k);
    return bytes;
  }();
  for (const std::string& name :
       {std::string("a<b>&\"c\"'d'"), all_bytes, std::string("\xC3"), std::string("\xED\xA0\x80"),
        std::string("\xF4\x90\x80\x80"), std::string("\xEF\xBF\xBE"), std::string("\xC0\x80"),
        std::string("Schlüssel ✓ 🔧")}) {
    SvgPage page(200, 100, name);
    page.text({10, 60}, name);
    page.mark({10, 60}, 0, name);
    page.legend({20, 60}, std::vector{name});
    const Json drawn = drawn_svg(page.document());
    CHECK(drawn["count"]["circle"] == 2);
    CHECK(drawn["texts"].size() == 3);
  }
  CHECK(svg_text("Schlüssel ✓") == "Schlüssel ✓");
  CHECK(svg_text("\xC3(") == "?(");
  CHECK(cut_text("äöü", 2) == "äö…");
  CHECK(cut_text("äö", 2) == "äö");
}

TEST_CASE("A panel puts a value where its axes say, and what is beyond at their ends") {
  SvgPage page(300, 300, "plot");
  PlotPanel panel(page, {100, 50, 100, 200}, {"x, s", 0, 10}, {"y, px", 1, 100, true});
  const auto is_at = [&](double x, double y, double x_px, double y_px) {
    const PlotPoint at = panel.at(x, y);
    CHECK(at.x == Approx(x_px));
    CHECK(at.y == Approx(y_px));
  };
  is_at(0, 1, 100, 250);
  is_at(10, 100, 200, 50);
  is_at(2.5, 10, 125, 150);  // half of two decades
  is_at(-3, 0, 100, 250);
  is_at(11, 1e9, 200, 50);
  is_at(std::nan(""), std::nan(""), 100, 250);
  const std::vector<PlotPoint> line = {{0, 1}, {10, 100}};
  panel.curve(line, 0, true);
  const Json drawn = drawn_svg(page.document());
  CHECK(drawn["curves"][0]["points"] == Json{{100, 250}, {200, 50}});
  CHECK(drawn["marks"] == 2);
  CHECK(drawn["outside"].empty());
  for (const char* word : {"x, s", "y, px", "0", "10", "1", "100"})
    CHECK(std::count(drawn["texts"].begin(), drawn["texts"].end(), word) >= 1);
}

TEST_CASE("Ticks are round numbers within the axis") {
  const auto texts = [](const PlotAxis& axis) {
    std::string all;
    for (const PlotTick& tick : round_ticks(axis)) all += tick.text + " ";
    return all;
  };
  CHECK(texts({"", 0, 1}) == "0 0.2 0.4 0.6 0.8 1 ");
  CHECK(texts({"", 0, 100}) == "0 20 40 60 80 100 ");
  CHECK(texts({"", 3, 40}) == "10 20 30 40 ");
  CHECK(texts({"", 0.01, 180, true}) == "0.01 0.1 1 10 100 ");
  CHECK(round_end(0.013) == Approx(0.02));
  CHECK(round_end(7) == Approx(10));
  CHECK(round_end(0) == 1);
  CHECK(round_end(INFINITY) == 1);
}

TEST_CASE("Series differ in colour or in dashes, and neighbours in their marks") {
  SvgPage page(300, 700, "plot");
  std::vector<std::string> names(28, "object");
  page.legend({10, 40}, names);
  const Json drawn = drawn_svg(page.document());
  CHECK(drawn["marks"] == 28);
  CHECK(drawn["outside"].empty());
  CHECK(series_colour(0) != series_colour(1));
}

}  // namespace aspect
