#pragma once
#include <map>
#include <memory>

#include "loosefit/base/lazy.h"
#include "loosefit/pipeline/case_result.h"

namespace loosefit::report {

/// The dress forms of a case (render/mannequin.h): pictures, model file and page draw the same
/// ones. Each is made when it is first asked for. Any number of threads may ask at once. The case
/// has to outlive this.
class CaseForms {
 public:
  using Form = std::shared_ptr<const geometry::TriangleMesh>;
  explicit CaseForms(const pipeline::CaseResult& result);

  /// In the studied garment; `state` nullptr: in the reference state. Those of later donnings,
  /// which are asked for once, are not kept.
  Form in_studied(const pipeline::CaseState* state = nullptr) const;

 private:
  Form make(const pipeline::CaseState* state) const;

  const pipeline::CaseResult& result_;
  std::map<const pipeline::CaseState*, Lazy<Form>> kept_;
};

}  // namespace loosefit::report
