#pragma once
#include "loosefit/validate/specimen.h"

namespace loosefit::validate {

/// The orthotropic fabric of the in-plane benchmarks: K_u = 300, K_v = 700, G = 60 N/m, ν = 0.25.
fabric::Material orthotropic_fabric();
/// The same stiffnesses as measured force curves, f = K (λ − 1) up to 60 %, of yarns that do not
/// see each other (ν = 0): then the law is the measured one and nothing of ours.
fabric::Material engineering_fabric();

/// Moves the inner vertices of a flat specimen of one piece by up to a quarter of `edge`, so that
/// no triangle is like another; the outline stays. The same every time.
void roughen(Specimen& specimen, double edge);

}  // namespace loosefit::validate
