#include "loosefit/io/elastic_table.h"

#include <fmt/format.h>

#include "loosefit/base/text.h"

namespace loosefit::io {

pattern::NamedElastic read_elastic(ConfigReader table) {
  pattern::NamedElastic named;
  pattern::EdgeElastic& elastic = named.elastic;
  table.only({"edges", "ratio", "stiffness", "width", "linear_density"});
  named.edges =
      table.texts("edges", ".+\\..+", "edges of panels that it is sewn to, PANEL.EDGE", 1);
  table.require("edges", "edges of panels, [\"front.hem\", \"back.hem\"]");
  table.require("ratio", "its own length over that of the edge, as 0.8");
  elastic.ratio = table.number("ratio", elastic.ratio, kElasticRatio,
                               "its own length over that of the edge as cut");
  elastic.stiffness = table.number("stiffness", elastic.stiffness, kElasticStiffness,
                                   "force per elongation of one of its own length");
  elastic.width = table.number("width", elastic.width, kElasticWidth, "of the tape");
  elastic.linear_density = table.number("linear_density", elastic.linear_density, kElasticDensity,
                                        "mass per metre of the tape, not stretched");
  table.finish();
  return named;
}

std::string elastic_toml(const pattern::NamedElastic& named) {
  std::vector<std::string> edges;
  for (const std::string& edge : named.edges) edges.push_back(toml_quoted(edge));
  return fmt::format("edges = [{}]\nratio = {}\nstiffness = {}\nwidth = {}\nlinear_density = {}\n",
                     join(edges), shortest(named.elastic.ratio), shortest(named.elastic.stiffness),
                     shortest(named.elastic.width), shortest(named.elastic.linear_density));
}

}  // namespace loosefit::io
