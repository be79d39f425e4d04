#include "character/character_options.h"

namespace markerless_mocap {

void CharacterOptions::visit(OptionVisitor& v) {
  v.field("stature", stature, 1.2, 2.2, "height of the person, m");
  v.field("male", male, 0, 1, "shape of the person; 0: woman, 1: man, or a mixture");
  v.field("bmi", bmi, 17, 40, "body mass index of the person, kg/m^2");
  v.field("clothes", clothes, {"tight", "loose", "skirt"},
          "tight clothes, a wide shirt and wide trousers, or a knee-long skirt with a tight shirt");
  v.field("hair", hair, {"short", "long"}, "long hair falls over neck and shoulder blades");
  v.field("appearance_seed", appearance_seed, 0, 1000000000,
          "seed of the colours of skin, hair and clothes, and of the pattern of the cloth");
}

void CharacterOptions::validate() const {
  checkFields(*this);
}

}  // namespace markerless_mocap
