#pragma once
#include <set>
#include <string>
#include <vector>

#include "loosefit/io/pattern_svg.h"
#include "loosefit/pipeline/edge_distances.h"
#include "loosefit/placement/ranking_table.h"

// SVG signs of a sewing plan, on one piece of the sheet.
namespace loosefit::report {

/// Strips along seams (`sewn`: edges) and free edges, and keep-out zones, cut to the piece.
std::string forbidden_marks(const pattern::Panel& panel, const std::set<int>& sewn,
                            const placement::SearchConstraints& constraints,
                            const io::PanelOnSheet& sheet);

/// Outline, axis, tolerance and edge distances of one sensor.
std::string sensor_marks(const placement::RankedPlace& place, const pattern::Panel& panel,
                         const io::PanelOnSheet& sheet, bool passes);

/// The stretches of a line round the body that lie on this piece.
std::string line_marks(const placement::RankedPlace& place, const std::string& panel,
                       const io::PanelOnSheet& sheet);

/// A cross with the site's name.
std::string failing_mark(const placement::RankedPlace& place, const std::string& name,
                         const io::PanelOnSheet& sheet);

/// Sheet points [mm] along the lines of sensor_marks, for labels to keep off.
std::vector<Vec2> marked_points(const placement::RankedPlace& place, const pattern::Panel& panel,
                                const io::PanelOnSheet& sheet);

/// Text of the sheet with a white rim, so that it can be read over lines; `at` in sheet [mm].
std::string rimmed_text(const Vec2& at, double size, const std::string& words, const char* anchor,
                        const char* colour = "black");

}  // namespace loosefit::report
