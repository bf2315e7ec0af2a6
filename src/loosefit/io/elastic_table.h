#pragma once
#include <string>

#include "loosefit/io/config_reader.h"
#include "loosefit/pattern/named_edges.h"

namespace loosefit::io {

// What an elastic may be, wherever a file tells of one (PanelEdge::elastic).
inline const NumberRange kElasticRatio{0.3, 1, "a ratio"};
inline const NumberRange kElasticStiffness{0.1, 1000, "newton"};
inline const NumberRange kElasticWidth{0.003, 0.2, "metres"};
inline const NumberRange kElasticDensity{0, 0.5, "kg/m"};

/// An [[elastic]]: `edges`, `ratio`, `stiffness`, `width`, `linear_density`. \throws InvalidInput
/// with file, line and key.
pattern::NamedElastic read_elastic(ConfigReader table);

/// The same as TOML, below its head.
std::string elastic_toml(const pattern::NamedElastic& elastic);

}  // namespace loosefit::io
