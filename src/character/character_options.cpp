#include "character/character_options.h"

namespace markerless_mocap {

void CharacterOptions::visit(OptionVisitor& v) {
  v.field("stature", stature, 1.2, 2.2, "of the person, m");
  v.field("male", male, 0, 1, "shape of the person: 0 is a woman, 1 a man, in between mixes");
  v.field("bmi", bmi, 17, 40, "body mass index of the person, kg/m^2");
  v.field("clothes", clothes, {"tight", "loose", "skirt"},
          "tight ones, a wide shirt and wide trousers, or a knee-long skirt with a tight shirt");
  v.field("hair", hair, {"short", "long"}, "long hair falls over neck and shoulder blades");
  v.field("look_seed", look_seed, 0, 1000000000,
          "picks the colours of skin, hair and clothes, and the pattern of the cloth");
}

void CharacterOptions::validate() const {
  checkFields(*this);
}

}  // namespace markerless_mocap
