#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "calibration/board.h"
#include "capture/studio_options.h"
#include "markerless_mocap/pipeline/pipeline.h"
#include "option_list.h"
#include "ros/node_options.h"
#include "tools/common/person_urdf.h"

// The comment at the member of an options struct says what the loader, the manual and
// config/all_options.yaml say, in the same words.

namespace markerless_mocap {
namespace {

namespace fs = std::filesystem;

using Comments = std::map<std::string, std::string>;

/// Comments of the data members by their names; those declared together ("lower, upper") by both.
Comments commentsOfBody(const std::string& body) {
  static const std::regex kComment("^  /// (.*)$");
  static const std::regex kMember(R"(^  (?!static)[\w:<>, ]+? ((?:\w+, )?\w+)(?: = .*|\{.*\})?;$)");
  Comments comments;
  std::string comment;
  std::istringstream lines(body);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_match(line, match, kComment)) {
      comment += (comment.empty() ? "" : " ") + match[1].str();
      continue;
    }
    if (std::regex_match(line, match, kMember)) comments[match[1]] = comment;
    comment.clear();
  }
  return comments;
}

constexpr const char* kVisit = "  void visit(OptionVisitor& v);\n";

/// Adds the options structs of a header.
void readStructs(const std::string& header, std::map<std::string, Comments>* structs) {
  static const std::regex kStruct(R"(\nstruct (\w+) \{\n)");
  for (std::sregex_iterator it(header.begin(), header.end(), kStruct), end; it != end; ++it) {
    const size_t begin = size_t(it->position() + it->length());
    const std::string body = header.substr(begin, header.find("\n};\n", begin) + 1 - begin);
    if (body.find(kVisit) != std::string::npos) (*structs)[(*it)[1]] = commentsOfBody(body);
  }
}

/// Members' comments of every options struct in the sources, by the struct's name.
std::map<std::string, Comments> readStructs() {
  std::map<std::string, Comments> structs;
  for (const char* folder : {"/include", "/src"})
    for (const auto& entry :
         fs::recursive_directory_iterator(MOCAP_SOURCE_DIR + std::string(folder)))
      if (entry.path().extension() == ".h") readStructs(readText(entry.path()), &structs);
  return structs;
}

class OptionComments : public testing::Test {
 protected:
  /// \param flat members whose fields the struct shows as its own
  template <class OptionsT>
  void expectSame(const std::string& name, const std::set<std::string>& flat = {}) {
    seen_.insert(name);
    const Comments comments = structs_[name];
    Comments meanings;
    for (const auto& entry : optionsOf(OptionsT()))
      if (entry.path.find('/') == std::string::npos) meanings[entry.path] = entry.meaning;
    for (const auto& [member, comment] : comments) {
      if (flat.count(member)) continue;
      ASSERT_EQ(meanings.count(member), 1u) << name << "::" << member << " has no key of its name";
      EXPECT_EQ(comment, meanings[member]) << name << "::" << member;
      EXPECT_FALSE(comment.empty()) << name << "::" << member;
      meanings.erase(member);
    }
    if (!flat.empty()) return;
    for (const auto& rest : meanings) ADD_FAILURE() << name << " has no member " << rest.first;
  }

  std::map<std::string, Comments> structs_ = readStructs();
  std::set<std::string> seen_;
};

TEST_F(OptionComments, AreTheMeaningsThatTheLoaderGives) {
  expectSame<SilhouetteOptions>("SilhouetteOptions");
  expectSame<NetworkOptions>("NetworkOptions");
  expectSame<HullOptions>("HullOptions");
  expectSame<SegmentationOptions>("SegmentationOptions");
  expectSame<ColorBonus>("ColorBonus");
  expectSame<SplineWalkOptions>("SplineWalkOptions");
  expectSame<PoseTreeOptions>("PoseTreeOptions");
  expectSame<LimbRatios>("LimbRatios");
  expectSame<TrackerOptions>("TrackerOptions", {"person"});
  expectSame<PersonOptions>("PersonOptions");
  expectSame<FilterOptions>("FilterOptions");
  expectSame<ContourOptions>("ContourOptions");
  expectSame<HsiaoOptions>("HsiaoOptions");
  expectSame<FleischmannOptions>("FleischmannOptions", {"image", "swarm", "body"});
  expectSame<FleischmannSwarmOptions>("FleischmannSwarmOptions");
  expectSame<FleischmannBodyOptions>("FleischmannBodyOptions");
  expectSame<FleischmannImageOptions>("FleischmannImageOptions");
  expectSame<StudioOptions>("StudioOptions", {"character", "degradations"});
  expectSame<CharacterOptions>("CharacterOptions");
  expectSame<DegradationOptions>("DegradationOptions");
  expectSame<SilhouetteNodeOptions>("SilhouetteNodeOptions");
  expectSame<HullNodeOptions>("HullNodeOptions");
  expectSame<FittingNodeOptions>("FittingNodeOptions");
  expectSame<StudioNodeOptions>("StudioNodeOptions");
  expectSame<UsbCameraOptions>("UsbCameraOptions");
  expectSame<BoardOptions>("BoardOptions");
  for (const auto& entry : optionsOf(HsiaoLimits::fromThesis()))  // a key per angle, two arrays
    EXPECT_EQ(structs_["HsiaoLimits"]["lower, upper"], entry.meaning) << entry.path;
  seen_.insert("HsiaoLimits");
  for (const auto& entry : structs_) EXPECT_TRUE(seen_.count(entry.first)) << entry.first;
}

TEST_F(OptionComments, ReaderOfCommentsSeesEveryKindOfMember) {
  const Comments comments = commentsOfBody(
      "  static constexpr const char* kStage = \"sample\";\n"
      "  /// edge of a voxel,\n  /// m\n  double pitch = 0.03;\n"
      "  /// m in world\n  Eigen::Vector3d corner{0.0, 0.0, 0.0};\n"
      "  std::vector<std::string> names;\n\n"
      "  /// checks\n  void validate() const;\n"
      "  /// rad\n  std::array<double, 16> lower, upper;\n"
      "  /// all\n  Limits limits = Limits::standard();\n"
      "  std::vector<double> trust(const Rig& rig) const;\n");
  EXPECT_EQ(comments, (Comments{{"pitch", "edge of a voxel, m"},
                                {"corner", "m in world"},
                                {"names", ""},
                                {"lower, upper", "rad"},
                                {"limits", "all"}}));
}

}  // namespace
}  // namespace markerless_mocap
