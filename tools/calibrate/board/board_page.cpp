#include "tools/calibrate/board/board_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace aspect {
namespace {

constexpr double kRim_mm = 5;       // that most printers leave white
constexpr double kCaption_mm = 10;  // below the board
constexpr double kRuler_mm = 100, kText_mm = 3;
constexpr double kPoint_mm = 25.4 / 72;

// In mm from the paper's upper left corner.
struct Layout {
  double width_mm = 0, height_mm = 0;
  std::vector<BlackBox> boxes;
  double text_x_mm = 0, text_y_mm = 0;  // where the caption begins, on its base line
  std::string caption;
};

// A line with a tick at each end, as boxes.
void add_ruler(double x, double y, std::vector<BlackBox>& boxes) {
  constexpr double kLine_mm = 0.2, kTick_mm = 2;
  boxes.push_back({x, y - kLine_mm / 2, kRuler_mm, kLine_mm});
  for (const double end : {x, x + kRuler_mm - kLine_mm})
    boxes.push_back({end, y - kTick_mm / 2, kLine_mm, kTick_mm});
}

Result<Layout> layout_of(const Board& board, const Paper& paper) {
  const double width = board.columns * board.square_mm, height = board.rows * board.square_mm;
  Layout layout;
  const auto fits = [&](double paper_width, double paper_height) {
    return width + 2 * kRim_mm <= paper_width && height + 2 * kRim_mm + kCaption_mm <= paper_height;
  };
  if (fits(paper.width_mm, paper.height_mm)) {
    layout = {paper.width_mm, paper.height_mm, {}, 0, 0, {}};
  } else if (fits(paper.height_mm, paper.width_mm)) {
    layout = {paper.height_mm, paper.width_mm, {}, 0, 0, {}};
  } else {
    const double across = std::max(paper.width_mm, paper.height_mm) - 2 * kRim_mm,
                 down = std::min(paper.width_mm, paper.height_mm) - 2 * kRim_mm - kCaption_mm;
    const double longer = std::max(board.columns, board.rows),
                 shorter = std::min(board.columns, board.rows);
    return Error{fmt::format(
        "{} x {} squares of {} mm do not fit on {} x {} mm of paper; squares of {:.1f} mm do",
        board.columns, board.rows, board.square_mm, paper.width_mm, paper.height_mm,
        static_cast<int>(10 * std::min(across / longer, down / shorter)) / 10.0)};
  }
  const double left = (layout.width_mm - width) / 2;
  const double top = std::max(kRim_mm, (layout.height_mm - height - kCaption_mm) / 2);
  layout.boxes = black_boxes(board);
  for (BlackBox& box : layout.boxes) {
    box.x_mm += left;
    box.y_mm += top;
  }
  const double below = top + height + kCaption_mm;
  const double start = std::max(kRim_mm, std::min(left, layout.width_mm - kRim_mm - kRuler_mm));
  add_ruler(start, below - 5, layout.boxes);
  layout.text_x_mm = start;
  layout.text_y_mm = below;
  layout.caption =
      fmt::format("print at 100 %: the line above is {} mm long; aspect-calibrate camera {}",
                  kRuler_mm, words_of(board));
  return layout;
}

// Objects one after the other, then where each of them begins.
std::string pdf_file(const std::string& page, const std::string& content) {
  const std::array<std::string, 5> objects = {
      "<< /Type /Catalog /Pages 2 0 R /ViewerPreferences << /PrintScaling /None >> >>",
      "<< /Type /Pages /Kids [3 0 R] /Count 1 >>", page,
      fmt::format("<< /Length {} >>\nstream\n{}endstream", content.size(), content),
      "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>"};
  std::string file = "%PDF-1.4\n", places;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    places += fmt::format("{:010} 00000 n \n", file.size());
    file += fmt::format("{} 0 obj\n{}\nendobj\n", k + 1, objects[k]);
  }
  return file + fmt::format(
                    "xref\n0 {0}\n0000000000 65535 f \n{1}trailer\n<< /Size {0} /Root 1 0 R >>\n"
                    "startxref\n{2}\n%%EOF\n",
                    objects.size() + 1, places, file.size());
}

}  // namespace

Result<std::string> board_svg(const Board& board, const Paper& paper) {
  const Result<Layout> layout = layout_of(board, paper);
  if (!layout) return Error{layout.error()};
  const Layout& page = layout.value();
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" "
      "viewBox=\"0 0 {0} {1}\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n"
      "<g shape-rendering=\"crispEdges\">\n",
      page.width_mm, page.height_mm);
  for (const BlackBox& box : page.boxes)
    svg += fmt::format("<rect x=\"{:.4f}\" y=\"{:.4f}\" width=\"{:.4f}\" height=\"{:.4f}\"/>\n",
                       box.x_mm, box.y_mm, box.width_mm, box.height_mm);
  return svg + fmt::format(
                   "</g>\n<text x=\"{:.4f}\" y=\"{:.4f}\" font-family=\"Helvetica, Arial, "
                   "sans-serif\" font-size=\"{}\">{}</text>\n</svg>\n",
                   page.text_x_mm, page.text_y_mm, kText_mm, page.caption);
}

// PDF counts points upwards from the lower left corner; the matrix makes them mm downwards.
Result<std::string> board_pdf(const Board& board, const Paper& paper) {
  const Result<Layout> layout = layout_of(board, paper);
  if (!layout) return Error{layout.error()};
  const Layout& page = layout.value();
  const double width = page.width_mm / kPoint_mm, height = page.height_mm / kPoint_mm;
  std::string content = fmt::format("q\n{0:.6f} 0 0 {1:.6f} 0 {2:.4f} cm\n0 g\n", 1 / kPoint_mm,
                                    -1 / kPoint_mm, height);
  for (const BlackBox& box : page.boxes)
    content += fmt::format("{:.4f} {:.4f} {:.4f} {:.4f} re\n", box.x_mm, box.y_mm, box.width_mm,
                           box.height_mm);
  content +=
      fmt::format("f\nQ\nBT /F1 {:.2f} Tf {:.3f} {:.3f} Td ({}) Tj ET\n", kText_mm / kPoint_mm,
                  page.text_x_mm / kPoint_mm, height - page.text_y_mm / kPoint_mm, page.caption);
  return pdf_file(
      fmt::format("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {:.3f} {:.3f}] /Contents "
                  "4 0 R /Resources << /Font << /F1 5 0 R >> >> >>",
                  width, height),
      content);
}

}  // namespace aspect
