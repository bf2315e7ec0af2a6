#include "loosefit/body/register_person.h"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "loosefit/body/facing_skin.h"
#include "loosefit/body/lay_person.h"
#include "loosefit/body/missing_limbs.h"
#include "loosefit/body/morph.h"
#include "loosefit/body/person_variables.h"
#include "loosefit/body/rest_body.h"
#include "loosefit/body/stumps.h"
#include "loosefit/body/surface_shift.h"
#include "loosefit/geometry/closest_point_tree.h"

namespace loosefit::body {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using geometry::ClosestPoint;
using geometry::ClosestPointTree;
using geometry::TriangleMesh;

constexpr int kSamples = 2500;        // of the model's skin, and as many of the scan's
constexpr double kNoise = 0.006;      // what one sample is worth [m]
constexpr double kVague = 0.15;       // noise as a share of where outliers begin
constexpr double kPeers = 300;        // samples that know something of their own
constexpr double kSameSide = 0.4;     // least cosine between normals of points that belong together
constexpr double kHandsCount = 0.15;  // weight of hands, whose fingers nobody models
constexpr double kHandsOff =
    0.010 / 1.7;                         // of the stature: farther off, a hand is held another way
constexpr double kPressedCounts = 0.1;   // weight of skin that other skin presses
constexpr double kAdult = 30;            // years to start from
constexpr int kUnsure = 12, kSure = 26;  // Gauss-Newton steps from each start, from the best
constexpr double kFarthest[2] = {0.20, 0.02};  // outliers begin there, at first and at last [m]

double robust_cost(double r, double scale) { return r * r / (r * r + scale * scale); }
double robust_weight(double r, double scale) {
  const double s = scale * scale / (r * r + scale * scale);
  return s * s;
}

/// One point-to-plane distance: a vertex of the model against a point of the scan.
struct Match {
  int vertex = -1;  ///< none: there is nothing within reach
  Vec3 point, normal;
  double weight = 1;
  bool pressed = false;  ///< maybe, by other skin: the person reaches there or farther

  double counts() const { return pressed ? kPressedCounts * weight : weight; }
  /// In the fit, of a distance r of the vertex outwards from the point.
  double weight_at(double r, double scale) const {
    return pressed && r > 0 ? 0 : counts() * robust_weight(r, scale);
  }
};

/// Points of the scan's skin, evenly spread, with their normals.
struct SkinSamples {
  std::vector<Vec3> point, normal;
};

SkinSamples spread_samples(const TriangleMesh& mesh, int count) {
  std::vector<double> area;
  double sum = 0;
  for (const Triangle& t : mesh.triangles)
    area.push_back(sum += geometry::triangle_area(mesh.vertices[std::size_t(t[0])],
                                                  mesh.vertices[std::size_t(t[1])],
                                                  mesh.vertices[std::size_t(t[2])]));
  SkinSamples samples;
  for (int i = 0; i < count; ++i) {
    const auto t =
        std::size_t(std::ranges::lower_bound(area, sum * (i + 0.5) / count) - area.begin());
    const auto& [a, b, c] = mesh.triangles[std::min(t, area.size() - 1)];
    const Vec3 &p = mesh.vertices[std::size_t(a)], &q = mesh.vertices[std::size_t(b)],
               &r = mesh.vertices[std::size_t(c)];
    samples.point.push_back((p + q + r) / 3);
    samples.normal.push_back(geometry::triangle_normal(p, q, r));
  }
  return samples;
}

bool is_same_limb(const MissingLimb& a, const MissingLimb& b) {
  return a.side == b.side && a.of_leg() == b.of_leg();
}

class Registration {
 public:
  Registration(const BodyModel& model, const TriangleMesh& scan)
      : model_(model),
        data_(model.data()),
        morph_(data_),
        scan_(scan),
        tree_(scan_),
        scan_normals_(geometry::smooth_normals(scan)),
        samples_(spread_samples(scan, kSamples)) {
    coarse_ = model.rest({}, BodyDetail::coarse).surface.triangles;
    const int step = std::max(1, data_.body_vertices / kSamples);
    for (int v = 0; v < data_.body_vertices; v += step) sampled_.push_back(v);
    pressed_.resize(samples_.point.size());
    tbb::parallel_for(std::size_t(0), pressed_.size(), [&](std::size_t i) {
      pressed_[i] = is_pressed(samples_.point[i], samples_.normal[i]);
    });
    for (const Vec3& p : scan.vertices) height_ = std::max(height_, p.z());
  }

  /// How old somebody of the scan's stature may be: an adult, below 1.50 m a child as well
  /// (roughly 5 years at 1.10 m, 11 years at 1.45 m).
  std::vector<double> ages() const {
    if (height_ >= 1.50) return {kAdult};
    return {std::clamp(5 + (height_ - 1.10) / 0.058, 3.0, 14.0), kAdult};
  }

  /// An upright person of the scan's stature with the arms so far aside.
  PosedPerson start(double age, double abduction) const {
    PosedPerson person;
    BodyParameters& p = person.parameters;
    p.age = age;
    for (double low = 0, high = 1; high - low > 0.01;) {
      p.height = (low + high) / 2;
      auto rows = morph_.rows(p);
      rows.resize(std::size_t(data_.body_vertices));
      (extent(rows).second - extent(rows).first < height_ ? low : high) = p.height;
    }
    auto rows = morph_.rows(p);
    const auto joints = joint_positions(data_, rows);
    Posture posture;
    posture.arm_abduction = abduction;
    posture.relaxed_arms = abduction < radians(25) ? 1 : 0;
    posture.elbow_extension = abduction > radians(60) ? 0.9 : 0.3;
    person.rotations = posture_rotations(data_, joints, posture);
    // Feet on the floor, trunk and head over those of the scan.
    rows.resize(std::size_t(data_.body_vertices));
    person.place.translation() = foot_of(scan_.vertices) - foot_of(rows);
    return person;
  }

  /// The person who looks and stands most like the scan.
  PosedPerson nearest() const {
    // Arms hanging, as the model has them, and level: a registration finds its way over some 30°.
    PosedPerson best;
    double least = std::numeric_limits<double>::infinity();
    for (const double age : ages())
      for (const double abduction : {10.0, 42.0, 82.0}) {
        PosedPerson person = start(age, radians(abduction));
        const double cost = improve(person, kUnsure, kFarthest[0], kFarthest[0] / 4);
        if (cost < least) least = cost, best = person;
      }
    improve(best, kSure, kFarthest[0] / 4, kFarthest[1]);
    return best;
  }

  /// From now on nothing is known of hands.
  void leave_hands_out() { hands_count_ = 0; }

  /// A limb that the scan lacks is drawn to skin of others, and draws the rest along. So the person
  /// is laid on the scan again without the limbs that may be missing, and once more without what is
  /// found missing then. Kept where the rest explains the scan as well as the whole person did.
  std::vector<MissingLimb> leave_out_missing(PosedPerson& person) {
    constexpr double kLess = 0.01;
    std::vector<MissingLimb> missing = missing_limbs(model_, person, scan_);
    for (MissingLimb& limb : doubtful_limbs(model_, person, scan_)) {
      std::erase_if(missing, [&](const MissingLimb& m) { return is_same_limb(m, limb); });
      missing.push_back(std::move(limb));
    }
    if (missing.empty()) return missing;
    leave_out(missing);
    PosedPerson without = nearest();
    leave_out(missing = missing_limbs(model_, without, scan_));
    if (!missing.empty()) {
      improve(without, kSure, kFarthest[0] / 4, kFarthest[1]);
      missing = missing_limbs(model_, without, scan_);
    }
    if (!missing.empty() && explained_share(model_, without, missing, scan_) >
                                explained_share(model_, person, {}, scan_) - kLess)
      person = std::move(without);
    else
      missing.clear();
    leave_out(missing);
    return missing;
  }

  /// From now on nothing is known of what these limbs have beyond their ends.
  void leave_out(const std::vector<MissingLimb>& limbs) {
    lacks_.assign(std::size_t(data_.body_vertices), 0);
    for (const MissingLimb& limb : limbs)
      for (const int v : limb.vertices)
        if (v < data_.body_vertices) lacks_[std::size_t(v)] = 1;
  }

  /// Whether one of the hands, in the mean over its skin, is too far from the scan to be as it is
  /// there.
  bool hands_are_off(const PosedPerson& person) const {
    const auto rows = rows_of(person);
    const auto surface = surface_of(person, rows);
    double sum[2] = {}, count[2] = {};
    for (int v = 0; v < data_.body_vertices; ++v)
      if (is_hand(v) && !lacks(v)) {
        const bool left = rows[std::size_t(v)].x() > 0;
        sum[left] += tree_.query(surface[std::size_t(v)]).distance;
        ++count[left];
      }
    const double most = kHandsOff * height_;
    return sum[0] > most * count[0] || sum[1] > most * count[1];
  }

  /// Whether a person lies on the scan at least as well as another one does, by distances both
  /// ways of all skin that neither of them takes for hands.
  bool is_as_near(const PosedPerson& one, const PosedPerson& other) const {
    const std::vector<double> costs = costs_without_hands(one), others = costs_without_hands(other);
    double difference = 0;
    for (std::size_t i = 0; i < costs.size(); ++i)
      if (costs[i] != kNotSeen && others[i] != kNotSeen) difference += costs[i] - others[i];
    return difference <= 0;
  }

  /// Takes `steps` Gauss-Newton steps; the cost of the last.
  double improve(PosedPerson& person, int steps, double first, double last) const {
    PersonVariables variables(data_, person);
    VectorXd x = VectorXd::Zero(variables.size());
    double cost = 0;
    for (int k = 0; k < steps; ++k) {
      const double share = steps > 1 ? double(k) / (steps - 1) : 1;
      const double scale = first * std::pow(last / first, std::min(1.0, 1.3 * share));
      cost = step(variables, x, scale);
    }
    person = variables.at(x);
    return cost;
  }

 private:
  /// Lowest and highest.
  static std::pair<double, double> extent(const std::vector<Vec3>& points) {
    const auto by_height = [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); };
    const auto [low, high] = std::ranges::minmax_element(points, by_height);
    return {low->z(), high->z()};
  }

  /// The point of the floor below the middle of the head, at the middle of the hip from the side.
  Vec3 foot_of(const std::vector<Vec3>& points) const {
    constexpr double kHip[2] = {0.50, 0.56}, kHead = 0.90;  // of the stature
    const double floor = extent(points).first;
    Eigen::AlignedBox1d across, along;
    for (const Vec3& p : points) {
      const double z = (p.z() - floor) / height_;
      if (z > kHip[0] && z < kHip[1]) along.extend(Eigen::Matrix<double, 1, 1>(p.y()));
      if (z > kHead) across.extend(Eigen::Matrix<double, 1, 1>(p.x()));
    }
    // Surfaces without vertices there are nobody, who stands at the origin.
    return {across.isEmpty() ? 0 : across.center().x(), along.isEmpty() ? 0 : along.center().x(),
            floor};
  }

  bool is_hand(int vertex) const { return model_.segments()[std::size_t(vertex)] == Segment::hand; }

  bool lacks(int vertex) const { return !lacks_.empty() && lacks_[std::size_t(vertex)]; }

  double weight_of(int vertex) const {
    return lacks(vertex) ? 0 : is_hand(vertex) ? hands_count_ : 1;
  }

  static constexpr double kNotSeen = -1;

  /// Of the samples of the model's skin and of the scan's, kNotSeen of those at the model's hands.
  std::vector<double> costs_without_hands(const PosedPerson& person) const {
    const auto surface = surface_of(person, rows_of(person));
    std::vector<double> costs;
    for (const int v : sampled_)
      costs.push_back(
          is_hand(v) || lacks(v)
              ? kNotSeen
              : robust_cost(tree_.query(surface[std::size_t(v)]).distance, kFarthest[1]));
    const TriangleMesh mesh{surface, coarse_};
    const ClosestPointTree tree(mesh);
    for (const Vec3& p : samples_.point) {
      const ClosestPoint c = tree.query(p);
      const int v = coarse_[std::size_t(c.triangle)][0];
      costs.push_back(is_hand(v) || lacks(v) ? kNotSeen : robust_cost(c.distance, kFarthest[1]));
    }
    return costs;
  }

  std::vector<Vec3> rows_of(const PosedPerson& p) const { return morph_.rows(p.parameters); }

  Vec3 posed(const PosedPerson& p, const std::vector<Eigen::Affine3d>& bones,
             const std::vector<Vec3>& rows, int vertex) const {
    Vec3 sum = Vec3::Zero();
    for (const auto& [bone, weight] : data_.skin[std::size_t(vertex)])
      sum += weight * (bones[std::size_t(bone)] * rows[std::size_t(vertex)]);
    return p.place * sum;
  }

  std::vector<Vec3> surface_of(const PosedPerson& person, const std::vector<Vec3>& rows) const {
    const auto bones = pose_bones(data_, joint_positions(data_, rows), person.rotations);
    std::vector<Vec3> surface(std::size_t(data_.body_vertices));
    for (int v = 0; v < data_.body_vertices; ++v)
      surface[std::size_t(v)] = posed(person, bones, rows, v);
    return surface;
  }

  std::vector<Match> matches(const std::vector<Vec3>& surface, double scale) const {
    const TriangleMesh mesh{surface, coarse_};
    const auto normals = geometry::vertex_normals(surface, coarse_);
    const double reach = 3 * scale;
    std::vector<Match> found(sampled_.size() + samples_.point.size());
    // Model to scan.
    tbb::parallel_for(std::size_t(0), sampled_.size(), [&](std::size_t i) {
      const int v = sampled_[i];
      const Vec3 &p = surface[std::size_t(v)], &n = normals[std::size_t(v)];
      const ClosestPoint c =
          tree_.query(p, reach, [&](int t) { return scan_normal(t).dot(n) > kSameSide; });
      if (c.triangle < 0) return;
      const Vec3& m = scan_normal(c.triangle);
      found[i] = {v, c.point, m, weight_of(v), is_pressed(c.point, m)};
    });
    // Scan to model.
    const ClosestPointTree tree(mesh);
    tbb::parallel_for(std::size_t(0), samples_.point.size(), [&](std::size_t i) {
      const Vec3 &p = samples_.point[i], &n = samples_.normal[i];
      const ClosestPoint c = tree.query(p, reach, [&](int t) {
        const Triangle& corner = coarse_[std::size_t(t)];
        return normals[std::size_t(corner[0])].dot(n) > kSameSide;
      });
      if (c.triangle < 0) return;
      Eigen::Index nearest = 0;
      c.barycentric.maxCoeff(&nearest);
      const int v = coarse_[std::size_t(c.triangle)][std::size_t(nearest)];
      // The plane is moved by as much as the vertex is from the closest point.
      found[sampled_.size() + i] = {v, p + surface[std::size_t(v)] - c.point, n, weight_of(v),
                                    pressed_[i] != 0};
    });
    std::erase_if(found, [](const Match& match) { return match.vertex < 0; });
    return found;
  }

  /// Whether other skin faces a place of the scan's skin nearby and may press it.
  bool is_pressed(const Vec3& p, const Vec3& n) const {
    return faces_skin(
        tree_, [&](int t) { return scan_normal(t); }, p, n);
  }

  const Vec3& scan_normal(int triangle) const { return scan_normals_[std::size_t(triangle)]; }

  double step(const PersonVariables& variables, VectorXd& x, double scale) const {
    const PosedPerson now = variables.at(x);
    const auto rows = rows_of(now);
    const std::vector<Vec3> surface = surface_of(now, rows);
    const std::vector<Match> matched = matches(surface, scale);
    const auto m = Eigen::Index(matched.size()), n = x.size();
    const auto residuals = [&](const PosedPerson& p, const std::vector<Vec3>& r) {
      const auto b = pose_bones(data_, joint_positions(data_, r), p.rotations);
      VectorXd value(m);
      for (Eigen::Index i = 0; i < m; ++i) {
        const Match& match = matched[std::size_t(i)];
        value[i] = match.normal.dot(posed(p, b, r, match.vertex) - match.point);
      }
      return value;
    };
    const VectorXd r0 = residuals(now, rows);
    VectorXd weight(m);
    for (Eigen::Index i = 0; i < m; ++i)
      weight[i] = matched[std::size_t(i)].weight_at(r0[i], scale);
    MatrixXd jacobian = MatrixXd::Zero(m, n);
    tbb::parallel_for(Eigen::Index(0), n, [&](Eigen::Index j) {
      VectorXd y = x;
      y[j] += variables.difference(int(j));
      if (variables.clamped(y)[j] != y[j]) y[j] = x[j] - variables.difference(int(j));
      const PosedPerson there = variables.at(y);
      jacobian.col(j) =
          (residuals(there, variables.is_shape(int(j)) ? rows_of(there) : rows) - r0) /
          (y[j] - x[j]);
    });
    // Many samples tell of the same misfit, so they count as kPeers of them.
    // While correspondences are vague, so is what they tell.
    const double noise = std::max(kNoise, kVague * scale);
    const double trust = kPeers / std::max<double>(1, double(m)) / (noise * noise);
    MatrixXd normal = trust * jacobian.transpose() * weight.asDiagonal() * jacobian;
    VectorXd right = -trust * jacobian.transpose() * weight.cwiseProduct(r0);
    for (Eigen::Index j = 0; j < n; ++j) {
      const double prior = 1 / (variables.spread(int(j)) * variables.spread(int(j)));
      normal(j, j) += prior;
      right[j] -= prior * x[j];
    }
    const VectorXd change = normal.ldlt().solve(right);
    double most = 1;
    for (Eigen::Index j = 0; j < n; ++j)
      most = std::max(most, std::abs(change[j]) / variables.spread(int(j)));
    x = variables.clamped(x + change / most);
    double cost = 0;
    for (Eigen::Index i = 0; i < m; ++i)
      cost += matched[std::size_t(i)].counts() * robust_cost(r0[i], scale);
    // What found no partner costs as an outlier does.
    return cost + double(sampled_.size() + samples_.point.size()) - double(m);
  }

  const BodyModel& model_;
  const BodyData& data_;
  Morph morph_;
  const TriangleMesh& scan_;
  ClosestPointTree tree_;
  std::vector<Vec3> scan_normals_;  ///< of its triangles
  SkinSamples samples_;
  std::vector<char> pressed_;  ///< each
  std::vector<Triangle> coarse_;
  std::vector<int> sampled_;
  double height_ = 0;
  double hands_count_ = kHandsCount;
  std::vector<char> lacks_;  ///< per vertex, whether it is of a missing limb; empty: none is
};

/// Skin that one side lacks is that of the other, turned over, where the other has it.
void mirror_missing_skin(const BodyData& data, RegisteredPerson& registered) {
  std::vector<char> lacks(std::size_t(data.body_vertices), 0);
  for (const MissingLimb& limb : registered.missing)
    for (const int v : limb.vertices)
      if (v < data.body_vertices) lacks[std::size_t(v)] = 1;
  auto shift = *registered.person.parameters.shift;
  for (std::size_t v = 0; v < lacks.size(); ++v) {
    const auto other = std::size_t(data.mirror[v]);
    if (!lacks[v] || lacks[other]) continue;
    shift[v] = Vec3(-shift[other].x(), shift[other].y(), shift[other].z());
  }
  registered.person.parameters.shift = std::make_shared<const std::vector<Vec3>>(std::move(shift));
}

}  // namespace

RegisteredPerson register_person(const BodyModel& model, const TriangleMesh& scan) {
  Registration registration(model, scan);
  PosedPerson person = registration.nearest();
  std::vector<MissingLimb> missing = registration.leave_out_missing(person);
  // Fists, or hands that hold something, would draw the arms to where the model's fingers end.
  // An arm that lies elsewhere for another reason is not always found better without its hand;
  // where it is, the hand may well be the model's.
  bool left_out = false;
  if (registration.hands_are_off(person)) {
    registration.leave_hands_out();
    PosedPerson handless = registration.nearest();
    if (registration.is_as_near(handless, person)) {
      person = std::move(handless);
      // A hand that is missing had drawn the wrist to where the skin ends.
      missing = missing_limbs(model, person, scan);
      registration.leave_out(missing);
      left_out = registration.hands_are_off(person);
    }
  }
  std::vector<ShortFoot> short_ones = short_feet(model, person, missing, scan);
  RegisteredPerson registered = lay_skin(model, scan, person, std::move(missing));
  registered.short_feet = std::move(short_ones);
  if (!registered.missing.empty()) {
    mirror_missing_skin(model.data(), registered);
    registered.person.parameters.stumps = std::make_shared<const Stumps>(
        lay(model, registered.person), registered.person.place, registered.missing);
  }
  registered.hands_left_out = left_out;
  return registered;
}

}  // namespace loosefit::body
