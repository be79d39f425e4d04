#include "tools/common/html_text.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <vector>

namespace markerless_mocap {
namespace {

std::string base64(const std::vector<uint8_t>& bytes) {
  static const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const size_t left = std::min<size_t>(3, bytes.size() - i);
    uint32_t three = bytes[i] << 16;
    if (left > 1) three |= bytes[i + 1] << 8;
    if (left > 2) three |= bytes[i + 2];
    for (size_t k = 0; k < 4; ++k) out += k <= left ? kDigits[three >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

constexpr const char* kStyle =
    "body{font:15px sans-serif;max-width:960px;margin:2em auto;padding:0 1em;color:#222}"
    "h1{font-size:1.5em}h2{font-size:1.15em;margin:1.8em 0 .3em}p{margin:.4em 0;color:#555}"
    "svg{width:100%;display:block}svg text{font-size:12px;fill:#666}"
    "table{border-collapse:collapse}td,th{padding:3px 12px;text-align:left;"
    "border-bottom:1px solid #e4e4e4}td.n,th.n{text-align:right;font-variant-numeric:tabular-nums}"
    "img{max-width:100%}figure{margin:1em 0}figcaption{color:#555}"
    ".views{display:flex;flex-wrap:wrap;gap:10px}.views figure{margin:.3em 0;width:460px}"
    ".cards{display:flex;flex-wrap:wrap;gap:12px;margin:1em 0}"
    ".card{border:1px solid #ddd;border-radius:6px;padding:8px 16px}"
    ".card b{display:block;font-size:1.5em}.card span{color:#666;font-size:.85em}"
    ".key{display:inline-block;width:.8em;height:.8em;margin:0 .3em 0 1em;border-radius:2px}";

}  // namespace

std::string escapeHtml(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

std::string pictureTag(const cv::Mat& image, const std::string& caption) {
  std::vector<uint8_t> jpeg;
  cv::imencode(".jpg", image, jpeg, {cv::IMWRITE_JPEG_QUALITY, 80});
  return "<figure><img src=\"data:image/jpeg;base64," + base64(jpeg) + "\"><figcaption>" +
         escapeHtml(caption) + "</figcaption></figure>\n";
}

std::string htmlPage(const std::string& title, const std::string& body) {
  return "<!DOCTYPE html><html><head><meta charset=\"utf-8\"><title>" + escapeHtml(title) +
         "</title><style>" + kStyle + "</style></head><body>\n<h1>" + escapeHtml(title) +
         "</h1>\n" + body + "</body></html>\n";
}

}  // namespace markerless_mocap
