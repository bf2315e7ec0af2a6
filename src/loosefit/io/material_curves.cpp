#include "loosefit/io/material_curves.h"

#include <fmt/format.h>

#include <cmath>

#include "loosefit/base/text.h"
#include "loosefit/fabric/stress_curve.h"

namespace loosefit::io {
namespace {

struct Direction {
  const char* name;
  const char* stiffness_key;
  std::vector<fabric::CurvePoint> fabric::Material::*curve;
  double fabric::Material::*stiffness;
};

const Direction kDirections[] = {
    {"warp", "stiffness_warp", &fabric::Material::curve_warp, &fabric::Material::stiffness_warp},
    {"weft", "stiffness_weft", &fabric::Material::curve_weft, &fabric::Material::stiffness_weft},
    {"shear", "stiffness_shear", &fabric::Material::curve_shear,
     &fabric::Material::stiffness_shear},
};

// The two forms of a curve: names and ranges of its columns, and what a row means.
struct Form {
  const char *strain_key, *force_key;
  double max_strain, max_force;
  const char* what;
  fabric::CurvePoint (*point)(double, double);
};

fabric::CurvePoint as_given(double strain, double force) { return {strain, force}; }
fabric::CurvePoint sine_of_angle(double angle, double stress) { return {std::sin(angle), stress}; }

constexpr Form kTension[] = {
    {"elongation", "force", 5, 1e7, "a fraction (10 % is 0.1)", as_given},
    {"green_strain", "second_piola_kirchhoff", 17.5, 1e6, "a strain", fabric::force_of_green},
};
constexpr Form kShear[] = {
    {"angle", "stress", 1.5, 1e7, "radians", sine_of_angle},
    {"green_shear", "second_piola_kirchhoff", 10, 1e7, "a shear", as_given},
};

std::vector<fabric::CurvePoint> read_curve(ConfigReader table, const Form (&forms)[2]) {
  const bool other = table.has(forms[1].strain_key) || table.has(forms[1].force_key);
  const bool first = table.has(forms[0].strain_key) || table.has(forms[0].force_key);
  if (first && other)
    throw table.error(forms[1].strain_key,
                      fmt::format("either {} with {} or {} with {}", forms[0].strain_key,
                                  forms[0].force_key, forms[1].strain_key, forms[1].force_key));
  const Form& form = forms[other ? 1 : 0];
  for (const Form& known : forms)
    for (const char* key : {known.strain_key, known.force_key}) table.has(key);
  table.finish();
  const std::vector<double> strain = table.numbers(form.strain_key, {0, form.max_strain, form.what},
                                                   "strains of the points, rising");
  const std::vector<double> force =
      table.numbers(form.force_key, {0, form.max_force, "N/m"}, "force at each of them, rising");
  if (strain.size() != force.size())
    throw table.error(form.force_key, fmt::format("{} numbers", force.size()),
                      fmt::format("{}, one for every {}", strain.size(), form.strain_key), {});
  std::vector<fabric::CurvePoint> points;
  for (std::size_t i = 0; i < strain.size(); ++i) points.push_back(form.point(strain[i], force[i]));
  try {
    fabric::MonotoneCubic{points};
  } catch (const InvalidInput& e) {
    const InputPlace place = table.error(form.force_key, "").place();
    throw e.at(
        {place.file, place.line, place.key + (e.place().key.empty() ? "" : ", " + e.place().key)});
  }
  return points;
}

std::string column(const std::vector<fabric::CurvePoint>& points,
                   double fabric::CurvePoint::*value) {
  std::vector<std::string> texts;
  for (const fabric::CurvePoint& p : points) texts.push_back(shortest(p.*value));
  return "[" + join(texts) + "]";
}

}  // namespace

std::vector<const char*> read_material_curves(ConfigReader& table, fabric::Material& material) {
  std::vector<const char*> read;
  const auto given = table.optional_table("curve", "measured curves in place of stiffnesses");
  if (!given) return read;
  ConfigReader curves = *given;
  for (const Direction& d : kDirections) {
    const auto curve = curves.optional_table(d.name, "points of the curve of one direction");
    if (!curve) continue;
    const std::string clash = table.has(d.stiffness_key)    ? d.stiffness_key
                              : table.has("youngs_modulus") ? "youngs_modulus"
                                                            : "";
    if (!clash.empty())
      throw table.error(clash, "either " + clash + " or curve." + d.name,
                        "the stiffness is the initial slope of the measured curve");
    const bool shear = d.curve == &fabric::Material::curve_shear;
    std::vector<fabric::CurvePoint> points = read_curve(*curve, shear ? kShear : kTension);
    const double slope = fabric::MonotoneCubic(points).initial_slope();
    if (!(slope >= (shear ? 0.1 : 1) && slope <= 1e6))
      throw curves.error(d.name, fmt::format("an initial slope of {:g} N/m", slope),
                         fmt::format("a slope from {} to 1e6 N/m", shear ? "0.1" : "1"),
                         "check the units: N/m of width and fractions, not percent");
    material.*d.curve = std::move(points);
    material.*d.stiffness = slope;
    read.push_back(d.name);
  }
  curves.finish();
  return read;
}

std::string material_curves_toml(const fabric::Material& material) {
  std::string text;
  for (const Direction& d : kDirections) {
    const std::vector<fabric::CurvePoint>& points = material.*d.curve;
    if (points.empty()) continue;
    const Form& form = d.curve == &fabric::Material::curve_shear ? kShear[1] : kTension[0];
    text += fmt::format("curve.{0}.{1} = {2}\ncurve.{0}.{3} = {4}\n", d.name, form.strain_key,
                        column(points, &fabric::CurvePoint::strain), form.force_key,
                        column(points, &fabric::CurvePoint::force));
  }
  return text;
}

}  // namespace loosefit::io
