#include "tools/offline/preparation.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "files/text_file.h"
#include "files/whole_file.h"
#include "files/yaml_text.h"
#include "markerless_mocap/silhouette/silhouette_extractor.h"
#include "markerless_mocap/tracking/shape_file.h"
#include "ros/package_files.h"
#include "silhouette/image_cycle.h"
#include "tools/offline/recording_backgrounds.h"

namespace markerless_mocap {
namespace {

constexpr const char* kRecording = "recording";
constexpr const char* kFirstImages = "first_images";
constexpr const char* kNone = "none";  ///< masks, or a network
constexpr int kMostPasses = 4;  ///< of SilhouetteOptions::background_frames, where images lack
constexpr double kTimeConstants = 12.0;  ///< of the background's following, before a part begins
constexpr double kEndBefore_s = 1e-6;    ///< the last image before a part is not its first one

std::string backgroundFile(const std::string& folder, size_t camera) {
  return folder + "/camera" + std::to_string(camera) + ".background";
}
std::string bodyFile(const std::string& folder) {
  return folder + "/body.yaml";
}
std::string listFile(const std::string& folder) {
  return folder + "/preparation.yaml";
}

void decideHowToLearn(PipelineOptions* pipeline) {
  if (canLearnFromRecording(pipeline->silhouette)) pipeline->silhouette.background = kFirstImages;
  pipeline->fitting.person.measure = false;
}

void checkModel(const OfflineOptions& options) {
  const std::string& model = options.pipeline.silhouette.model;
  if (options.recording.use_masks || model == "gaussian" || model == "mean_shift" ||
      model == "network")
    return;
  throw std::invalid_argument("a recording cannot be followed in parts with silhouette/model " +
                              model +
                              ", whose background cannot be saved; allowed are gaussian, "
                              "mean_shift and network");
}

/// The backgrounds as the first images of the recording give them.
std::vector<SharedBackground> learnFromFirstImages(const OfflineOptions& options) {
  Recording recording(options.input, options.recording);
  std::vector<SilhouetteExtractor> extractors;
  std::vector<SharedBackground> backgrounds(recording.rig().size());
  if (options.recording.use_masks || options.pipeline.silhouette.model == "network")
    return backgrounds;
  for (size_t i = 0; i < backgrounds.size(); ++i)
    extractors.emplace_back(options.pipeline.silhouette);
  for (int k = 0; k < kMostPasses * options.pipeline.silhouette.background_frames; ++k) {
    const auto frame_set = nextFrameSet(options, &recording);
    if (!frame_set) break;
    for (size_t i = 0; i < backgrounds.size(); ++i) {
      const CameraFrame& frame = frame_set->frames[i];
      if (backgrounds[i] || frame.image.empty() || !frame.mask.empty()) continue;
      extractors[i].update(frame.image);
      backgrounds[i] = extractors[i].background();
    }
    if (std::count(backgrounds.begin(), backgrounds.end(), nullptr) == 0) break;
  }
  return backgrounds;
}

double secondsPerFrameSet(const OfflineOptions& options) {
  Recording recording(options.input, options.recording);
  const auto first = nextFrameSet(options, &recording);
  const auto second = nextFrameSet(options, &recording);
  return first && second ? 1e-9 * double(second->stamp_ns - first->stamp_ns) : 0.0;
}

void save(const SharedBackground& background, const SilhouetteOptions& options,
          const std::string& file) {
  if (!background) return;
  SilhouetteExtractor extractor(options);
  extractor.useBackground(background);
  writeWholeFileBy(file, [&](const std::string& draft) {
    namespace fs = std::filesystem;
    fs::permissions(draft, fs::perms::owner_read | fs::perms::owner_write);  // a picture of a room
    extractor.saveBackground(draft);
    return true;
  });
}

}  // namespace

Preparation prepare(const OfflineOptions& options, const PersonResources& resources,
                    PipelineOptions* pipeline, std::ostream* notes, bool terminal) {
  Preparation prepared;
  OfflineOptions decided = options;
  prepared.backgrounds = learnBackgrounds(options, &decided.pipeline, notes, terminal);
  PersonResources person = resources;
  const TrackerOptions& fitting = options.pipeline.fitting;
  if (fitting.person.measure && needsOf(fitting.method).masks && !person.known_shape)
    measureBody(decided, prepared.backgrounds, &person, notes, terminal);
  prepared.shape = person.known_shape;
  decideHowToLearn(pipeline);
  return prepared;
}

void writePreparation(const OfflineOptions& options, const std::string& folder, std::ostream* notes,
                      bool terminal) {
  checkModel(options);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw std::runtime_error("cannot make the folder " + folder);
  OfflineOptions decided = options;
  const PersonResources resources =
      readPersonResources(options.body_id, options.urdf_template, options.body_file);
  Preparation prepared = prepare(options, resources, &decided.pipeline, notes, terminal);
  std::vector<SharedBackground> first = learnFromFirstImages(decided);
  prepared.backgrounds.resize(first.size());
  YAML::Node list;
  list["measured"] = prepared.shape.has_value();
  for (size_t i = 0; i < first.size(); ++i) {
    const SharedBackground& recording = prepared.backgrounds[i];
    list["backgrounds"].push_back(recording ? kRecording : first[i] ? kFirstImages : kNone);
    save(recording ? recording : first[i], decided.pipeline.silhouette, backgroundFile(folder, i));
  }
  if (prepared.shape) writeBodyFile(bodyFile(folder), *prepared.shape);
  writeWholeFile(listFile(folder), YAML::Dump(list) + "\n");
}

Preparation readPreparation(const OfflineOptions& options, const std::string& folder,
                            size_t cameras, PipelineOptions* pipeline) {
  const YAML::Node list =
      yamlFrom(readTextFile(listFile(folder), listFile(folder)), listFile(folder));
  const YAML::Node kinds = list["backgrounds"];
  if (!kinds || kinds.size() != cameras)
    throw std::invalid_argument(folder + " is of " + std::to_string(kinds.size()) +
                                " cameras, the recording has " + std::to_string(cameras));
  Preparation prepared;
  decideHowToLearn(pipeline);
  if (list["measured"].as<bool>())
    prepared.shape =
        shapeFromYaml(readTextFile(bodyFile(folder), bodyFile(folder)), bodyFile(folder));
  for (size_t i = 0; i < cameras; ++i) {
    const std::string kind = kinds[i].as<std::string>();
    SilhouetteExtractor extractor(pipeline->silhouette);
    if (kind == kRecording || (kind == kFirstImages && options.recording.start > 0.0))
      extractor.loadBackground(backgroundFile(folder, i));
    prepared.backgrounds.push_back(extractor.background());
    prepared.first_images.push_back(
        kind == kFirstImages ? options.pipeline.silhouette.background_frames : 0);
  }
  return prepared;
}

void settleBackgrounds(const OfflineOptions& options, const Preparation& prepared,
                       Pipeline* pipeline) {
  const double rate = options.pipeline.silhouette.update_rate;
  if (rate == 0.0 || options.recording.use_masks) return;
  RecordingOptions before = options.recording;
  const double wanted = (kTimeConstants / rate + kImageCycle) * secondsPerFrameSet(options);
  before.duration = std::min(wanted, options.recording.start);
  before.start -= before.duration;
  before.duration -= kEndBefore_s;
  Recording recording(options.input, before);
  std::vector<size_t> images = recording.imagesBefore();
  std::vector<char> follows(images.size(), false);
  while (auto frame_set = nextFrameSet(options, &recording)) {
    for (size_t i = 0; i < images.size(); ++i) {
      if (frame_set->frames[i].image.empty()) continue;
      const size_t image = images[i]++, learned = size_t(prepared.first_images[i]);
      follows[i] |= image >= learned && (image - learned) % kImageCycle == 0;
      if (!follows[i]) frame_set->frames[i].image.release();
    }
    pipeline->followLight(*frame_set);
  }
}

}  // namespace markerless_mocap
