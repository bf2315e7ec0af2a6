#include <fmt/format.h>

#include <algorithm>

#include "loosefit/report/html.h"
#include "loosefit/report/sections.h"

namespace loosefit::report {
namespace {

std::string place(const Vec2& at) { return fmt::format("{:.3f}, {:.3f}", at.x(), at.y()); }

std::string worst_table(const std::vector<drape::UnbalancedVertex>& worst) {
  std::vector<std::string> head = {"vertex", "panel", "u, v [m]", "near", "net [N]"};
  for (const char* kind : drape::kForceNames) head.push_back(std::string(kind) + " [N]");
  Table table(head);
  for (const drape::UnbalancedVertex& v : worst) {
    std::vector<std::string> row = {std::to_string(v.vertex), v.panel, place(v.at), v.near,
                                    number(v.net, 2)};
    for (double force : v.force) row.push_back(number(force, 2));
    table.add(row);
  }
  return table.html();
}

std::string cut_table(const std::vector<drape::CutTriangle>& cuts) {
  Table table({"triangle", "panel", "u, v [m]", "cuts"});
  for (const drape::CutTriangle& c : cuts)
    table.add({std::to_string(c.triangle), c.panel, place(c.at),
               (c.body ? "the body: " : "the cloth: ") + c.with});
  return table.html();
}

}  // namespace

std::string unsettled_section(const pipeline::CaseResult& result) {
  const std::optional<drape::Unsettled>& unsettled = result.studied().drape.unsettled;
  if (!unsettled) return {};
  const drape::Unsettled& u = *unsettled;
  std::string html = element("h2", "Why it did not settle");
  html += element("p", escaped("In short: " + u.why + "."));
  html += element("p", escaped("What may help: " + u.hint + "."));
  if (!u.worst.empty())
    html += element("h3", "Where the forces do not balance") +
            element("p",
                    "The vertices with the largest net force. The columns at the right are the "
                    "magnitudes of the single forces; at rest their vectors add up to zero.") +
            worst_table(u.worst);
  if (!u.cuts.empty()) html += element("h3", "What cuts") + cut_table(u.cuts);
  return html;
}

}  // namespace loosefit::report
