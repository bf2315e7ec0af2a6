#pragma once
#include <memory>
#include <vector>

#include "loosefit/drape/cloth_model.h"
#include "loosefit/drape/contact_body.h"
#include "loosefit/garment/assemble.h"
#include "support/shapes.h"
#include "support/simple_patterns.h"

namespace loosefit::testing_support {

/// A flat square of cloth at a height over the top of a ball [m]; below 0 it cuts the ball.
struct SquareOverBall {
  Material material;
  Garment garment;
  std::shared_ptr<const ContactBody> body;
  std::vector<Vec3> x;
  std::unique_ptr<ClothModel> model;

  explicit SquareOverBall(double height) {
    Pattern pattern;
    pattern.panels = {rectangle_panel("cloth", 0.2, 0.2)};
    garment = assemble(pattern, 0.03, material);
    for (const Vec2& uv : garment.vertex_uv) x.emplace_back(uv[0] - 0.1, uv[1] - 0.1, 0.1 + height);
    Body ball;
    ball.surface = support::sphere(0.1, 24, 48);
    ball.segment.assign(ball.surface.vertices.size(), Segment::thigh);
    ball.side.assign(ball.surface.vertices.size(), -1);
    body = with_field(std::move(ball), bounds(x), 0.005);
    model = std::make_unique<ClothModel>(garment, material, DrapeOptions{}, material.thickness);
    model->body().set_field(body->field);
  }
};

}  // namespace loosefit::testing_support
