#include "loosefit/io/svg/svg_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "loosefit/base/error.h"
#include "loosefit/base/text.h"

namespace loosefit::io {
namespace {

constexpr double kLargest = 1e7;               // coordinate that is one
constexpr std::size_t kMostSegments = 20'000;  // of one path
constexpr int kMostChords = 400;
constexpr double kArcPart = std::numbers::pi / 6;

/// Walks over numbers and letters as the grammars of SVG have them.
class Scanner {
 public:
  Scanner(const std::string& text, const std::string& file, int line, std::string key)
      : text_(text), file_(file), line_(line), key_(std::move(key)) {}

  void skip() {
    while (at_ < text_.size() && (is_space(text_[at_]) || text_[at_] == ',')) ++at_;
  }
  bool done() {
    skip();
    return at_ >= text_.size();
  }
  /// The next character that is no separator; 0 at the end.
  char peek() {
    skip();
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  char take() { return text_[at_++]; }
  bool at_number() {
    const char c = peek();
    return (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
  }
  double number() {
    skip();
    std::size_t begin = at_;
    if (begin < text_.size() && text_[begin] == '+') ++begin;
    double value = 0;
    const auto [end, error] =
        std::from_chars(text_.data() + begin, text_.data() + text_.size(), value);
    if (error != std::errc() || !std::isfinite(value) || std::abs(value) > kLargest)
      fail(fmt::format("a number of at most {:g}", kLargest));
    at_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }
  Vec2 point() {
    const double x = number();
    return {x, number()};
  }
  /// Flags of arcs may stand without anything between them.
  bool flag() {
    const char c = peek();
    if (c != '0' && c != '1') fail("a flag, 0 or 1");
    ++at_;
    return c == '1';
  }
  std::string word() {
    skip();
    const std::size_t begin = at_;
    while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_]))) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  [[noreturn]] void fail(const std::string& expected) const {
    const std::string here =
        at_ < text_.size() ? '"' + printable(text_.substr(at_, 20)) + '"' : std::string("the end");
    throw InvalidInput({file_, line_, key_}, fmt::format("{} at character {}", here, at_ + 1),
                       expected);
  }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
  const std::string& text_;
  const std::string& file_;
  int line_;
  std::string key_;
  std::size_t at_ = 0;
};

/// A circle's arc of angle `sweep` as one cubic reaches so far along the tangents, in radii.
double handle(double sweep) { return 4.0 / 3.0 * std::tan(sweep / 4); }

/// Arc of an ellipse from its centre, radii, turn and angles [rad].
void add_arc(SvgRun& run, const Vec2& centre, const Vec2& radii, double turn, double from,
             double sweep) {
  const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / kArcPart)));
  const Eigen::Rotation2Dd rotation(turn);
  const auto on = [&](const Vec2& unit) -> Vec2 {
    return centre + rotation * radii.cwiseProduct(unit);
  };
  const double step = sweep / parts, k = handle(step);
  for (int i = 0; i < parts; ++i) {
    const double a = from + i * step, b = a + step;
    const Vec2 at_a(std::cos(a), std::sin(a)), at_b(std::cos(b), std::sin(b));
    run.curve_to(on(at_a + k * Vec2(-at_a.y(), at_a.x())), on(at_b - k * Vec2(-at_b.y(), at_b.x())),
                 on(at_b));
  }
}

/// W3C SVG 1.1, F.6.5 and F.6.6.
void arc_to(SvgRun& run, Vec2 radii, double turn, bool large, bool sweep, const Vec2& to) {
  const Vec2 from = run.end();
  radii = radii.cwiseAbs();
  if ((to - from).norm() == 0) return;
  if (radii.minCoeff() < 1e-12) return run.line_to(to);
  const Eigen::Rotation2Dd rotation(turn);
  const Vec2 half = rotation.inverse() * ((from - to) / 2);
  const double reach = half.cwiseQuotient(radii).squaredNorm();
  if (reach > 1) radii *= std::sqrt(reach);
  const Vec2 unit = half.cwiseQuotient(radii);
  const double square = unit.squaredNorm();
  double size = std::sqrt(std::max(0.0, (1 - square) / square));
  if (large == sweep) size = -size;
  const Vec2 middle = size * Vec2(unit.y(), -unit.x());  // centre, in units of the radii
  const Vec2 centre = rotation * radii.cwiseProduct(middle) + (from + to) / 2;
  const Vec2 a = unit - middle, b = -unit - middle;
  const double begin = std::atan2(a.y(), a.x());
  double angle = std::atan2(b.y(), b.x()) - begin;
  if (sweep && angle < 0) angle += 2 * std::numbers::pi;
  if (!sweep && angle > 0) angle -= 2 * std::numbers::pi;
  add_arc(run, centre, radii, turn, begin, angle);
  run.segments.back().to = to;
}

class PathReader {
 public:
  PathReader(const std::string& data, const std::string& file, int line)
      : scan_(data, file, line, "d") {}

  std::vector<SvgRun> read() {
    char command = 0;
    while (!scan_.done()) {
      if (!scan_.at_number()) {
        command = scan_.peek();
        if (!std::isalpha(static_cast<unsigned char>(command))) scan_.fail("a command");
        if (runs_.empty() && command != 'M' && command != 'm')
          scan_.fail("M, with which paths begin");
        scan_.take();
      } else if (command == 0 || command == 'Z' || command == 'z') {
        scan_.fail("a command");
      }
      do_one(command);
      if (command == 'M') command = 'L';
      if (command == 'm') command = 'l';
      if (++segments_ > kMostSegments) scan_.fail(fmt::format("at most {} parts", kMostSegments));
    }
    return std::move(runs_);
  }

 private:
  SvgRun& run() {
    // After Z a path goes on from where it was closed.
    if (runs_.back().closed) {
      SvgRun next;
      next.start = runs_.back().start;
      runs_.push_back(next);
    }
    return runs_.back();
  }
  Vec2 here() const { return runs_.back().closed ? runs_.back().start : runs_.back().end(); }

  void do_one(char command) {
    const bool relative = std::islower(static_cast<unsigned char>(command));
    const Vec2 from = runs_.empty() ? Vec2(0, 0) : here();
    const Vec2 base = relative ? from : Vec2(0, 0);
    const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command)));
    Vec2 cubic = from, quadratic = from;  // control points that S and T reflect
    if (was_ == 'C') cubic = 2 * from - control_;
    if (was_ == 'Q') quadratic = 2 * from - control_;
    was_ = 0;
    switch (kind) {
      case 'M': {
        SvgRun next;
        next.start = base + scan_.point();
        runs_.push_back(next);
        break;
      }
      case 'Z':
        runs_.back().closed = true;
        break;
      case 'L':
        run().line_to(base + scan_.point());
        break;
      case 'H':
        run().line_to({base.x() + scan_.number(), from.y()});
        break;
      case 'V':
        run().line_to({from.x(), base.y() + scan_.number()});
        break;
      case 'C':
      case 'S': {
        const Vec2 a = kind == 'C' ? Vec2(base + scan_.point()) : cubic;
        const Vec2 b = base + scan_.point(), to = base + scan_.point();
        run().curve_to(a, b, to);
        was_ = 'C', control_ = b;
        break;
      }
      case 'Q':
      case 'T': {
        const Vec2 c = kind == 'Q' ? Vec2(base + scan_.point()) : quadratic;
        const Vec2 to = base + scan_.point();
        run().curve_to(from + 2.0 / 3.0 * (c - from), to + 2.0 / 3.0 * (c - to), to);
        was_ = 'Q', control_ = c;
        break;
      }
      case 'A': {
        const Vec2 radii = scan_.point();
        const double turn = radians(scan_.number());
        const bool large = scan_.flag(), sweep = scan_.flag();
        const Vec2 to = base + scan_.point();
        arc_to(run(), radii, turn, large, sweep, to);
        break;
      }
      default:
        scan_.fail(fmt::format("a command of M L H V C S Q T A Z, not {}", command));
    }
  }

  Scanner scan_;
  std::vector<SvgRun> runs_;
  char was_ = 0;
  Vec2 control_ = Vec2::Zero();
  std::size_t segments_ = 0;
};

}  // namespace

std::vector<SvgRun> parse_svg_path(const std::string& data, const std::string& file, int line) {
  return PathReader(data, file, line).read();
}

std::vector<double> parse_svg_numbers(const std::string& text, const std::string& file, int line,
                                      const std::string& key) {
  Scanner scan(text, file, line, key);
  std::vector<double> numbers;
  while (!scan.done()) {
    numbers.push_back(scan.number());
    if (numbers.size() > kMostSegments) scan.fail(fmt::format("at most {}", kMostSegments));
  }
  return numbers;
}

SvgAffine parse_svg_transform(const std::string& text, const std::string& file, int line) {
  Scanner scan(text, file, line, "transform");
  SvgAffine all = SvgAffine::Identity();
  while (!scan.done()) {
    const std::string kind = scan.word();
    if (scan.peek() != '(') scan.fail("a transform, \"translate(1, 2)\"");
    scan.take();
    std::vector<double> n;
    while (scan.at_number() && n.size() < 7) n.push_back(scan.number());
    if (scan.peek() != ')') scan.fail("numbers and a closing parenthesis");
    scan.take();
    SvgAffine one = SvgAffine::Identity();
    const std::size_t c = n.size();
    if (kind == "matrix" && c == 6) {
      one.linear() << n[0], n[2], n[1], n[3];
      one.translation() = Vec2(n[4], n[5]);
    } else if (kind == "translate" && (c == 1 || c == 2)) {
      one.translation() = Vec2(n[0], c == 2 ? n[1] : 0);
    } else if (kind == "scale" && (c == 1 || c == 2)) {
      one.linear().diagonal() = Vec2(n[0], c == 2 ? n[1] : n[0]);
    } else if (kind == "rotate" && (c == 1 || c == 3)) {
      const Vec2 about = c == 3 ? Vec2(n[1], n[2]) : Vec2(0, 0);
      one = Eigen::Translation2d(about) * Eigen::Rotation2Dd(radians(n[0])) *
            Eigen::Translation2d(-about);
    } else if (kind == "skewX" && c == 1) {
      one.linear()(0, 1) = std::tan(radians(n[0]));
    } else if (kind == "skewY" && c == 1) {
      one.linear()(1, 0) = std::tan(radians(n[0]));
    } else {
      scan.fail(
          fmt::format("matrix, translate, scale, rotate, skewX or skewY, not {} with {} "
                      "numbers before it",
                      printable(kind, 20), c));
    }
    all = all * one;
    if (!all.matrix().allFinite() || all.matrix().cwiseAbs().maxCoeff() > kLargest)
      scan.fail("a transform of usual size");
  }
  return all;
}

SvgRun svg_ellipse(const Vec2& centre, const Vec2& radii) {
  SvgRun run;
  run.start = centre + Vec2(radii.x(), 0);
  add_arc(run, centre, radii, 0, 0, 2 * std::numbers::pi);
  run.segments.back().to = run.start;
  run.closed = true;
  return run;
}

SvgRun svg_rectangle(const Vec2& corner, const Vec2& size, Vec2 radii) {
  radii = radii.cwiseMin(size / 2);
  SvgRun run;
  run.closed = true;
  const Vec2 far = corner + size;
  if (radii.minCoeff() <= 0) {
    run.start = corner;
    run.line_to({far.x(), corner.y()});
    run.line_to(far);
    run.line_to({corner.x(), far.y()});
    return run;
  }
  run.start = {corner.x() + radii.x(), corner.y()};
  const Vec2 centres[] = {{far.x() - radii.x(), corner.y() + radii.y()},
                          far - radii,
                          {corner.x() + radii.x(), far.y() - radii.y()},
                          corner + radii};
  for (int i = 0; i < 4; ++i) {
    const double from = (i - 1) * std::numbers::pi / 2;
    run.line_to(centres[i] + radii.cwiseProduct(Vec2(std::cos(from), std::sin(from))));
    add_arc(run, centres[i], radii, 0, from, std::numbers::pi / 2);
  }
  return run;
}

SvgRun transformed(SvgRun run, const SvgAffine& by) {
  run.start = by * run.start;
  for (SvgRun::Segment& s : run.segments) s = {by * s.first, by * s.second, by * s.to, s.curve};
  return run;
}

SampledRun sampled(const SvgRun& run, double tolerance) {
  SampledRun result;
  result.closed = run.closed;
  result.points = result.nodes = {run.start};
  Vec2 from = run.start;
  for (const SvgRun::Segment& s : run.segments) {
    if (s.curve) {
      // The second derivative bounds how far a chord of n parts leaves the curve: |B''| / (8 n²).
      const double bend = 6 * std::max((from - 2 * s.first + s.second).norm(),
                                       (s.first - 2 * s.second + s.to).norm());
      const int n = static_cast<int>(
          std::clamp(std::ceil(std::sqrt(bend / (8 * tolerance))), 1.0, double(kMostChords)));
      for (int i = 1; i < n; ++i) {
        const double t = double(i) / n, u = 1 - t;
        result.points.push_back(u * u * u * from + 3 * u * u * t * s.first +
                                3 * u * t * t * s.second + t * t * t * s.to);
      }
    }
    result.points.push_back(s.to);
    result.nodes.push_back(s.to);
    from = s.to;
  }
  if (result.closed && result.points.size() > 1 &&
      (result.points.back() - result.points.front()).norm() <= tolerance)
    result.points.pop_back();
  return result;
}

}  // namespace loosefit::io
