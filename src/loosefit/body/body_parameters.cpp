#include "loosefit/body/body_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"

namespace loosefit::body {
namespace {

// Knots at 1, 10, 25 and 90 years.
void add_age_factors(double years, std::map<std::string, double>& factor) {
  const double a = years < 25 ? (years - 1) / 48 : 0.5 + (years - 25) / 130;
  constexpr double kChild = 0.1875;
  double baby = 0, child = 0, young = 0, old = 0;
  if (a < 0.5) {
    baby = std::max(0., 1 - a / kChild);
    young = std::max(0., (a - kChild) / (0.5 - kChild));
    child = std::max(0., std::min(1., a / kChild) - young);
  } else {
    old = 2 * a - 1;
    young = 1 - old;
  }
  factor["baby"] = baby, factor["child"] = child, factor["young"] = young, factor["old"] = old;
}

// Not clamped at 1: weights up to kHeaviest give convincing heavy bodies, and the three still sum
// to 1.
void add_level(double x, const char* low, const char* middle, const char* high,
               std::map<std::string, double>& factor) {
  const double most = std::max(0., 2 * x - 1), least = std::max(0., 1 - 2 * x);
  factor[high] = most, factor[low] = least, factor[middle] = 1 - most - least;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find('-', from), text.size());
    words.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return words;
}

DetailTarget measure(const std::string& key, const std::string& stem) {
  return {
      key, {"measure/measure-" + stem + "-decrease"}, {"measure/measure-" + stem + "-increase"}};
}

DetailTarget pair(const std::string& key, const std::string& stem, const std::string& less = "decr",
                  const std::string& more = "incr") {
  return {key, {stem + "-" + less}, {stem + "-" + more}};
}

DetailTarget both_sides(const std::string& key, const std::string& stem, const std::string& less,
                        const std::string& more) {
  const std::string left = "armslegs/l-" + stem, right = "armslegs/r-" + stem;
  return {key, {left + less, right + less}, {left + more, right + more}};
}

}  // namespace

std::map<std::string, double> macro_factors(const BodyParameters& p) {
  std::map<std::string, double> factor;
  factor["male"] = p.sex, factor["female"] = 1 - p.sex;
  add_age_factors(p.age, factor);
  add_level(p.muscle, "minmuscle", "averagemuscle", "maxmuscle", factor);
  add_level(p.weight, "minweight", "averageweight", "maxweight", factor);
  add_level(p.height, "minheight", "averageheight", "maxheight", factor);
  add_level(p.proportions, "uncommonproportions", "regularproportions", "idealproportions", factor);
  add_level(p.cup, "mincup", "averagecup", "maxcup", factor);
  add_level(p.firmness, "minfirmness", "averagefirmness", "maxfirmness", factor);
  factor["african"] = p.ancestry[0], factor["asian"] = p.ancestry[1];
  factor["caucasian"] = p.ancestry[2];
  return factor;
}

std::vector<std::string> macro_words(const std::string& target_name) {
  const std::size_t slash = target_name.rfind('/');
  const std::string last = target_name.substr(slash + 1);
  const bool macro = target_name.starts_with("macrodetails/") ||
                     (target_name.starts_with("breast/") && last.starts_with("female-"));
  if (!macro) return {};
  std::vector<std::string> words = split(last);
  std::erase(words, "universal");
  return words;
}

// "lenght" is how the data spell it; stomach-tone-incr is the belly in these data.
const std::vector<DetailTarget>& detail_targets() {
  static const std::vector<DetailTarget> kTargets = {
      measure("bust", "bust"),
      measure("underbust", "underbust"),
      measure("waist", "waist"),
      measure("hips", "hips"),
      pair("belly", "stomach/stomach-tone"),
      pair("round_belly", "stomach/stomach-pregnant"),
      measure("neck", "neckcirc"),
      measure("upper_arm", "upperarm"),
      measure("wrist", "wrist"),
      measure("thigh", "thighcirc"),
      measure("knee", "kneecirc"),
      measure("calf", "calf"),
      measure("ankle", "ankle"),
      measure("shoulder", "shoulder"),
      measure("front_chest", "frontchest"),
      measure("upper_arm_length", "upperarmlenght"),
      measure("forearm_length", "lowerarmlenght"),
      measure("nape_to_waist", "napetowaist"),
      measure("waist_to_hip", "waisttohip"),
      measure("thigh_length", "upperlegheight"),
      measure("shank_length", "lowerlegheight"),
      measure("neck_height", "neckheight"),
      pair("trunk_depth", "torso/torso-scale-depth"),
      pair("trunk_width", "torso/torso-scale-horiz"),
      pair("hip_depth", "hip/hip-scale-depth"),
      pair("hip_width", "hip/hip-scale-horiz"),
      pair("buttocks", "buttocks/buttocks-volume"),
      pair("back_muscle", "torso/torso-muscle-dorsi"),
      pair("v_shape", "torso/torso-vshape", "less", "more"),
      both_sides("forearm", "lowerarm", "-skinny", "-fat"),
      both_sides("upper_arm_fat", "upperarm", "-skinny", "-fat"),
  };
  return kTargets;
}

void check_parameters(const BodyParameters& p) {
  const auto check = [](const std::string& key, double value, double low, double high) {
    if (!(value >= low && value <= high)) {
      throw InvalidInput({"", 0, key}, fmt::format("{:g}", value),
                         fmt::format("a number from {:g} to {:g}", low, high));
    }
  };
  check("sex", p.sex, 0, 1);
  check("age", p.age, 1, 90);
  check("muscle", p.muscle, 0, 1);
  check("weight", p.weight, 0, kHeaviest);
  check("height", p.height, 0, 1);
  check("proportions", p.proportions, 0, 1);
  check("cup", p.cup, 0, 1);
  check("firmness", p.firmness, 0, 1);
  for (const double share : p.ancestry) check("ancestry", share, 0, 1);
  const double sum = p.ancestry[0] + p.ancestry[1] + p.ancestry[2];
  if (std::abs(sum - 1) > 1e-9) {
    throw InvalidInput({"", 0, "ancestry"}, fmt::format("a sum of {:g}", sum),
                       "shares that sum to 1");
  }
  std::vector<std::string> known;
  for (const auto& target : detail_targets()) known.push_back(target.key);
  for (const auto& [key, value] : p.details) {
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      throw InvalidInput({"", 0, "details"}, "\"" + printable(key) + "\"", "a known local change",
                         did_you_mean(key, known));
    }
    check(key, value, -1, 1);
  }
}

}  // namespace loosefit::body
