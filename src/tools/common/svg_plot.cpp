#include "tools/common/svg_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tools/common/html_text.h"

namespace markerless_mocap {
namespace {

// In SVG units.
constexpr double kWidth = 900, kLeft = 46, kRight = 10, kTop = 8, kBottom = 24;
constexpr double kPlotHeight = 170, kBandHeight = 22, kBandStep = 20, kBarHeight = 9, kBarGap = 8;
constexpr double kNameWidth = 90;

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string open(double height) {
  return "<svg viewBox=\"0 0 " + number(kWidth) + ' ' + number(height) + "\">";
}

std::string label(double x, double y, const std::string& anchor, const std::string& text) {
  return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\">" +
         escapeHtml(text) + "</text>";
}

std::string box(double x, double y, double width, double height, const std::string& color,
                const std::string& title) {
  return "<rect x=\"" + number(x) + "\" y=\"" + number(y) + "\" width=\"" + number(width) +
         "\" height=\"" + number(height) + "\" fill=\"" + color + "\"><title>" + escapeHtml(title) +
         "</title></rect>";
}

std::string line(double x0, double y0, double x1, double y1) {
  return "<path d=\"M" + number(x0) + ' ' + number(y0) + 'L' + number(x1) + ' ' + number(y1) +
         "\" stroke=\"#ddd\"/>";
}

double largest(const std::vector<double>& values) {
  double most = 0.0;
  for (const double value : values)
    if (std::isfinite(value)) most = std::max(most, value);
  return most;
}

/// The next multiple of a round step above the value.
double roundTop(double value) {
  if (!(value > 0.0)) return 1.0;
  const double step = niceTickStep(value, 5);
  return step * std::ceil(value / step - 1e-9);
}

/// The time axis of plots and bands.
class TimeAxis {
 public:
  explicit TimeAxis(const std::vector<double>& seconds) : seconds_(seconds) {
    begin_ = seconds.empty() ? 0.0 : seconds.front();
    const double last = seconds.empty() ? 0.0 : seconds.back();
    const size_t steps = seconds.size() < 2 ? 1 : seconds.size() - 1;
    // The last frame is as long as the others on average.
    end_ = last > begin_ ? last + (last - begin_) / double(steps) : begin_ + 1.0;
  }
  double at(double seconds) const {
    return kLeft + (kWidth - kLeft - kRight) * (seconds - begin_) / (end_ - begin_);
  }
  double left(size_t i) const { return at(seconds_[i]); }
  double right(size_t i) const { return at(endOf(i)); }
  double endOf(size_t i) const { return i + 1 < seconds_.size() ? seconds_[i + 1] : end_; }
  std::string ticks(double height, const std::string& unit) const {
    const double step = niceTickStep(end_ - begin_, 10);
    std::string out;
    for (double t = step * std::ceil(begin_ / step); t <= end_; t += step)
      out += line(at(t), kTop, at(t), height - kBottom) +
             label(at(t), height - 8, "middle", number(std::round(t / step) * step) + unit);
    return out;
  }

 private:
  const std::vector<double>& seconds_;
  double begin_, end_;
};

/// Horizontal grid lines with their values.
std::string valueTicks(double top, double height, const std::string& unit) {
  const double step = niceTickStep(top, 5);
  std::string out;
  for (double value = 0.0; value < top + 1e-9 * top; value += step) {
    const double y = height - kBottom - (height - kTop - kBottom) * value / top;
    const bool last = value + step > top + 1e-9 * top;
    out += line(kLeft, y, kWidth - kRight, y) +
           label(kLeft - 4, y + 4, "end", number(value) + (last ? " " + unit : ""));
  }
  return out;
}

std::string curve(const TimeAxis& axis, const PlotSeries& line, double top, double height) {
  std::string path;
  bool drawing = false;
  for (size_t i = 0; i < line.values.size(); ++i) {
    if (std::isfinite(line.values[i])) {
      const double fraction = std::clamp(line.values[i] / top, 0.0, 1.0);
      const double y = height - kBottom - (height - kTop - kBottom) * fraction;
      path += (drawing ? "L" : "M") + number(axis.left(i)) + ' ' + number(y);
      if (!drawing) path += "h0";  // with round line caps, a single value is a dot
    }
    drawing = std::isfinite(line.values[i]);
  }
  return "<path fill=\"none\" stroke-width=\"1.8\" stroke-linecap=\"round\" "
         "stroke-linejoin=\"round\" stroke=\"" +
         line.color + "\" d=\"" + path + "\"/>";
}

bool isEqual(const BandCell& a, const BandCell& b) {
  return a.color == b.color && a.title == b.title;
}

std::string joinedCells(const TimeAxis& axis, const std::vector<double>& seconds,
                        const std::vector<BandCell>& cells, double y) {
  std::string svg;
  for (size_t first = 0, next = 0; first < cells.size(); first = next) {
    while (next < cells.size() && isEqual(cells[first], cells[next])) ++next;
    char span[48];
    std::snprintf(span, sizeof span, ", %.2f s to %.2f s", seconds[first], axis.endOf(next - 1));
    svg += box(axis.left(first), y, axis.right(next - 1) - axis.left(first), kBandStep - 3,
               cells[first].color, cells[first].title + span);
  }
  return svg;
}

}  // namespace

double niceTickStep(double range, int parts) {
  if (!(range > 0.0)) return 1.0;
  const double least = range / parts;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least * (1 - 1e-9)) return factor * power;
  return 10.0 * power;
}

std::string linePlot(const std::vector<double>& seconds, const std::vector<PlotSeries>& lines,
                     double top, const std::string& unit, const std::string& across) {
  if (top == 0.0)
    for (const PlotSeries& line : lines) top = std::max(top, roundTop(largest(line.values)));
  const TimeAxis axis(seconds);
  std::string svg =
      open(kPlotHeight) + axis.ticks(kPlotHeight, across) + valueTicks(top, kPlotHeight, unit);
  for (const PlotSeries& line : lines) svg += curve(axis, line, top, kPlotHeight);
  return svg + "</svg>\n";
}

std::string timeBand(const std::vector<double>& seconds, const std::vector<BandCell>& cells) {
  const TimeAxis axis(seconds);
  std::string svg = open(kBandHeight);
  for (size_t i = 0; i < cells.size(); ++i)
    svg += box(axis.left(i), 0, axis.right(i) - axis.left(i) + 0.3, kBandHeight, cells[i].color,
               cells[i].title);
  return svg + "</svg>\n";
}

std::string timeBands(const std::vector<double>& seconds, const std::vector<NamedBand>& bands) {
  const TimeAxis axis(seconds);
  const double height = kTop + kBandStep * double(bands.size()) + kBottom;
  std::string svg = open(height) + axis.ticks(height, " s");
  for (size_t i = 0; i < bands.size(); ++i) {
    const double y = kTop + kBandStep * double(i);
    svg += label(kLeft - 4, y + kBandStep / 2 + 3, "end", bands[i].name) +
           joinedCells(axis, seconds, bands[i].cells, y);
  }
  return svg + "</svg>\n";
}

std::string barChart(const std::vector<BarRow>& rows, const std::vector<std::string>& colors,
                     const std::string& unit) {
  double top = 0.0;
  for (const BarRow& row : rows) top = std::max(top, roundTop(largest(row.values)));
  const double row_height = kBarHeight * double(colors.size()) + kBarGap;
  const double height = kTop + row_height * double(rows.size()) + kBottom;
  const double width = kWidth - kNameWidth - 50;
  std::string svg = open(height);
  const double step = niceTickStep(top, 8);
  for (double value = 0.0; value <= top * (1 + 1e-9); value += step) {
    const double x = kNameWidth + width * value / top;
    svg += line(x, kTop, x, height - kBottom) +
           label(x, height - 8, "middle", number(value) + ' ' + unit);
  }
  for (size_t r = 0; r < rows.size(); ++r) {
    const double y = kTop + row_height * double(r);
    svg += label(kNameWidth - 6, y + row_height / 2 + 2, "end", rows[r].name);
    for (size_t k = 0; k < rows[r].values.size(); ++k)
      if (std::isfinite(rows[r].values[k]))
        svg +=
            box(kNameWidth, y + kBarHeight * double(k), width * rows[r].values[k] / top, kBarHeight,
                colors[k], number(std::round(10 * rows[r].values[k]) / 10) + " " + unit);
  }
  return svg + "</svg>\n";
}

std::string histogram(const std::vector<double>& values, int bins, const std::string& color,
                      const std::string& unit) {
  const double end = roundTop(largest(values));
  std::vector<int> counts(bins, 0);
  for (const double value : values)
    if (std::isfinite(value)) ++counts[std::clamp(int(value / end * bins), 0, bins - 1)];
  const double top = roundTop(*std::max_element(counts.begin(), counts.end()));
  const double width = (kWidth - kLeft - kRight) / bins, tall = kPlotHeight - kTop - kBottom;
  std::string svg = open(kPlotHeight) + valueTicks(top, kPlotHeight, "");
  for (int b = 0; b < bins; ++b) {
    const double height = tall * counts[b] / top;
    svg += box(kLeft + width * b + 0.5, kPlotHeight - kBottom - height, width - 1, height, color,
               std::to_string(counts[b]));
  }
  const double step = niceTickStep(end, 10);
  for (double value = 0.0; value <= end * (1 + 1e-9); value += step)
    svg += label(kLeft + (kWidth - kLeft - kRight) * value / end, kPlotHeight - 8,
                 value >= end * (1 - 1e-9) ? "end" : "middle", number(value) + ' ' + unit);
  return svg + "</svg>\n";
}

std::string plotLegend(const std::vector<PlotSeries>& lines) {
  std::string key;
  for (const PlotSeries& line : lines)
    key += "<span class=\"key\" style=\"background:" + line.color + "\"></span>" +
           escapeHtml(line.name);
  return "<p>" + key + "</p>\n";
}

}  // namespace markerless_mocap
