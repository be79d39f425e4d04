#include "motion/bone_names.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "error_text_of.h"
#include "named_rig.h"

namespace markerless_mocap {
namespace {

const char* const kCgspeedSide =
    "<HipJoint Hips SideUpLeg <HipJoint SideLeg SideUpLeg SideFoot SideLeg SideToeBase SideFoot "
    "SideShoulder Spine1 SideArm SideShoulder SideForeArm SideArm SideHand SideForeArm "
    "SideFingerBase SideHand SideHandIndex1 SideFingerBase <Thumb SideHand ";

TEST(BoneNames, cmuConversionByCgspeed) {
  const std::string side = kCgspeedSide;
  const Mapped mapped(
      rig("Hips - LowerBack Hips Spine LowerBack Spine1 Spine Neck Spine1 "
          "Neck1 Neck Head Neck1 " +
          bothSides(replaced(side, "Side", "Left"), "L", "L") +
          bothSides(replaced(side, "Side", "Right"), "R", "R")));
  mapped.expectLimbs("<Shoulder <Arm <ForeArm <Hand <UpLeg <Leg <Foot <ToeBase", "Left", "Right");
  mapped.expectTrunk("Hips", "LowerBack Spine Spine1", "Neck Neck1", "Head");
  EXPECT_EQ(mapped[Bone::kChest], "Spine1");
}

TEST(BoneNames, cmuConversionForDaz) {
  const std::string side =
      "~HipJoint Hips SideHip ~HipJoint SideKnee SideHip SideAnkle SideKnee SideToe SideAnkle "
      "SideCollar Chest2 SideShoulder SideCollar SideElbow SideShoulder SideWrist SideElbow "
      "=hand SideWrist ~Fingers =hand ~Thumb SideWrist ";
  const auto of = [&](const char* name, const char* upper, const char* lower) {
    return replaced(replaced(replaced(side, "Side", name), "~", upper), "=", lower);
  };
  const Mapped mapped(
      rig("Hips - lowerback Hips Chest lowerback Chest2 Chest lowerneck Chest2 "
          "Neck lowerneck Head Neck " +
          of("Left", "L", "l") + of("Right", "R", "r")));
  mapped.expectLimbs("<Collar <Shoulder <Elbow <Wrist <Hip <Knee <Ankle <Toe", "Left", "Right");
  mapped.expectTrunk("Hips", "lowerback Chest Chest2", "lowerneck Neck", "Head");
}

TEST(BoneNames, motionBuilder) {
  const Mapped mapped(
      rig("Reference - Hips Reference " +
          bothSides("<UpLeg Hips <UpLegRoll <UpLeg <Leg <UpLeg <LegRoll <Leg <Foot <Leg "
                    "<ToeBase <Foot ",
                    "Left", "Right") +
          "Spine Hips Spine1 Spine Spine2 Spine1 " +
          bothSides("<Shoulder Spine2 <Arm <Shoulder <ArmRoll <Arm <ForeArm <Arm "
                    "<ForeArmRoll <ForeArm <Hand <ForeArm <HandThumb1 <Hand <HandIndex1 <Hand "
                    "<InHandMiddle <Hand ",
                    "Left", "Right") +
          "Neck Spine2 Head Neck HeadEnd Head"));
  mapped.expectLimbs("<Shoulder <Arm <ForeArm <Hand <UpLeg <Leg <Foot <ToeBase", "Left", "Right");
  mapped.expectTrunk("Hips", "Spine Spine1 Spine2", "Neck", "Head");
}

TEST(BoneNames, mixamoWithEveryPrefix) {
  const std::string lines =
      "@Hips - @Spine @Hips @Spine1 @Spine @Spine2 @Spine1 @Neck @Spine2 @Head @Neck "
      "@HeadTop_End @Head " +
      bothSides(
          "@<Shoulder @Spine2 @<Arm @<Shoulder @<ForeArm @<Arm @<Hand @<ForeArm "
          "@<HandThumb1 @<Hand @<HandIndex1 @<Hand @<UpLeg @Hips @<Leg @<UpLeg "
          "@<Foot @<Leg @<ToeBase @<Foot @<Toe_End @<ToeBase ",
          "Left", "Right");
  for (const std::string prefix :
       {"mixamorig:", "mixamorig_", "mixamorig1:", "mixamorig", "", "Armature|", "Character1_"}) {
    SCOPED_TRACE(prefix);
    const Mapped mapped(rig(replaced(lines, "@", prefix)));
    const auto with = [&](const std::string& names) { return replaced(names, "@", prefix); };
    mapped.expectLimbs(with("@<Shoulder @<Arm @<ForeArm @<Hand @<UpLeg @<Leg @<Foot @<ToeBase"),
                       "Left", "Right");
    mapped.expectTrunk(with("@Hips"), with("@Spine @Spine1 @Spine2"), with("@Neck"), with("@Head"));
  }
}

TEST(BoneNames, blenderMetarig) {
  const Mapped mapped(
      rig("spine - pelvis.L spine pelvis.R spine spine.001 spine spine.002 spine.001 "
          "spine.003 spine.002 spine.004 spine.003 spine.005 spine.004 spine.006 spine.005 "
          "face spine.006 nose face ear.L face ear.R face " +
          bothSides("thigh.< spine shin.< thigh.< foot.< shin.< toe.< foot.< heel.02.< foot.< "
                    "breast.< spine.003 shoulder.< spine.003 upper_arm.< shoulder.< "
                    "forearm.< upper_arm.< hand.< forearm.< palm.01.< hand.< f_index.01.< "
                    "palm.01.< thumb.01.< palm.01.< ",
                    "L", "R")));
  mapped.expectLimbs("shoulder.< upper_arm.< forearm.< hand.< thigh.< shin.< foot.< toe.<", "L",
                     "R");
  mapped.expectTrunk("spine", "spine.001 spine.002 spine.003", "spine.004 spine.005", "spine.006");
}

TEST(BoneNames, blenderDeformBones) {
  const Mapped mapped(
      rig("root - DEF-spine root DEF-spine.001 DEF-spine DEF-spine.002 DEF-spine.001 "
          "DEF-spine.003 DEF-spine.002 DEF-spine.004 DEF-spine.003 DEF-spine.005 DEF-spine.004 "
          "DEF-spine.006 DEF-spine.005 MCH-foot_ik.parent root " +
          bothSides("foot_ik.< root upper_arm_fk.< root DEF-thigh.< DEF-spine "
                    "DEF-thigh.<.001 DEF-thigh.< DEF-shin.< DEF-thigh.<.001 "
                    "DEF-shin.<.001 DEF-shin.< DEF-foot.< DEF-shin.<.001 DEF-toe.< DEF-foot.< "
                    "DEF-shoulder.< DEF-spine.003 DEF-upper_arm.< DEF-shoulder.< "
                    "DEF-upper_arm.<.001 DEF-upper_arm.< DEF-forearm.< DEF-upper_arm.<.001 "
                    "DEF-forearm.<.001 DEF-forearm.< DEF-hand.< DEF-forearm.<.001 ",
                    "L", "R")));
  mapped.expectLimbs(
      "DEF-shoulder.< DEF-upper_arm.< DEF-forearm.< DEF-hand.< DEF-thigh.< DEF-shin.< "
      "DEF-foot.< DEF-toe.<",
      "L", "R");
  mapped.expectTrunk("DEF-spine", "DEF-spine.001 DEF-spine.002 DEF-spine.003",
                     "DEF-spine.004 DEF-spine.005", "DEF-spine.006");
}

TEST(BoneNames, makeHuman) {
  const Mapped mapped(
      rig("root - spine05 root spine04 spine05 spine03 spine04 spine02 spine03 spine01 spine02 "
          "neck01 spine01 neck02 neck01 neck03 neck02 head neck03 jaw head " +
          bothSides("pelvis.< root upperleg01.< pelvis.< upperleg02.< upperleg01.< lowerleg01.< "
                    "upperleg02.< lowerleg02.< lowerleg01.< foot.< lowerleg02.< toe1-1.< foot.< "
                    "toe2-1.< foot.< toe3-1.< foot.< toe4-1.< foot.< toe5-1.< foot.< "
                    "toe1-2.< toe1-1.< breast.< spine02 clavicle.< spine01 shoulder01.< clavicle.< "
                    "upperarm01.< shoulder01.< upperarm02.< upperarm01.< lowerarm01.< upperarm02.< "
                    "lowerarm02.< lowerarm01.< wrist.< lowerarm02.< finger1-1.< wrist.< "
                    "metacarpal1.< wrist.< ",
                    "L", "R")));
  mapped.expectLimbs(
      "clavicle.< upperarm01.< lowerarm01.< wrist.< upperleg01.< lowerleg01.< foot.< toe3-1.<", "L",
      "R");
  mapped.expectTrunk("root", "spine05 spine04 spine03 spine02 spine01", "neck01 neck02 neck03",
                     "head");
}

TEST(BoneNames, vrm) {
  const Mapped mapped(
      rig("Root - J_Bip_C_Hips Root J_Bip_C_Spine J_Bip_C_Hips J_Bip_C_Chest J_Bip_C_Spine "
          "J_Bip_C_UpperChest J_Bip_C_Chest J_Bip_C_Neck J_Bip_C_UpperChest J_Bip_C_Head "
          "J_Bip_C_Neck J_Sec_Hair1_01 J_Bip_C_Head " +
          bothSides("J_Adj_<_FaceEye J_Bip_C_Head J_Sec_<_Bust1 J_Bip_C_UpperChest "
                    "J_Bip_<_Shoulder J_Bip_C_UpperChest J_Bip_<_UpperArm J_Bip_<_Shoulder "
                    "J_Bip_<_LowerArm J_Bip_<_UpperArm J_Bip_<_Hand J_Bip_<_LowerArm "
                    "J_Bip_<_Thumb1 J_Bip_<_Hand J_Bip_<_UpperLeg J_Bip_C_Hips "
                    "J_Bip_<_LowerLeg J_Bip_<_UpperLeg J_Bip_<_Foot J_Bip_<_LowerLeg "
                    "J_Bip_<_ToeBase J_Bip_<_Foot ",
                    "L", "R")));
  mapped.expectLimbs(
      "J_Bip_<_Shoulder J_Bip_<_UpperArm J_Bip_<_LowerArm J_Bip_<_Hand J_Bip_<_UpperLeg "
      "J_Bip_<_LowerLeg J_Bip_<_Foot J_Bip_<_ToeBase",
      "L", "R");
  mapped.expectTrunk("J_Bip_C_Hips", "J_Bip_C_Spine J_Bip_C_Chest J_Bip_C_UpperChest",
                     "J_Bip_C_Neck", "J_Bip_C_Head");
}

TEST(BoneNames, unityHumanoid) {
  const Mapped mapped(
      rig("Hips - Spine Hips Chest Spine UpperChest Chest Neck UpperChest Head Neck Jaw Head " +
          bothSides("<UpperLeg Hips <LowerLeg <UpperLeg <Foot <LowerLeg <Toes <Foot "
                    "<Shoulder UpperChest <UpperArm <Shoulder <LowerArm <UpperArm <Hand <LowerArm "
                    "<IndexProximal <Hand <Eye Head ",
                    "Left", "Right")));
  mapped.expectLimbs("<Shoulder <UpperArm <LowerArm <Hand <UpperLeg <LowerLeg <Foot <Toes", "Left",
                     "Right");
  mapped.expectTrunk("Hips", "Spine Chest UpperChest", "Neck", "Head");
}

TEST(BoneNames, unrealMannequin) {
  const Mapped mapped(
      rig("root - pelvis root spine_01 pelvis spine_02 spine_01 spine_03 spine_02 "
          "neck_01 spine_03 head neck_01 ik_foot_root root ik_hand_root root " +
          bothSides("ik_foot_< ik_foot_root ik_hand_< ik_hand_root clavicle_< spine_03 "
                    "upperarm_< clavicle_< upperarm_twist_01_< upperarm_< lowerarm_< upperarm_< "
                    "lowerarm_twist_01_< lowerarm_< hand_< lowerarm_< thumb_01_< hand_< "
                    "thigh_< pelvis thigh_twist_01_< thigh_< calf_< thigh_< calf_twist_01_< "
                    "calf_< foot_< calf_< ball_< foot_< ",
                    "l", "r")));
  mapped.expectLimbs("clavicle_< upperarm_< lowerarm_< hand_< thigh_< calf_< foot_< ball_<", "l",
                     "r");
  mapped.expectTrunk("pelvis", "spine_01 spine_02 spine_03", "neck_01", "head");
}

// The clavicles hang from the neck, the thighs may hang from the spine.
TEST(BoneNames, biped) {
  const Mapped mapped(
      rig("Bip01 - Bip01~Pelvis Bip01 Bip01~Spine Bip01~Pelvis Bip01~Spine1 Bip01~Spine "
          "Bip01~Neck Bip01~Spine1 Bip01~Head Bip01~Neck Bip01~HeadNub Bip01~Head " +
          bothSides("Bip01~<~Thigh Bip01~Pelvis Bip01~<~Calf Bip01~<~Thigh Bip01~<~Foot "
                    "Bip01~<~Calf Bip01~<~Toe0 Bip01~<~Foot Bip01~<~Clavicle Bip01~Neck "
                    "Bip01~<~UpperArm Bip01~<~Clavicle Bip01~<~Forearm Bip01~<~UpperArm "
                    "Bip01~<~Hand Bip01~<~Forearm Bip01~<~Finger0 Bip01~<~Hand ",
                    "L", "R")));
  mapped.expectLimbs(
      "Bip01~<~Clavicle Bip01~<~UpperArm Bip01~<~Forearm Bip01~<~Hand Bip01~<~Thigh "
      "Bip01~<~Calf Bip01~<~Foot Bip01~<~Toe0",
      "L", "R");
  mapped.expectTrunk("Bip01 Pelvis", "Bip01 Spine Bip01 Spine1 Bip01 Neck", "", "Bip01 Head");
}

TEST(BoneNames, daz) {
  const Mapped mapped(
      rig("hip - pelvis hip abdomenLower hip abdomenUpper abdomenLower chestLower abdomenUpper "
          "chestUpper chestLower neckLower chestUpper neckUpper neckLower head neckUpper " +
          bothSides("<ThighBend pelvis <ThighTwist <ThighBend <Shin <ThighTwist <Foot <Shin "
                    "<Metatarsals <Foot <Toe <Metatarsals <BigToe <Toe <Collar chestUpper "
                    "<ShldrBend <Collar <ShldrTwist <ShldrBend <ForearmBend <ShldrTwist "
                    "<ForearmTwist <ForearmBend <Hand <ForearmTwist <Thumb1 <Hand ",
                    "l", "r")));
  mapped.expectLimbs("<Collar <ShldrBend <ForearmBend <Hand <ThighBend <Shin <Foot <Toe", "l", "r");
  mapped.expectTrunk("pelvis", "abdomenLower abdomenUpper chestLower chestUpper",
                     "neckLower neckUpper", "head");
}

TEST(BoneNames, smpl) {
  const std::string lines =
      "@Pelvis - @Spine1 @Pelvis @Spine2 @Spine1 @Spine3 @Spine2 @Neck @Spine3 @Head @Neck " +
      bothSides(
          "@<_Hip @Pelvis @<_Knee @<_Hip @<_Ankle @<_Knee @<_Foot @<_Ankle "
          "@<_Collar @Spine3 @<_Shoulder @<_Collar @<_Elbow @<_Shoulder @<_Wrist @<_Elbow "
          "@<_Hand @<_Wrist ",
          "L", "R");
  for (const std::string prefix : {"", "m_avg_", "f_avg_"}) {
    SCOPED_TRACE(prefix);
    const Mapped mapped(rig(replaced(lines, "@", prefix)));
    const auto with = [&](const std::string& names) { return replaced(names, "@", prefix); };
    mapped.expectLimbs(
        with("@<_Collar @<_Shoulder @<_Elbow @<_Wrist @<_Hip @<_Knee @<_Ankle @<_Foot"), "L", "R");
    mapped.expectTrunk(with("@Pelvis"), with("@Spine1 @Spine2 @Spine3"), with("@Neck"),
                       with("@Head"));
  }
}

TEST(BoneNames, characterCreatorAndOptiTrack) {
  const Mapped creator(rig(
      "CC_Base_Hip - CC_Base_Pelvis CC_Base_Hip CC_Base_Waist CC_Base_Hip CC_Base_Spine01 "
      "CC_Base_Waist CC_Base_Spine02 CC_Base_Spine01 CC_Base_NeckTwist01 CC_Base_Spine02 "
      "CC_Base_Head CC_Base_NeckTwist01 " +
      bothSides("CC_Base_<_Thigh CC_Base_Pelvis CC_Base_<_ThighTwist01 CC_Base_<_Thigh "
                "CC_Base_<_Calf CC_Base_<_Thigh CC_Base_<_Foot CC_Base_<_Calf CC_Base_<_ToeBase "
                "CC_Base_<_Foot CC_Base_<_Clavicle CC_Base_Spine02 CC_Base_<_Upperarm "
                "CC_Base_<_Clavicle CC_Base_<_Forearm CC_Base_<_Upperarm CC_Base_<_Hand "
                "CC_Base_<_Forearm ",
                "L", "R")));
  creator.expectLimbs(
      "CC_Base_<_Clavicle CC_Base_<_Upperarm CC_Base_<_Forearm CC_Base_<_Hand CC_Base_<_Thigh "
      "CC_Base_<_Calf CC_Base_<_Foot CC_Base_<_ToeBase",
      "L", "R");
  EXPECT_EQ(creator[Bone::kHead], "CC_Base_Head");

  const Mapped motive(rig("Hip - Ab Hip Chest Ab Neck Chest Head Neck " +
                          bothSides("<Thigh Hip <Shin <Thigh <Foot <Shin <Toe <Foot "
                                    "<Shoulder Chest <UArm <Shoulder <FArm <UArm <Hand <FArm ",
                                    "L", "R")));
  motive.expectLimbs("<Shoulder <UArm <FArm <Hand <Thigh <Shin <Foot <Toe", "L", "R");
  motive.expectTrunk("Hip", "Ab Chest", "Neck", "Head");
}

TEST(BoneNames, sideInAnyPlaceAndCase) {
  const std::string trunk = "hips - spine hips chest spine neck chest head neck ";
  const std::string limbs =
      "@upleg| hips @leg| @upleg| @foot| @leg| @shoulder| chest @arm| @shoulder| "
      "@forearm| @arm| @hand| @forearm| ";
  const std::pair<const char*, const char*> kPlaces[] = {
      {"l", ""}, {"left", ""}, {"L_", ""}, {"Left", ""}, {"", ".l"}, {"", "_Left"}, {"", "_L"}};
  for (const auto& [before, after] : kPlaces) {
    SCOPED_TRACE(std::string(before) + "*" + after);
    const auto side = [&](bool left) {
      const auto swapped = [&](std::string text) {
        if (left) return text;
        text = replaced(replaced(text, "eft", "ight"), "L", "R");
        return replaced(text, "l", "r");
      };
      return replaced(replaced(limbs, "@", swapped(before)), "|", swapped(after));
    };
    const Mapped mapped(rig(trunk + side(true) + side(false)));
    EXPECT_EQ(mapped[Bone::kLeftUpperArm], std::string(before) + "arm" + after);
    EXPECT_EQ(mapped[Bone::kLeftThigh], std::string(before) + "upleg" + after);
    EXPECT_EQ(mapped[Bone::kLeftClavicle], std::string(before) + "shoulder" + after);
    EXPECT_NE(mapped[Bone::kRightShank], mapped[Bone::kLeftShank]);
    EXPECT_EQ(mapped[Bone::kLeftToes], "");
  }
}

TEST(BoneNames, whatIsNotNeededMayBeMissing) {
  const Mapped mapped(rig("pelvis - torso pelvis " +
                          bothSides("<thigh pelvis <shin <thigh <foot <shin <upperarm torso "
                                    "<forearm <upperarm ",
                                    "l", "r")));
  mapped.expectLimbs("- <upperarm <forearm - <thigh <shin <foot -", "l", "r");
  mapped.expectTrunk("pelvis", "torso", "", "");
}

std::string faultOf(const std::string& lines) {
  return errorTextOf([&] { mapBones(rig(lines), "rig.bvh"); });
}

TEST(BoneNames, missingBonesAreListedWithTheNamesThereAre) {
  EXPECT_EQ(faultOf("hips - chest hips " +
                    bothSides("<thigh hips <shin <thigh <upperarm chest ", "l", "r")),
            "rig.bvh: no joint is named like l_forearm, r_forearm, l_foot, r_foot; the joints are "
            "hips, chest, lthigh, lshin, lupperarm, rthigh, rshin, rupperarm");
  EXPECT_EQ(faultOf(""),
            "rig.bvh: no joint is named like l_upper_arm, r_upper_arm, l_forearm, r_forearm, "
            "l_thigh, r_thigh, l_shank, r_shank, l_foot, r_foot; the joints are none");
}

TEST(BoneNames, aRigInPiecesIsRefused) {
  const std::string limbs = "<upleg hips <leg <upleg <foot <leg ";
  EXPECT_EQ(faultOf("hips - " + bothSides(limbs, "left", "right") +
                    bothSides("<arm - <forearm <arm ", "left", "right")),
            "rig.bvh: no joint carries both arms, all joints have to hang together");
}

}  // namespace
}  // namespace markerless_mocap
