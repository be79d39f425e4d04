#pragma once

#include <nlohmann/json.hpp>
#include <opencv2/core/mat.hpp>
#include <string>
#include <utility>
#include <vector>

namespace markerless_mocap {

using Json = nlohmann::ordered_json;

/// A curve of a plot; it is interrupted where a value is NaN.
struct PlotLine {
  std::string name;
  std::vector<double> values;
  std::string color = "";  ///< of CSS; empty: the next of the page's colours
};

/// What a cell of a band over time can say, and its colour.
struct BandState {
  std::string name, color;
};
struct BandCell {
  size_t state = 0;  ///< of the band's states
  std::string why;   ///< shown when one points at it
  bool operator==(const BandCell& o) const { return state == o.state && why == o.why; }
};
/// One cell per frame.
struct Band {
  std::string name;
  std::vector<BandCell> cells;
};

/// A self-contained HTML page. Its content is data, which templates/ of this package shows; nothing
/// is loaded from elsewhere. Parts are shown in the order in which they are added.
class Page {
 public:
  explicit Page(std::string title) : title_(std::move(title)) {}

  /// \param level 2 or 3, of <h2> and <h3>
  void heading(const std::string& text, int level = 2);
  void text(const std::string& text, bool strong = false);
  /// Large figures with what they mean.
  void cards(const std::vector<std::pair<std::string, std::string>>& figures);
  /// \param head names of the columns; with a leading # the column holds figures
  void table(const std::vector<std::string>& head,
             const std::vector<std::vector<std::string>>& rows);
  /// Curves. \param x of each value, ascending \param across unit of x
  /// \param top maximum of the value axis; 0: a round number above all values
  void lines(const std::vector<double>& x, const std::string& across,
             const std::vector<PlotLine>& lines, const std::string& unit, double top = 0.0);
  /// Curves with a value for each frame of the page's player; as lines().
  void timeLines(const std::vector<PlotLine>& lines, const std::string& unit, double top = 0.0);
  /// Bands over the frames of the page's player.
  void bands(const std::vector<BandState>& states, const std::vector<Band>& bands);
  /// Horizontal bars, one per name in each row; NaN: none.
  void bars(const std::vector<std::string>& names,
            const std::vector<std::pair<std::string, std::vector<double>>>& rows,
            const std::string& unit);
  /// How many of the finite values lie in each of 40 equal bins.
  void histogram(const std::vector<double>& values, const std::string& unit);
  /// \param image CV_8UC3; shown as JPEG
  void picture(const cv::Mat& image, const std::string& caption);
  /// A part that templates/ shows by its member "kind".
  void add(Json part) { parts_.push_back(std::move(part)); }

  /// The content as JSON: {"title", "parts"}.
  Json content() const { return {{"title", title_}, {"parts", parts_}}; }
  std::string html() const;

 private:
  std::string title_;
  Json parts_ = Json::array();
};

/// Bytes in base64.
std::string base64(const void* bytes, size_t count);
/// Numbers as base64 of 32-bit floats, little endian; NaN stays NaN.
std::string packed(const std::vector<float>& values);
std::string packed(const std::vector<double>& values);
/// A JPEG in base64. \param image CV_8UC3 or CV_8UC1
std::string packedJpeg(const cv::Mat& image, int quality);
/// Equal cells in a row joined: [first frame, frame after the last, state, why].
Json joinedCells(const std::vector<BandCell>& cells);

/// The text of a JSON value for a file: indented, null where a number is not finite; bytes that are
/// no UTF-8 are replaced.
std::string jsonText(const Json& json, int indent = 1);

}  // namespace markerless_mocap
