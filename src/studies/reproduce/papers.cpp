#include "studies/reproduce/bakken/bakken_paper.h"
#include "studies/reproduce/fleischmann/fleischmann_paper.h"
#include "studies/reproduce/hsiao/hsiao_paper.h"
#include "studies/reproduce/paper.h"

namespace markerless_mocap {

const std::map<std::string, PaperMaker>& papers() {
  static const std::map<std::string, PaperMaker> kPapers = {
      {"bakken", makeBakkenPaper},
      {"fleischmann", makeFleischmannPaper},
      {"hsiao", makeHsiaoPaper},
  };
  return kPapers;
}

}  // namespace markerless_mocap
