#include "loosefit/placement/scorecard.h"

#include <gtest/gtest.h>

#include <cmath>

#include "loosefit/base/types.h"
#include "loosefit/placement/derived_metrics.h"

namespace loosefit::placement {
namespace {

Criterion criterion(const std::string& metric, Ramp limit, const std::string& reason) {
  return {metric, limit, {}, reason, "", "test"};
}

Scorecard electrode() {
  Scorecard card;
  card.criteria = {criterion("pressure_kPa", {1.0, 0.3}, "pressed on too lightly"),
                   criterion("slip_mm", {2, 6}, "travels on the skin")};
  card.criteria[0].upper = Ramp{2.7, 4.7};
  card.criteria[0].reason_above = "presses uncomfortably";
  return card;
}

TEST(Ramp, IsLinearBetweenFailAndGoodInEitherDirection) {
  const Ramp more{3, 1}, less{2, 15};
  EXPECT_DOUBLE_EQ(more.at(1), 0);
  EXPECT_DOUBLE_EQ(more.at(1.5), 0.25);
  EXPECT_DOUBLE_EQ(more.at(3), 1);
  EXPECT_DOUBLE_EQ(less.at(2), 1);
  EXPECT_DOUBLE_EQ(less.at(5), 10.0 / 13);
  EXPECT_DOUBLE_EQ(less.at(15), 0);
  EXPECT_DOUBLE_EQ(less.at(28), -1) << "not clamped";
}

TEST(Criterion, RangeHasARampOnEitherSide) {
  const Criterion pressure = electrode().criteria[0];
  bool above = true;
  EXPECT_DOUBLE_EQ(pressure.ramp(0.65, &above), 0.5);
  EXPECT_FALSE(above);
  EXPECT_DOUBLE_EQ(pressure.ramp(3.7, &above), 0.5);
  EXPECT_TRUE(above);
  EXPECT_GE(pressure.ramp(2.0), 1);
  EXPECT_LT(pressure.ramp(0.2), 0);
  EXPECT_LT(pressure.ramp(5.0), 0);
}

TEST(Score, IsTheMinimumAndNamesWhatLimits) {
  const Scorecard card = electrode();
  const Score s = score({{"pressure_kPa", 0.65}, {"slip_mm", 3}}, card);
  EXPECT_DOUBLE_EQ(s.q.value(), 0.5);  // not the mean of 0.5 and 0.75
  EXPECT_EQ(s.limiting, 0);
  EXPECT_EQ(s.reason, "pressed on too lightly: 0.65 kPa, good from 1, fails at 0.3");
  const Score slipping = score({{"pressure_kPa", 0.65}, {"slip_mm", 5}}, card);
  EXPECT_DOUBLE_EQ(slipping.q.value(), 0.25);
  EXPECT_EQ(slipping.reason, "travels on the skin: 5 mm, good to 2, fails at 6");
  EXPECT_EQ(score({{"pressure_kPa", 4.2}, {"slip_mm", 0}}, card).reason,
            "presses uncomfortably: 4.2 kPa, good to 2.7, fails at 4.7");
}

TEST(Score, IsClampedAndKeepsTheMarginBeyond) {
  const Scorecard card = electrode();
  const Score good = score({{"pressure_kPa", 1.7}, {"slip_mm", 0}}, card);
  EXPECT_EQ(good.q.value(), 1);
  EXPECT_EQ(good.reason, "all needs met; nearest: contact pressure 1.7 kPa, good to 2.7");
  EXPECT_DOUBLE_EQ(good.margin, 1.5);  // slip: (0 - 6) / (2 - 6); pressure: 1.5 above, 2 below
  const Score bad = score({{"pressure_kPa", 0.2}, {"slip_mm", 26}}, card);
  EXPECT_EQ(bad.q.value(), 0);
  EXPECT_DOUBLE_EQ(bad.margin, -5);
  EXPECT_EQ(bad.limiting, 1) << "of two failed needs the one that fails by more";
}

TEST(Score, MissingMetricIsNotRatedRatherThanGuessed) {
  const Scorecard card = electrode();
  const Score s = score({{"pressure_kPa", 0.65}}, card);
  EXPECT_FALSE(s.q.has_value());
  EXPECT_DOUBLE_EQ(s.bound, 0.5);
  EXPECT_EQ(s.missing, std::vector<std::string>{"slip_mm"});
  EXPECT_EQ(s.reason, "not rated: needs slip_mm (several postures)");
  EXPECT_FALSE(score({{"pressure_kPa", 1.0}, {"slip_mm", std::nan("")}}, card).q.has_value());
  EXPECT_EQ(score({}, card).reason, "not rated: needs pressure_kPa, slip_mm (several postures)");
  EXPECT_EQ(score({}, card).bound, 1);
}

TEST(Score, KnownPartNamesWhatItLeavesOut) {
  const MetricValues one_drape = {{"pressure_kPa", 0.65}};
  const Scorecard part = known_part(electrode(), one_drape);
  EXPECT_EQ(part.left_out, std::vector<std::string>{"slip_mm"});
  EXPECT_DOUBLE_EQ(score(one_drape, part).q.value(), 0.5);
}

TEST(Vocabulary, UnitsAreThoseOfTheNames) {
  for (const MetricName& m : metric_vocabulary()) {
    const std::string suffix = m.name.substr(m.name.rfind('_') + 1);
    const bool has_unit =
        suffix == "deg" || suffix == "mm" || suffix == "kPa" || suffix == "pF" || suffix == "K";
    EXPECT_EQ(m.unit, has_unit ? suffix : "-") << m.name;
    EXPECT_EQ(find_metric(m.name), &m);
  }
  EXPECT_EQ(find_metric("coe_deg"), nullptr);
}

class Derived : public ::testing::Test {
 protected:
  double of(const std::string& name, const MetricValues& metrics) {
    const MetricValues all = with_derived(metrics, card_.parameters, card_.footprint);
    const auto at = all.find(name);
    return at == all.end() ? std::nan("") : at->second;
  }
  Scorecard card_;
};

// docs/theory/sensor_metrics.md 8: 85 pF is 0.42 mm of air for 40 cm2; at 1 mm 40 cm2 gives 35 pF.
TEST_F(Derived, CapacitanceOfAPlate) {
  card_.footprint.radius = std::sqrt(40e-4 / kPi);
  card_.parameters = {{"dielectric_thickness", 1e-6}, {"dielectric_constant", 100}};  // none
  EXPECT_NEAR(of("capacitance_pF", {{"gap_mm", 0.42}}), 85, 1);
  EXPECT_NEAR(of("capacitance_pF", {{"gap_mm", 1}}), 35.4, 0.1);
  card_.parameters = {{"dielectric_thickness", 1e-3}, {"dielectric_constant", 2}};
  EXPECT_NEAR(of("capacitance_pF", {{"gap_mm", 0.5}}), 35.4, 0.1) << "half from the insulation";
  EXPECT_NEAR(of("capacitance_swing", {{"gap_mm", 1.5}, {"gap_swing_mm", 0.2}}), 0.1, 1e-12);
  EXPECT_TRUE(std::isnan(of("capacitance_swing", {{"gap_mm", 1.5}})));
}

TEST_F(Derived, StrainAgainstItsSensor) {
  const MetricValues metrics = {{"strain", 0.05}, {"strain_swing", 0.012}};
  EXPECT_TRUE(std::isnan(of("usable_signal_ratio", metrics))) << "no strain_error";
  card_.parameters = {{"strain_error", 0.004}};
  EXPECT_DOUBLE_EQ(of("usable_signal_ratio", metrics), 3);
  EXPECT_DOUBLE_EQ(of("pre_strain_margin", metrics), 0.038);
  EXPECT_DOUBLE_EQ(of("strain_peak", metrics), 0.062);
}

TEST_F(Derived, TemperatureErrorDividesTheDropByResistances) {
  card_.parameters = {{"skin_temperature", 33}, {"air_temperature", 23}, {"outer_resistance", 0.1}};
  EXPECT_DOUBLE_EQ(of("temperature_error_K", {{"gap_mm", 0}}), 0);
  EXPECT_DOUBLE_EQ(of("temperature_error_K", {{"gap_mm", 2.6}}), 5) << "as much as outside: half";
}

TEST_F(Derived, KeepsWhatIsGivenAndKnowsTheFootprint) {
  card_.footprint.radius = 0.010;
  EXPECT_DOUBLE_EQ(of("sensor_diameter_mm", {}), 20);
  EXPECT_DOUBLE_EQ(of("strain_peak", {{"strain_peak", 7}, {"strain", 1}, {"strain_swing", 1}}), 7);
  card_.footprint.kind = FootprintShape::Kind::line;
  card_.footprint.length = 0.055;
  EXPECT_DOUBLE_EQ(of("sensor_diameter_mm", {}), 55);
  card_.footprint.kind = FootprintShape::Kind::rectangle;
  card_.footprint.size = {0.04, 0.03};
  EXPECT_DOUBLE_EQ(of("sensor_diameter_mm", {}), 40) << "the longer side";
  card_.footprint.kind = FootprintShape::Kind::girth;
  EXPECT_TRUE(std::isnan(of("sensor_diameter_mm", {})));
}

TEST(FootprintShapes, AreToldInWords) {
  FootprintShape shape;
  EXPECT_EQ(in_words(shape), "disc of 24 mm");
  shape.kind = FootprintShape::Kind::rectangle;
  shape.size = {0.04, 0.0255};
  EXPECT_EQ(in_words(shape), "40 x 25.5 mm");
  shape.kind = FootprintShape::Kind::line;
  shape.length = 0.06;
  EXPECT_EQ(in_words(shape), "line of 60 mm");
  shape.kind = FootprintShape::Kind::girth;
  EXPECT_EQ(in_words(shape), "girth");
}

TEST(FootprintShapes, AreaAndCircle) {
  FootprintShape shape;
  shape.radius = 0.1;
  EXPECT_NEAR(area(shape), kPi * 0.01, 1e-15);
  EXPECT_DOUBLE_EQ(outer_radius(shape), 0.1);
  shape.kind = FootprintShape::Kind::rectangle;
  shape.size = {0.08, 0.06};
  EXPECT_DOUBLE_EQ(area(shape), 0.0048);
  EXPECT_DOUBLE_EQ(outer_radius(shape), 0.05);
  shape.kind = FootprintShape::Kind::line;
  shape.length = 0.06;
  EXPECT_DOUBLE_EQ(area(shape), 0);
  EXPECT_DOUBLE_EQ(outer_radius(shape), 0.03);
  shape.kind = FootprintShape::Kind::girth;
  EXPECT_DOUBLE_EQ(area(shape) + outer_radius(shape), 0);
}

TEST(Outlook, IsOpenWhereTheIntervalHoldsThePassMark) {
  Criterion at_most{"gap_mm", {2, 10}, {}, "", "", ""};  // good at 2, fails at 10
  at_most.limit.good = 2, at_most.limit.fail = 10;
  EXPECT_EQ(outlook(at_most, 0.5, 1, 5), Outlook::passes);
  EXPECT_EQ(outlook(at_most, 0.5, 5, 7), Outlook::open);
  EXPECT_EQ(outlook(at_most, 0.5, 7, 30), Outlook::fails);
  Criterion between = at_most;  // from 1.5 on, and not above 6
  between.limit.good = 2, between.limit.fail = 1;
  between.upper = at_most.limit;
  EXPECT_EQ(outlook(between, 0.5, 2, 5), Outlook::passes);
  EXPECT_EQ(outlook(between, 0.5, 0, 1), Outlook::fails);
  EXPECT_EQ(outlook(between, 0.5, 7, 9), Outlook::fails);
  EXPECT_EQ(outlook(between, 0.5, 1, 9), Outlook::open) << "both ends fail, the middle passes";
}

}  // namespace
}  // namespace loosefit::placement
