#pragma once
#include <string>
#include <vector>

#include "loosefit/body/body_model.h"
#include "loosefit/body/missing_limb.h"

namespace loosefit::body {

/// Limbs of a person of the model that reach farther than a scan on which that person lies, by more
/// than a closed hand, a shoe or an estimate of the joints may explain: 2.5 % of the stature beyond
/// a wrist, 3 % above a sole, 6 % below a crown; or without the toes' three fifths of a foot. Asked
/// is how far along the limb skin of the scan lies that is nearest to that limb of the model; so
/// holes of the skin do not matter, nor hands that are closed, nor what reaches beyond the model
/// (hair, shoes, hats). The scan: metres, z up, floor at z = 0, closed or not. Left before right,
/// arms before legs, the head last.
std::vector<MissingLimb> missing_limbs(const BodyModel& model, const PosedPerson& person,
                                       const geometry::TriangleMesh& scan);

/// Feet that the scan has, without a quarter of the way from the ankle to the toes or more: nobody
/// dresses a person without a forefoot, so it is the model's. Left before right.
std::vector<ShortFoot> short_feet(const BodyModel& model, const PosedPerson& person,
                                  const std::vector<MissingLimb>& missing,
                                  const geometry::TriangleMesh& scan);

/// Limbs of which the scan shows less than three quarters of the model's skin, hands and feet
/// aside: grown together with the trunk, hidden, or laid on skin of something else since they are
/// missing. They end at the shoulder or hip.
std::vector<MissingLimb> doubtful_limbs(const BodyModel& model, const PosedPerson& person,
                                        const geometry::TriangleMesh& scan);

/// Share of the scan's points that lie within a few centimetres of the skin that the person has
/// without these limbs.
double explained_share(const BodyModel& model, const PosedPerson& person,
                       const std::vector<MissingLimb>& missing, const geometry::TriangleMesh& scan);

/// "no left forearm and hand (the scan ends 0.02 m below the elbow) and no ..."
std::string in_words(const std::vector<MissingLimb>& missing);

}  // namespace loosefit::body
