#include "tools/export/formats/chain_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace aspect {
namespace {

constexpr std::string_view kSteps = "ABCDEFGH";
constexpr int kStepRight[8] = {1, 1, 0, -1, -1, -1, 0, 1};
constexpr int kStepUp[8] = {0, 1, 1, 1, 0, -1, -1, -1};
constexpr std::int64_t kFarthest_px = 1'000'000;
// Of a whole file: an outline through every pixel of the largest picture has fewer.
constexpr std::size_t kMostSteps = std::size_t{1} << 26U;

void append_steps(std::string_view steps, std::string& text) {
  for (std::size_t begin = 0, end = 0; begin < steps.size(); begin = end) {
    end = std::min(steps.find_first_not_of(steps[begin], begin), steps.size());
    if (end - begin > 1) fmt::format_to(std::back_inserter(text), "{}", end - begin);
    text += steps[begin];
  }
}

void read_steps(TextLines& lines, std::size_t& left, std::string& steps) {
  while (!lines.at_line_end()) {
    std::size_t count = 1;
    if (lines.peek() >= '0' && lines.peek() <= '9')
      count = static_cast<std::size_t>(
          lines.whole("number of repetitions", 1, static_cast<std::int64_t>(left)));
    const char step = lines.peek();
    if (kSteps.find(step) == std::string_view::npos) lines.fail("a step is none of A to H");
    lines.expect({&step, 1});
    if (count > left) lines.fail("more steps than any picture has room for");
    left -= count;
    steps.append(count, step);
  }
}

struct Step {
  int right = 0, up = 0;
};

Step step_of(char letter) {
  const auto k = static_cast<std::size_t>(letter - 'A');
  return {kStepRight[k], kStepUp[k]};
}

// The step from the last pixel back to the first.
Step closing_step(const ContourChain& chain) {
  Step sum;
  for (const char letter : chain.steps) {
    const Step step = step_of(letter);
    sum.right -= step.right;
    sum.up -= step.up;
  }
  return sum;
}

std::vector<ContourChain> read_chains(TextLines& lines) {
  std::vector<ContourChain> chains;
  std::size_t left = kMostSteps;
  for (;;) {
    lines.need_next("-1 -1");
    ContourChain chain;
    chain.x = static_cast<int>(lines.whole_word("x", -1, kFarthest_px));
    chain.y = static_cast<int>(lines.whole_word("y", -1, kFarthest_px));
    if (chain.x == -1 && chain.y == -1) break;
    if (chain.x < 0 || chain.y < 0) lines.fail("a contour begins outside of the picture");
    read_steps(lines, left, chain.steps);
    const Step last = closing_step(chain);
    if (std::abs(last.right) > 1 || std::abs(last.up) > 1)
      lines.fail("a contour does not come back to where it begins");
    chains.push_back(std::move(chain));
  }
  lines.end_line();
  if (lines.next()) lines.fail("something follows after -1 -1");
  return chains;
}

// Sums over the pixels that a chain goes through, each as often as it does.
struct ChainSums {
  double pixels = 0, length = 0, twice_area = 0;
  double x = 0, y = 0;
  double xx = 0, xy = 0, yy = 0, xxx = 0, xxy = 0, xyy = 0, yyy = 0;  // about a centre
};

template <typename Visit>
void each_pixel(const ContourChain& chain, const Visit& visit) {
  double x = chain.x, y = chain.y;
  for (const char letter : chain.steps) {
    const Step step = step_of(letter);
    visit(x, y, step);
    x += step.right;
    y += step.up;
  }
  visit(x, y, closing_step(chain));
}

ChainSums sums_of(const ContourChain& chain) {
  ChainSums s;
  each_pixel(chain, [&](double x, double y, Step step) {
    s.pixels += 1;
    s.x += x;
    s.y += y;
    s.twice_area += x * step.up - y * step.right;
    s.length += std::sqrt(static_cast<double>(step.right * step.right + step.up * step.up));
  });
  const double centre_x = s.x / s.pixels, centre_y = s.y / s.pixels;
  each_pixel(chain, [&](double x, double y, Step) {
    const double u = x - centre_x, v = y - centre_y;
    s.xx += u * u;
    s.xy += u * v;
    s.yy += v * v;
    s.xxx += u * u * u;
    s.xxy += u * u * v;
    s.xyy += u * v * v;
    s.yyy += v * v * v;
  });
  return s;
}

// See graph_node.h.
Moments divided_moments(const ChainSums& s) {
  const double by = s.pixels * s.length * s.length;
  const auto divided = [by](double sum) { return static_cast<float>(sum / by); };
  return {divided(s.xx),  divided(s.xy),  divided(s.yy), divided(s.xxx),
          divided(s.xxy), divided(s.xyy), divided(s.yyy)};
}

}  // namespace

std::string chains_text(const std::vector<ContourChain>& chains) {
  std::string text;
  for (const ContourChain& chain : chains) {
    fmt::format_to(std::back_inserter(text), "{} {}", chain.x, chain.y);
    if (!chain.steps.empty()) text += ' ';
    append_steps(chain.steps, text);
    text += '\n';
  }
  return text + "-1 -1\n";
}

Result<std::vector<ContourChain>> parse_chains(std::string_view text, std::string_view name) {
  return parsed_text(text, name,
                     "a line is X Y CHAIN, steps A to H with a number before each that "
                     "is repeated, and -1 -1 at the end",
                     read_chains);
}

AttributeVector attributes_of(const ContourChain& chain) {
  const ChainSums s = sums_of(chain);
  AttributeVector attributes{};
  // Pick: pixels within and on the contour, from the area through their centres.
  attributes[0] =
      std::llround(std::abs(s.twice_area) / 2 + s.pixels / 2 + (s.length > 0 ? 1 : 0.5));
  if (s.length > 0) {
    const std::array<float, 4> hu = hu_invariants(divided_moments(s));
    for (std::size_t k = 0; k < 4; ++k)
      attributes[1 + k] = std::llround(static_cast<double>(hu[k]) * 1e6);
  }
  attributes[5] = static_cast<std::int64_t>(s.x / s.pixels);
  attributes[6] = static_cast<std::int64_t>(s.y / s.pixels);
  return attributes;
}

}  // namespace aspect
