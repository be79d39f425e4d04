#include "studies/reproduce/hsiao/hsiao_report.h"

#include "studies/reproduce/hsiao/hsiao_film.h"
#include "studies/reproduce/hsiao/hsiao_run.h"
#include "studies/reproduce/hsiao/hsiao_totals.h"
#include "studies/reproduce/hsiao/plane_figure.h"
#include "studies/reproduce/result_cache.h"
#include "tools/common/number_format.h"

namespace markerless_mocap {
namespace {

std::string mm(double value) {
  return formatNumber("%.0f", value);
}

void addJpeg(const Json& jpeg, const std::string& caption, Page* page) {
  if (jpeg.is_string()) page->add({{"kind", "picture"}, {"jpeg", jpeg}, {"caption", caption}});
}

void addParts(const Results& results, Page* page) {
  page->heading("Body parts: original against modified Laplacian, with and without colour votes");
  page->text(
      "Nine sequences, every third frame, the same hulls. Found: share of frames in which the part "
      "overlaps the true one by more than half. Curves: mean distance from the true axis where the "
      "part is found; flesh is not centred on bones, so the torso's best is about 43 mm.");
  std::vector<std::vector<std::string>> rows;
  for (const PartVariant& variant : partVariants()) {
    const PartTotals parts = partsOf(results, variant.name);
    rows.push_back({variant.title, wholePercent(parts.correct), wholePercent(parts.six),
                    wholePercent(parts.found[0]), wholePercent(parts.found[1]),
                    wholePercent((parts.found[2] + parts.found[3]) / 2),
                    wholePercent((parts.found[4] + parts.found[5]) / 2), mm(parts.curve[0]),
                    mm(parts.curve[1]), mm(parts.curve[2]), mm(parts.curve[3])});
  }
  page->table({"", "#voxels right", "#six parts", "#torso", "#head", "#arms", "#legs",
               "#torso's curve, mm", "#head's", "#arms'", "#legs'"},
              rows);
}

void addWeightCurve(Page* page) {
  std::vector<double> distance, weight;
  for (int d = 0; d <= 120; ++d) {
    distance.push_back(d);
    weight.push_back(similarityWeight(d));
  }
  page->heading("Figure 3-13: weight by colour distance (Eq. 3-14)", 3);
  page->text("Added weight over d, the distance of two colours (0 to 255 in each channel).");
  page->lines(distance, "", {{"added weight", weight}}, "", 1.0);
}

void addSiteValues(const Json& figures, Page* page) {
  page->heading("Figure 3-16: curves over the one-dimensional eigenspace", 3);
  addJpeg(figures["3-16"], "image, parts, extracted skeleton", page);
  for (const char* part : {"torso", "arm"}) {
    const Json& curve = figures["site_values"][part];
    if (curve["s"].empty()) continue;
    page->text(std::string(part) + ": coordinates over the site value, from 0 to 1");
    page->lines(
        numbersOf(curve["s"]), "",
        {{"x", numbersOf(curve["x"])}, {"y", numbersOf(curve["y"])}, {"z", numbersOf(curve["z"])}},
        "m");
  }
}

void addFigures(const Results& results, Page* page) {
  const Json& figures = results.at("figures");
  const Json& plane = results.at("plane");
  page->heading("Figures of chapter 3");
  page->heading("Figure 3-6: laboratory, four cameras at the ceiling, 4 px calibration error", 3);
  addJpeg(results.at("laboratory")["images"], "four images, hull from two sides", page);
  page->heading("Figure 3-7: eight cameras in a circle", 3);
  addJpeg(figures["3-7"], "images", page);
  addJpeg(figures["3-7 hull"], "hull", page);
  page->heading("Figure 3-8: eight and four cameras", 3);
  addJpeg(figures["3-8"], "yellow: both; blue: four cameras only", page);
  page->heading("Figures 3-10 and 3-15: original and modified Laplacian", 3);
  addJpeg(figures["3-10"], "original, ended by outliers (Sundaresan)", page);
  addJpeg(figures["3-15"], "modified, ended near the origin", page);
  page->heading("Figures 3-11, 3-12, 3-14: an image", 3);
  for (const char* name : {"original", "modified", "modified, colours"})
    addJpeg(plane[name], name, page);
  addWeightCurve(page);
  addSiteValues(figures, page);
}

void addSequences(const Results& results, Page* page) {
  page->heading("Errors, which the thesis lacks");
  page->text(
      "D: mean distance of fifteen joints from the truth. Published: the whole system as in "
      "config/as_published/hsiao.yaml, all seeds; six parts: share of the frames whose "
      "segmentation "
      "has six parts, and the median of D with and without all six; basic: without the temporal "
      "swarm; default: this package's default method, which measures the person itself.");
  std::vector<std::vector<std::string>> rows;
  for (const HsiaoSequence& sequence : hsiaoSequences()) {
    const Tracked published = trackedOf(publishedRuns(results, sequence.id));
    const Tracked basic = trackedOf({&results.at(sequence.id + "_basic")});
    const Json& ours = results.at(sequence.id + "_default");
    rows.push_back(
        {sequence.id + " " + sequence.name, mm(published.D.mean), mm(published.D.median),
         mm(published.D.max), wholePercent(published.lost), wholePercent(published.reset),
         wholePercent(published.swaps), wholePercent(published.six), mm(published.D_of_six.median),
         mm(published.D_of_fewer.median), mm(basic.D.mean), mm(numberOf(ours["D_mean"])),
         mm(numberOf(ours["D_max"])), wholePercent(numberOf(ours["fraction_without_estimate"]))});
  }
  page->table({"sequence", "#published D, mm", "#median", "#maximum", "#no pose", "#restarts",
               "#sides swapped", "#six parts", "#D with six", "#with fewer", "#basic D, mm",
               "#default D, mm", "#maximum", "#no pose"},
              rows);
  page->text(
      "Parts are lost where limbs touch in a hull of 30 mm voxels: an arm at the side or across "
      "the "
      "chest has no branch of its own in the eigenspace, legs that touch make one loop. A part of "
      "the "
      "model without its curve is not compared, and one branch may then pair with another part. "
      "The "
      "thesis always has six parts and does not say what happens with fewer.");
}

void addStrips(const Results& results, Page* page) {
  page->heading("Film strips (Figures 4-2 to 4-10)");
  page->text(
      "From above: image, hull, parts, part curves with the fitted model in black, body over the "
      "image.");
  int figure = 2;
  for (const HsiaoSequence& sequence : hsiaoSequences()) {
    const Json& run = results.at(sequence.id + "_published_seed1");
    page->heading("Figure 4-" + std::to_string(figure++) + ": " + sequence.id + " " + sequence.name,
                  3);
    if (run.contains("strip")) addJpeg(run["strip"], sequence.motion, page);
    page->text("D over time; gaps: no pose");
    page->lines(numbersOf(run["seconds"]), "s",
                {{"published", numbersOf(run["D"])},
                 {"basic", numbersOf(results.at(sequence.id + "_basic")["D"])}},
                "mm");
  }
}

}  // namespace

void addHsiaoTablesAndFigures(const Results& results, Page* page) {
  addSequences(results, page);
  addStrips(results, page);
  addParts(results, page);
  addFigures(results, page);
}

}  // namespace markerless_mocap
