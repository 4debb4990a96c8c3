#include "synth/inspection/contact_requirements.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace bimodal::synth {

namespace {

// Lips shut, lip to teeth, teeth and tongue seen, and the opening of round lips: limits of this
// project's requirements for a face to be lipread. The 0.5 mm at the ridge, the blade's widths
// (those of T D N and of L lie 1.5 mm apart) and the 38 mm of round lips were chosen by us.
constexpr double kAny = std::numeric_limits<double>::infinity();

constexpr std::array kRequirements{
    ContactRequirement{"P B M",
                       "lips shut: widest gap along the slit at most 0.05 mm",
                       Control::LipClosure,
                       1,
                       0,
                       0.05,
                       [](MouthRuler& ruler) { return ruler.lips().largest_gap_mm; }},
    ContactRequirement{"F V",
                       "lower lip to upper incisors -0.2 to 0.3 mm",
                       Control::LowerLipTuck,
                       1,
                       -kMostPenetration,
                       0.3,
                       [](MouthRuler& ruler) { return ruler.lip_to_incisors_mm(); }},
    ContactRequirement{"F V",
                       "upper teeth seen: at least 5 mm2",
                       Control::LowerLipTuck,
                       1,
                       5,
                       kAny,
                       [](MouthRuler& ruler) { return ruler.seen().upper_teeth_mm2; }},
    ContactRequirement{"TH DH",
                       "tongue seen between the teeth: at least 4 mm2",
                       Control::TongueLength,
                       1,
                       4,
                       kAny,
                       [](MouthRuler& ruler) { return ruler.seen().tongue_between_teeth_mm2; }},
    ContactRequirement{"T D N L",
                       "tongue at the alveolar ridge: at most 0.5 mm from it",
                       Control::TongueTip,
                       1,
                       -kMostPenetration,
                       0.5,
                       [](MouthRuler& ruler) { return ruler.tongue().to_ridge_mm; }},
    ContactRequirement{"T D N",
                       "blade wide: at most 3.5 mm between its sides and the upper gum",
                       Control::TongueTip,
                       1,
                       -kMostPenetration,
                       3.5,
                       [](MouthRuler& ruler) { return ruler.tongue().beside_mm; }},
    ContactRequirement{"L",
                       "blade narrow: at least 4.2 mm between its sides and the upper gum",
                       Control::TongueTip,
                       1,
                       4.2,
                       kAny,
                       [](MouthRuler& ruler) { return ruler.tongue().beside_mm; }},
    ContactRequirement{"W WH UW",
                       "lips round: opening 1 to 3 mm high",
                       Control::LipWidth,
                       -1,
                       1,
                       3,
                       [](MouthRuler& ruler) { return ruler.lips().inner_height_mm; }},
    ContactRequirement{"W WH UW",
                       "lips round: at most 38 mm from corner to corner (rest 51.5)",
                       Control::LipWidth,
                       -1,
                       0,
                       38,
                       [](MouthRuler& ruler) { return ruler.lips().outer_width_mm; }},
};

}  // namespace

std::span<const ContactRequirement> contact_requirements() {
  return kRequirements;
}

bool concerns(const ContactRequirement& requirement, Phone phone) {
  const auto name = symbol(phone);
  std::string_view rest = requirement.sounds;
  while (!rest.empty()) {
    const auto end = std::min(rest.find(' '), rest.size());
    if (rest.substr(0, end) == name) return true;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return false;
}

double distance_to(const ContactRequirement& requirement, double measure) {
  return std::max({0.0, requirement.least - measure, measure - requirement.most});
}

double margin(const ContactRequirement& requirement, double measure) {
  const double above = requirement.least == 0 ? kAny : measure - requirement.least;
  return std::min(above, requirement.most - measure);
}

}  // namespace bimodal::synth
