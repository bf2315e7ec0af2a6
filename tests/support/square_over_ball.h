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
  fabric::Material material;
  garment::Garment garment;
  std::shared_ptr<const drape::ContactBody> body;
  std::vector<Vec3> x;
  std::unique_ptr<drape::ClothModel> model;

  explicit SquareOverBall(double height) {
    pattern::Pattern pattern;
    pattern.panels = {rectangle_panel("cloth", 0.2, 0.2)};
    garment = garment::assemble(pattern, 0.03, material);
    for (const Vec2& uv : garment.vertex_uv) x.emplace_back(uv[0] - 0.1, uv[1] - 0.1, 0.1 + height);
    body::Body ball;
    ball.surface = support::sphere(0.1, 24, 48);
    ball.segment.assign(ball.surface.vertices.size(), body::Segment::thigh);
    ball.side.assign(ball.surface.vertices.size(), -1);
    body = drape::with_field(std::move(ball), drape::bounds(x), 0.005);
    model = std::make_unique<drape::ClothModel>(garment, material, drape::DrapeOptions{},
                                                material.thickness);
    model->body().set_field(body->field);
  }
};

}  // namespace loosefit::testing_support
