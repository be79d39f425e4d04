#include "pages/page.h"

#include <opencv2/imgcodecs.hpp>

#include "pages/page_resources.h"

namespace markerless_mocap {
namespace {

constexpr int kPictureQuality = 80;

Json linesJson(const std::vector<PlotLine>& lines) {
  Json out = Json::array();
  for (const PlotLine& line : lines)
    out.push_back({{"name", line.name}, {"color", line.color}, {"values", packed(line.values)}});
  return out;
}

/// The template with each <!--name--> replaced.
std::string filled(std::string text, const std::vector<std::pair<std::string, std::string>>& by) {
  for (const auto& [name, value] : by) {
    const std::string mark = "<!--" + name + "-->";
    text.replace(text.find(mark), mark.size(), value);
  }
  return text;
}

/// JSON that cannot end the script element in which it stands.
std::string scriptData(const Json& json) {
  std::string out;
  for (const char c : jsonText(json, -1)) {
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  }
  return out;
}

}  // namespace

std::string base64(const void* bytes, size_t count) {
  static const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto* in = static_cast<const uint8_t*>(bytes);
  std::string out;
  out.reserve((count + 2) / 3 * 4);
  for (size_t i = 0; i < count; i += 3) {
    const size_t left = std::min<size_t>(3, count - i);
    uint32_t three = in[i] << 16;
    if (left > 1) three |= in[i + 1] << 8;
    if (left > 2) three |= in[i + 2];
    for (size_t k = 0; k < 4; ++k) out += k <= left ? kDigits[three >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

std::string packed(const std::vector<float>& values) {
  return base64(values.data(), values.size() * sizeof(float));
}

std::string packed(const std::vector<double>& values) {
  return packed(std::vector<float>(values.begin(), values.end()));
}

std::string packedJpeg(const cv::Mat& image, int quality) {
  std::vector<uint8_t> jpeg;
  cv::imencode(".jpg", image, jpeg, {cv::IMWRITE_JPEG_QUALITY, quality});
  return base64(jpeg.data(), jpeg.size());
}

Json joinedCells(const std::vector<BandCell>& cells) {
  Json runs = Json::array();
  for (size_t first = 0, next = 0; first < cells.size(); first = next) {
    while (next < cells.size() && cells[first] == cells[next]) ++next;
    runs.push_back({first, next, cells[first].state, cells[first].why});
  }
  return runs;
}

std::string jsonText(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

void Page::heading(const std::string& text, int level) {
  add({{"kind", "heading"}, {"text", text}, {"level", level}});
}

void Page::text(const std::string& text, bool strong) {
  add({{"kind", "text"}, {"text", text}, {"strong", strong}});
}

void Page::cards(const std::vector<std::pair<std::string, std::string>>& figures) {
  Json cards = Json::array();
  for (const auto& [value, meaning] : figures)
    cards.push_back({{"value", value}, {"meaning", meaning}});
  add({{"kind", "cards"}, {"cards", cards}});
}

void Page::table(const std::vector<std::string>& head,
                 const std::vector<std::vector<std::string>>& rows) {
  add({{"kind", "table"}, {"head", head}, {"rows", rows}});
}

void Page::lines(const std::vector<double>& x, const std::string& across,
                 const std::vector<PlotLine>& lines, const std::string& unit, double top) {
  add({{"kind", "lines"},
       {"x", packed(x)},
       {"across", across},
       {"unit", unit},
       {"top", top},
       {"lines", linesJson(lines)}});
}

void Page::timeLines(const std::vector<PlotLine>& lines, const std::string& unit, double top) {
  add({{"kind", "lines"}, {"unit", unit}, {"top", top}, {"lines", linesJson(lines)}});
}

void Page::bands(const std::vector<BandState>& states, const std::vector<Band>& bands) {
  Json part{{"kind", "bands"}, {"states", Json::array()}, {"bands", Json::array()}};
  for (const BandState& state : states)
    part["states"].push_back({{"name", state.name}, {"color", state.color}});
  for (const Band& band : bands)
    part["bands"].push_back({{"name", band.name}, {"runs", joinedCells(band.cells)}});
  add(part);
}

void Page::bars(const std::vector<std::string>& names,
                const std::vector<std::pair<std::string, std::vector<double>>>& rows,
                const std::string& unit) {
  Json out = Json::array();
  for (const auto& [name, values] : rows) out.push_back({{"name", name}, {"values", values}});
  add({{"kind", "bars"}, {"names", names}, {"rows", out}, {"unit", unit}});
}

void Page::histogram(const std::vector<double>& values, const std::string& unit) {
  add({{"kind", "histogram"}, {"values", packed(values)}, {"unit", unit}});
}

void Page::picture(const cv::Mat& image, const std::string& caption) {
  add({{"kind", "picture"}, {"jpeg", packedJpeg(image, kPictureQuality)}, {"caption", caption}});
}

std::string Page::html() const {
  const auto plays = [](const Json& part) { return part["kind"] == "player"; };
  const bool has_player = std::any_of(parts_.begin(), parts_.end(), plays);
  return filled(pageHtml(), {{"style", pageStyle()},
                             {"library", has_player ? threeJs() + orbitControlsJs() : ""},
                             {"script", pagePartsJs() + (has_player ? pagePlayerJs() : "")},
                             {"data", scriptData(content())}});
}

}  // namespace markerless_mocap
