#include "capture/scene/studio_scene.h"

#include <algorithm>
#include <cmath>

#include "capture/ground_truth.h"
#include "capture/truth/body_retargeter.h"
#include "character/adult_character.h"
#include "character/imported_character.h"
#include "markerless_mocap/body/body_urdf.h"
#include "motion/motion_script.h"

namespace markerless_mocap {
namespace {

/// Directions of other people, seen from the centre, radians.
constexpr double kOtherBearing = 2.2, kBystanderBearing = -1.57;
constexpr double kOtherPhase = 0.43;  // fraction of the motion's period

/// Options of the second person: another sex, stature and appearance.
CharacterOptions otherThan(CharacterOptions character) {
  character.male = 1.0 - character.male;
  character.stature += character.stature > 1.7 ? -0.1 : 0.1;
  character.appearance_seed += 1;
  return character;
}

Character leadOf(const StudioOptions& options) {
  if (options.character_file.empty()) return makeCharacter(options.character);
  return importCharacter(options.character_file, options.character.stature);
}

/// Moves the colours of the clothes towards the wall's; head, neck and hands keep their colours.
void camouflage(const Eigen::Vector3f& wall, float amount, Character* character) {
  for (size_t v = 0; v < character->mesh.colors.size(); ++v) {
    const VertexWeights& w = character->weights[v];
    float bare = 0.0f;
    for (size_t k = 0; k < 4; ++k) {
      const Bone bone = w.bones[k];
      if (bone == Bone::kHead || bone == Bone::kNeck || bone == Bone::kLeftHand ||
          bone == Bone::kRightHand)
        bare += w.weights[k];
    }
    Eigen::Vector3f& color = character->mesh.colors[v];
    color += amount * (1.0f - std::min(bare, 1.0f)) * (wall - color);
  }
}

/// A person who looks at the centre and fidgets.
Actor bystanderAt(double distance, const CharacterOptions& lead, const std::string& folder) {
  CharacterOptions character = otherThan(lead);
  character.appearance_seed += 1;
  Character made = makeCharacter(character);
  const MotionScript script = readMotionScript(folder + "/fidget.yaml");
  LoopedMotion motion(performMotion(script, made.skeleton));
  return {std::move(made), std::move(motion), 0.0,
          placeAt(distance, kBystanderBearing, kBystanderBearing + M_PI)};
}

}  // namespace

HumanPose Actor::at(double seconds) const {
  HumanPose pose = motion.at(seconds + phase);
  pose.hips = place * pose.hips;
  const Eigen::Quaterniond turn(place.linear());
  for (Eigen::Quaterniond& R : pose.R_world_bone) R = turn * R;
  return pose;
}

SceneObject Actor::seenAt(double seconds) const {
  SceneObject object;
  object.mesh = &character.mesh;
  character.pose(at(seconds), object.vertices);
  return object;
}

StudioScene::StudioScene(const StudioOptions& options, const StudioFiles& files,
                         const TexturedRoom& room, const std::string& body_id)
    : events_(options.degradations, room.halfSize()) {
  const auto actorOf = [&](Character character) {
    MotionClip clip = loadMotion(options, files.motions_folder, character.skeleton);
    camouflage(room.wallColor(), float(options.degradations.camouflage), &character);
    return Actor{std::move(character), LoopedMotion(std::move(clip))};
  };
  actors_.push_back(actorOf(leadOf(options)));
  if (const double distance = options.degradations.second_person_distance; distance > 0.0) {
    actors_.push_back(actorOf(makeCharacter(otherThan(options.character))));
    actors_.back().phase = kOtherPhase * actors_.back().motion.period();
    actors_.back().place = placeAt(distance, kOtherBearing, kOtherBearing);
  }
  if (const double distance = options.degradations.bystander_distance; distance > 0.0)
    bystander_ = std::make_unique<const Actor>(
        bystanderAt(distance, options.character, files.motions_folder));
  const HumanSkeleton& skeleton = actors_.front().character.skeleton;
  urdf_ = fillUrdfTemplate(files.urdf_template, body_id, proportionsOf(skeleton));
  body_ = std::make_shared<BodyModel>(BodyModel::fromUrdf(urdf_, body_id));
  drive(options.fps);
}

/// Computes the angles in order through one period, as each frame depends on the one before.
void StudioScene::drive(double fps) {
  const Actor& actor = actors_.front();
  BodyRetargeter driven(body_, actor.character.skeleton);
  const auto frames = size_t(std::max(1L, std::lround(actor.motion.period() * fps)));
  for (size_t i = 0; i < frames; ++i) states_.push_back(driven.follow(actor.at(double(i) / fps)));
}

std::vector<Eigen::Vector3d> StudioScene::pointsAt(double seconds) const {
  const Actor& actor = actors_.front();
  return groundTruthPoints(actor.character.skeleton, actor.at(seconds));
}

std::vector<SceneObject> StudioScene::objectsAt(const FilmTime& time) const {
  std::vector<SceneObject> objects;
  events_.addObjects(time.since, &objects);
  if (bystander_) {
    objects.push_back(bystander_->seenAt(time.since));
    objects.back().person = false;
  }
  if (time.people)
    for (const Actor& actor : actors_) objects.push_back(actor.seenAt(time.motion));
  return objects;
}

}  // namespace markerless_mocap
