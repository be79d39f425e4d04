#include "studies/label_samples/label_samples.h"

#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <string>

#include "capture/studio_fixture.h"
#include "error_text_of.h"
#include "skeleton/labelling/validity_features.h"
#include "tools/common/person_urdf.h"

namespace markerless_mocap {
namespace {

LabelSampleOptions shortFilm() {
  LabelSampleOptions film;
  film.files = packageFiles();
  film.studio.motion = "whirling_dance";
  film.studio.width = 160;
  film.studio.height = 120;
  film.frames = 3;
  film.pitch = 0.04;
  return film;
}

std::map<std::string, std::vector<std::string>> linesByWord(const std::string& text) {
  std::map<std::string, std::vector<std::string>> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    lines[line.substr(0, line.find(' '))].push_back(line);
  return lines;
}

size_t wordsOf(const std::string& line) {
  std::istringstream in(line);
  size_t words = 0;
  for (std::string word; in >> word;) ++words;
  return words;
}

TEST(FilmLabels, EachFrameHasItsEndsWaysAndVerdict) {
  std::ostringstream out;
  writeLabelSamples(shortFilm(), &out);
  auto lines = linesByWord(out.str());
  ASSERT_EQ(lines["frame"].size(), 4u) << out.str();  // one of them with a limb cut off
  ASSERT_EQ(lines["label"].size(), 4u);
  ASSERT_EQ(lines["tree_path_lengths"].size(), 4u);
  size_t ends = 0;
  for (size_t f = 0; f < 4; ++f) {
    const size_t count = std::stoul(lines["frame"][f].substr(6));
    EXPECT_EQ(wordsOf(lines["tree_path_lengths"][f]), 1 + count * count);
    EXPECT_EQ(wordsOf(lines["shortest_path_lengths"][f]), 1 + count * count);
    ends += count;
  }
  ASSERT_EQ(lines["end"].size(), ends);
  for (const std::string& end : lines["end"]) EXPECT_EQ(wordsOf(end), 13u) << end;
  // A dancer whose arms are free: somewhere each end of the body is found.
  int seen = 0;
  for (const std::string& end : lines["end"]) seen |= std::stoi(end.substr(end.rfind(' ')));
  EXPECT_EQ(seen, 31);
  size_t with_features = 0;
  for (const std::string& label : lines["label"])
    with_features += wordsOf(label) == 5 + size_t(kValidityFeatureCount);
  EXPECT_GT(with_features, 0u);
  ASSERT_EQ(lines["validity_features"].size(), 1u);
  EXPECT_EQ(wordsOf(lines["validity_features"].front()), 1 + size_t(kValidityFeatureCount));
  EXPECT_EQ(lines["validity_features"].front().find("validity_features names_odds arms_offset "),
            0u);
  ASSERT_EQ(lines["ranking"].size(), 4u * 4u);  // four published labellings of each hull
  for (const std::string& ranking : lines["ranking"]) EXPECT_EQ(wordsOf(ranking), 4u) << ranking;
  EXPECT_EQ(lines["ranking"].front().find("ranking defaults "), 0u);
  EXPECT_EQ(lines["ranking"][1].find("ranking published "), 0u);
  std::string cut;
  for (const std::string& frame : lines["frame"]) cut += frame.back();
  EXPECT_EQ(cut, "0100");  // after the first frame
}

TEST(FilmLabels, SameOptionsGiveTheSameSamples) {
  std::ostringstream first, second;
  writeLabelSamples(shortFilm(), &first);
  writeLabelSamples(shortFilm(), &second);
  EXPECT_EQ(first.str(), second.str());
}

TEST(FilmLabels, WhatCannotBeFilmedIsSaid) {
  LabelSampleOptions film = shortFilm();
  film.frames = 0;
  std::ostringstream out;
  EXPECT_EQ(errorTextOf([&] { writeLabelSamples(film, &out); }), "frames must be at least 1");
  film.frames = 2;
  film.interrupted = [] { return true; };
  EXPECT_EQ(errorTextOf<std::runtime_error>([&] { writeLabelSamples(film, &out); }), "interrupted");
}

}  // namespace
}  // namespace markerless_mocap
