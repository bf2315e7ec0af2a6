#pragma once
#include <vector>

#include "loosefit/garment/hierarchy.h"
#include "loosefit/pipeline/case_pattern.h"

namespace loosefit::pipeline {

/// Writes the ease of the stations of a pattern to the vertices of its meshes
/// (Garment::vertex_ease_cut, vertex_ease_asked), even between stations and alike on both sides of
/// the body. Beyond the first and last station by more than a step it is not known.
void set_vertex_ease(garment::GarmentHierarchy& hierarchy, const CasePattern& pattern);

/// Girth of the worn cloth along the lines of a station [m]: the way of its yarns, wrinkles and
/// all; 0 where the mesh has no such line.
double worn_girth(const garment::Garment& garment, const std::vector<Vec3>& positions,
                  const StationFit& station);

/// How much finer each panel is meshed, for build_hierarchy: where pieces lie close round a limb
/// (cut below kLooseEase) edges are at most kLimbEdge of its least radius there, but no finer than
/// kFinestLimb of the wanted edge.
std::vector<double> limb_fineness(const CasePattern& pattern, double edge_length);
inline constexpr double kLimbEdge = 1.0 / 3, kFinestLimb = 0.5;

/// In words: close limbs on which the edges of the mesh are still longer than that, with what it
/// does to gaps and pressure there.
std::vector<std::string> limb_mesh_warnings(const garment::Garment& garment,
                                            const CasePattern& pattern);

}  // namespace loosefit::pipeline
