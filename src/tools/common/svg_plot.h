#pragma once

#include <string>
#include <vector>

namespace markerless_mocap {

/// A curve of a plot; it is interrupted where a value is NaN.
struct PlotSeries {
  std::string name, color;
  std::vector<double> values;
};

/// One cell of a band over time.
struct BandCell {
  std::string color, title;  ///< the title is shown as a tooltip
};

/// A row of bands.
struct NamedBand {
  std::string name;  ///< of a few letters
  std::vector<BandCell> cells;
};

/// A group of bars of a chart.
struct BarRow {
  std::string name;
  std::vector<double> values;
};

/// Curves with axes, as SVG. \param seconds of each value, ascending
/// \param top maximum of the value axis; 0: a round number above all values
/// \param across unit of the horizontal axis
std::string linePlot(const std::vector<double>& seconds, const std::vector<PlotSeries>& lines,
                     double top, const std::string& unit, const std::string& across = " s");

/// Cells over the time axis of linePlot(), as SVG.
std::string timeBand(const std::vector<double>& seconds, const std::vector<BandCell>& cells);

/// Bands one below the other over the time axis of linePlot(), with their names and the times, as
/// SVG. Equal cells in a row are joined; the tooltip tells from when to when they last.
std::string timeBands(const std::vector<double>& seconds, const std::vector<NamedBand>& bands);

/// Horizontal bars, one per colour in each row, as SVG. Bars of NaN are left out.
std::string barChart(const std::vector<BarRow>& rows, const std::vector<std::string>& colors,
                     const std::string& unit);

/// Histogram of the finite values with `bins` equal bins from 0 to a round number.
std::string histogram(const std::vector<double>& values, int bins, const std::string& color,
                      const std::string& unit);

/// Legend: coloured squares with names, as HTML.
std::string plotLegend(const std::vector<PlotSeries>& lines);

/// The smallest round number (1, 2 or 5 times a power of ten) that is at least range / parts.
double niceTickStep(double range, int parts);

}  // namespace markerless_mocap
