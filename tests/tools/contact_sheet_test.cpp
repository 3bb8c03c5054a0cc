#include "tools/draw/contact_sheet.h"

#include <catch2/catch.hpp>
#include <vector>

namespace aspect {
namespace {

cv::Mat plain(int width_px, int height_px, int type = CV_8UC3) {
  return {height_px, width_px, type, cv::Scalar::all(200)};
}

TEST_CASE("A contact sheet without pictures is empty") {
  CHECK(contact_sheet({}, 3).empty());
}

TEST_CASE("A contact sheet has room for the largest picture in every cell") {
  const std::vector<SheetPicture> pictures = {
      {plain(100, 50), "first"}, {plain(80, 120), "second"}, {plain(10, 10), ""},
      {plain(1, 1), "x"},        {cv::Mat(), "none"},
  };
  for (int columns = 1; columns <= 7; ++columns) {
    const cv::Mat sheet = contact_sheet(pictures, columns);
    const int rows = (5 + columns - 1) / columns;
    const int step = 120 + caption_height_px({100, 120}) + kSheetMargin_px;
    CHECK(sheet.cols == columns * (100 + kSheetMargin_px) + kSheetMargin_px);
    CHECK(sheet.rows == rows * step + kSheetMargin_px);
    CHECK(sheet.type() == CV_8UC3);
  }
}

TEST_CASE("Pictures of a contact sheet stand in the middle of their cells") {
  const std::vector<SheetPicture> pictures = {{plain(40, 40), ""}, {plain(20, 10), ""}};
  const cv::Mat sheet = contact_sheet(pictures, 2);
  const cv::Vec3b light(200, 200, 200);
  const int left = 2 * kSheetMargin_px + 40 + 10, top = kSheetMargin_px + 15;
  CHECK(sheet.at<cv::Vec3b>(top, left) == light);
  CHECK(sheet.at<cv::Vec3b>(top + 9, left + 19) == light);
  CHECK(sheet.at<cv::Vec3b>(top - 1, left) != light);
  CHECK(sheet.at<cv::Vec3b>(top + 10, left + 19) != light);
}

TEST_CASE("Grey and transparent pictures go onto a contact sheet too") {
  const std::vector<SheetPicture> pictures = {{plain(4, 4, CV_8UC1), "grey"},
                                              {plain(4, 4, CV_8UC4), "alpha"}};
  const cv::Mat sheet = contact_sheet(pictures, 2);
  CHECK(sheet.at<cv::Vec3b>(kSheetMargin_px, kSheetMargin_px) == cv::Vec3b(200, 200, 200));
}

TEST_CASE("A caption stays below its own picture") {
  const std::string text(300, 'W');
  const std::vector<SheetPicture> pictures = {{plain(60, 40), text}, {plain(60, 40), ""}};
  const std::vector<SheetPicture> silent = {{plain(60, 40), ""}, {plain(60, 40), ""}};
  const cv::Mat sheet = contact_sheet(pictures, 2);
  cv::Mat change;
  cv::absdiff(sheet, contact_sheet(silent, 2), change);
  const cv::Rect strip(kSheetMargin_px, kSheetMargin_px + 40, 60, caption_height_px({60, 40}));
  CHECK(cv::countNonZero(change(strip).clone().reshape(1)) > 0);
  change(strip).setTo(0);
  CHECK(cv::countNonZero(change.reshape(1)) == 0);
}

}  // namespace
}  // namespace aspect
