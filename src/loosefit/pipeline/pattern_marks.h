#pragma once
#include <string>
#include <vector>

#include "loosefit/io/dxf/dxf_write.h"
#include "loosefit/placement/ranking_table.h"
#include "loosefit/scenario/scenario.h"

namespace loosefit::pipeline {

/// Outline of a sensor on its piece: discs of 72 corners, rectangles, lines along the axis; of a
/// girth its centre alone. \param angle of the axis in the pattern [rad]
io::PatternMark sensor_mark(const std::string& name, const std::string& panel, const Vec2& at,
                            double angle, const placement::FootprintShape& shape);

/// What a scenario fixes to the garment that it studies: boards and cables, and the sites that name
/// a piece. Sites over landmarks of the body are known when the garment is worn.
std::vector<io::PatternMark> scenario_marks(const scenario::Scenario& scenario);

/// The places of a ranking that score above 0.
std::vector<io::PatternMark> ranking_marks(const placement::RankingTable& table);

}  // namespace loosefit::pipeline
