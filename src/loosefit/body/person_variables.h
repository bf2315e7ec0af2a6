#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "loosefit/body/body_data.h"
#include "loosefit/body/posed_person.h"

namespace loosefit::body {

/// What a registration changes of a person, as one vector of numbers about a start: knobs of the
/// shape within their ranges, rotation vectors [rad] of the bones after what the start turns them,
/// and a rotation vector and shift [m] of the whole.
class PersonVariables {
 public:
  PersonVariables(const BodyData& data, PosedPerson start);

  int size() const { return int(variables_.size()); }
  /// How far a variable usually is from the start: the unit of its prior.
  double spread(int variable) const { return variables_[std::size_t(variable)].spread; }
  /// Whether it changes the shape, not only the pose.
  bool is_shape(int variable) const {
    return variables_[std::size_t(variable)].kind == Kind::shape;
  }
  /// Step of its finite differences.
  double difference(int variable) const { return variables_[std::size_t(variable)].difference; }
  /// The nearest values in range.
  Eigen::VectorXd clamped(Eigen::VectorXd x) const;
  PosedPerson at(const Eigen::VectorXd& x) const;

 private:
  enum class Kind { shape, bone, turn, shift };
  struct Variable {
    Kind kind;
    std::string name;  ///< of the knob or bone
    int axis = 0;
    double start = 0, low = -1, high = 1, spread = 1, difference = 0.01;
  };
  PosedPerson start_;
  std::vector<Variable> variables_;
};

}  // namespace loosefit::body
