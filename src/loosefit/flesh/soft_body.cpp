#include "loosefit/flesh/soft_body.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>

#include "loosefit/base/build_id.h"
#include "loosefit/base/disk_cache.h"
#include "loosefit/base/sha256.h"
#include "loosefit/flesh/soft_skin.h"
#include "loosefit/geometry/exact_intersection.h"

namespace loosefit::flesh {
namespace {

constexpr double kStep = 0.5;            ///< largest joint angle of one step on the way [rad]
constexpr std::size_t kRemembered = 32;  ///< bodies; 9 MB each
constexpr double kMargin = 0.05;         ///< of skin round what overlaps that may give way [m]

/// What a garment can get between.
bool is_dressed(body::Segment s) {
  return s == body::Segment::torso || s == body::Segment::neck || s == body::Segment::upper_arm ||
         s == body::Segment::forearm || s == body::Segment::thigh;
}

/// The dressed triangles: most of a body's are hands, feet and face.
struct DressedSkin {
  explicit DressedSkin(const body::Body& body) {
    const auto& all = body.surface.triangles;
    for (std::size_t t = 0; t < all.size(); ++t)
      if (is_dressed(body.segment[all[t][0]])) {
        number.push_back(static_cast<int>(t));
        triangles.push_back(all[t]);
      }
  }
  /// Pairs of these triangles by their numbers of the body.
  Overlaps numbered(Overlaps pairs) const {
    for (auto& [a, b] : pairs) a = number[a], b = number[b];
    return pairs;
  }
  std::vector<int> number;
  std::vector<Triangle> triangles;
};

/// overlaps_of a body whose vertices `moved`, and no others, are not where they were when
/// `before` was found.
Overlaps overlaps_after(const body::Body& body, const Overlaps& before,
                        const std::vector<int>& moved) {
  std::vector<char> has_moved(body.surface.vertices.size());
  for (int v : moved) has_moved[v] = 1;
  const auto touched = [&](const Triangle& t) {
    return has_moved[t[0]] || has_moved[t[1]] || has_moved[t[2]];
  };
  const DressedSkin skin(body);
  std::vector<char> wanted;
  for (const Triangle& t : skin.triangles) wanted.push_back(touched(t));
  Overlaps overlaps =
      skin.numbered(geometry::self_intersections(body.surface.vertices, skin.triangles, wanted));
  for (const auto& [a, b] : before)
    if (!touched(body.surface.triangles[a]) && !touched(body.surface.triangles[b]))
      overlaps.emplace_back(a, b);
  std::sort(overlaps.begin(), overlaps.end());
  return overlaps;
}

/// Its name and what it can do, as Linux tells it.
const std::string& processor() {
  static const std::string kName = [] {
    std::string found;
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line) && !line.empty();)
      if (line.starts_with("model name") || line.starts_with("flags")) found += line;
    return found;
  }();
  return kName;
}

template <class Values>
std::string_view bytes_of(const Values& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0])};
}

}  // namespace

Overlaps overlaps_of(const body::Body& body) {
  const DressedSkin skin(body);
  return skin.numbered(geometry::self_intersections(body.surface.vertices, skin.triangles));
}

double turn_between(const body::Posture& a, const body::Posture& b) {
  double most = 0;
  for (double body::Posture::*number : body::kPostureNumbers) {
    const double turn = number == &body::Posture::sitting ? kPi / 2 : 1;  // of hips and knees
    most = std::max(most, turn * std::abs(a.*number - b.*number));
  }
  return most;
}

body::Body displaced(body::Body body, const std::vector<Vec3>& moved) {
  for (std::size_t v = 0; v < moved.size(); ++v) {
    body.surface.vertices[v] += moved[v];
    body.pose_from_rest[v].col(3) += moved[v];
  }
  body.normals = geometry::vertex_normals(body.surface.vertices, body.surface.triangles);
  for (const auto& [name, v] : body.landmark_vertex)
    body.landmarks[name] = body.surface.vertices[static_cast<std::size_t>(v)];
  return body;
}

body::Body SoftBody::moved(body::Body body, const CachedDisplacement& cached) {
  if (cached.vertex.empty()) return body;
  std::vector<Vec3> all(body.surface.vertices.size(), Vec3::Zero());
  for (std::size_t i = 0; i < cached.vertex.size(); ++i) all[cached.vertex[i]] = cached.moved[i];
  return displaced(std::move(body), all);
}

const body::BodyShape& SoftBody::shape() const {
  if (!shape_) shape_ = std::make_shared<const body::BodyShape>(model_.shape(parameters_));
  return *shape_;
}

const SoftBody::CachedDisplacement& SoftBody::nearest(const body::Posture& posture) {
  if (cached_.empty()) {
    cached_.push_back({model_.rest_posture(parameters_), {}, {}});
    rest_ = built(cached_.front().posture);
  }
  const auto turn = [&](const CachedDisplacement& cached) {
    return turn_between(cached.posture, posture);
  };
  return *std::min_element(
      cached_.begin(), cached_.end(),
      [&](const CachedDisplacement& a, const CachedDisplacement& b) { return turn(a) < turn(b); });
}

SoftBody::CachedDisplacement SoftBody::led_from(const CachedDisplacement& start,
                                                const body::Posture& posture,
                                                const body::Body& body, const SkinPatch& patch,
                                                Progress* progress) const {
  std::vector<Vec3> surface = built(start.posture);
  const std::vector<Vec3> target = patch.of(surface);
  for (std::size_t i = 0; i < start.vertex.size(); ++i) surface[start.vertex[i]] += start.moved[i];
  SoftSkin skin(patch, patch.of(rest_), patch.of(surface), target);
  const int steps = static_cast<int>(std::ceil(turn_between(start.posture, posture) / kStep));
  for (int k = 1; k < steps; ++k) {
    skin.follow(patch.of(built(body::blend(start.posture, posture, double(k) / steps))), progress);
    if (progress) progress->update(double(k) / steps, "");
  }
  skin.follow(patch.of(body.surface.vertices), progress);
  CachedDisplacement there{posture, patch.vertex, skin.positions()};
  for (std::size_t i = 0; i < there.moved.size(); ++i) there.moved[i] -= skin.target()[i];
  return there;
}

body::PosedBody SoftBody::in(const body::Posture& posture, Progress* progress) {
  for (auto& [asked, body] : remembered_)
    if (asked == posture) return body.posed();
  const body::PosedBody body = made(posture, progress);
  if (remembered_.size() < kRemembered)
    remembered_.emplace_back(posture, body::RememberedBody(body));
  return body;
}

void SoftBody::merge_cache(const SoftBody& copy) {
  if (cached_.empty()) rest_ = copy.rest_;
  if (!overlaps_at_rest_) overlaps_at_rest_ = copy.overlaps_at_rest_;
  const auto is_cached = [&](const body::Posture& posture) {
    return std::any_of(cached_.begin(), cached_.end(),
                       [&](const CachedDisplacement& cached) { return cached.posture == posture; });
  };
  for (const CachedDisplacement& cached : copy.cached_)
    if (!is_cached(cached.posture)) cached_.push_back(cached);
  for (const auto& [posture, body] : copy.remembered_) {
    const bool remembered =
        std::any_of(remembered_.begin(), remembered_.end(),
                    [p = &posture](const auto& own) { return own.first == *p; });
    if (!remembered && remembered_.size() < kRemembered) remembered_.emplace_back(posture, body);
  }
}

const std::set<std::pair<int, int>>& SoftBody::overlaps_at_rest() {
  if (!overlaps_at_rest_) {
    const Overlaps overlaps = overlaps_of(as_built(model_.rest_posture(parameters_)));
    overlaps_at_rest_.emplace(overlaps.begin(), overlaps.end());
  }
  return *overlaps_at_rest_;
}

bool SoftBody::is_free(const Overlaps& overlaps) {
  return std::all_of(overlaps.begin(), overlaps.end(),
                     [&](const auto& pair) { return overlaps_at_rest().count(pair) > 0; });
}

Overlaps SoftBody::left_in(const body::Body& posed) {
  Overlaps left = overlaps_of(posed);
  std::erase_if(left, [&](const auto& pair) { return overlaps_at_rest().count(pair) > 0; });
  return left;
}

SoftBody::Way SoftBody::led_to(const body::Posture& posture, const body::Body& stiff,
                               Progress* progress) {
  const Overlaps overlaps = overlaps_of(stiff);
  if (overlaps.empty()) return {{posture, {}, {}}, true};
  const auto from = [&](const CachedDisplacement& start, double margin) {
    Way way{
        led_from(start, posture, stiff, patch_round(stiff.surface, overlaps, margin), progress)};
    way.is_free = is_free(overlaps_after(moved(stiff, way.there), overlaps, way.there.vertex));
    return way;
  };
  const Way way = from(nearest(posture), kMargin);
  // Otherwise what gave way met skin beyond the patch: all the way again, with more of it.
  return way.is_free ? way : from(cached_.front(), 2 * kMargin);
}

std::string SoftBody::written(const Way& way) {
  std::string bytes(1, way.is_free ? '1' : '0');
  bytes += bytes_of(way.there.vertex);
  return bytes += bytes_of(way.there.moved);
}

std::optional<SoftBody::Way> SoftBody::read_way(const std::string& bytes,
                                                const body::Posture& posture) {
  constexpr std::size_t kOne = sizeof(int) + sizeof(Vec3);
  if (bytes.size() % kOne != 1) return std::nullopt;
  const std::size_t n = bytes.size() / kOne;
  Way way{{posture, std::vector<int>(n), std::vector<Vec3>(n)}, bytes[0] == '1'};
  std::memcpy(way.there.vertex.data(), bytes.data() + 1, n * sizeof(int));
  std::memcpy(static_cast<void*>(way.there.moved.data()), bytes.data() + 1 + n * sizeof(int),
              n * sizeof(Vec3));
  return way;
}

std::string SoftBody::key_of(const body::Posture& posture, const body::Body& stiff,
                             const CachedDisplacement& start) const {
  // Kernels of linear algebra are chosen by the processor.
  std::string all = "flesh " + build_id() + processor();
  for (double body::Posture::*number : body::kPostureNumbers)
    for (const body::Posture* p : {&start.posture, &posture})
      all += bytes_of(std::array{p->*number});
  for (const std::vector<Vec3>* field : {&rest_, &stiff.surface.vertices, &start.moved})
    all += bytes_of(*field);
  all += bytes_of(start.vertex);
  all += bytes_of(stiff.surface.triangles);
  return sha256_hex(all += bytes_of(stiff.segment));
}

body::Body SoftBody::made(const body::Posture& posture, Progress* progress) {
  body::Body stiff = as_built(posture);
  const CachedDisplacement& start = nearest(posture);
  if (turn_between(start.posture, posture) == 0) return moved(std::move(stiff), start);
  const bool is_kept = !disk_cache::folder().empty() && !build_id().empty();
  const std::string key = is_kept ? key_of(posture, stiff, start) : std::string();
  std::optional<Way> way;
  if (const auto bytes = is_kept ? disk_cache::load(key) : std::nullopt)
    way = read_way(*bytes, posture);
  if (!way) {
    way = led_to(posture, stiff, progress);
    if (is_kept) disk_cache::store(key, written(*way));
  }
  if (way->there.vertex.empty()) return stiff;
  body::Body body = moved(std::move(stiff), way->there);
  if (way->is_free) cached_.push_back(std::move(way->there));
  return body;
}

}  // namespace loosefit::flesh
