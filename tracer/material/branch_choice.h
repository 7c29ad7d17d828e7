#pragma once
/// Which ways a path takes where light divides: all that matter, and by chance one of those that do not (Russian
/// roulette).

#include <array>

namespace vitrail {

/// What each of two ways on carries, as a share of the look or photon; 0 for a way that does not exist.
using CarriedShares = std::array<double, 2>;

/// What each way counts for: 1 where it is followed in any case, more where it stands for what chance left out, 0 where
/// it is left out. The mean over chance is 1: nothing is lost and nothing added.
using BranchFactors = std::array<double, 2>;

/// The least share of a look that is followed in any case. It grows with the rays that the look has taken, so that a
/// pile of panes, whose branches double at each face, ends within some hundred rays.
double least_share(double branch_share, double rays);

/// Whether some way is below the least share.
bool leaves_to_chance(const CarriedShares& carried, double least);

/// Follow ways that carry `least` or more. Of the others take at most one, chosen by what they carry; it goes on with
/// `least`, or with all that they carry if that is more. In clear glass the two ways of a path that carries just
/// `least` have it together, so it never ends and brings no noise under an even sky. `chance` is in (0, 1).
BranchFactors choose_branches(const CarriedShares& carried, double least, double chance);

/// The same for looks: what both ways carry together stays, whatever chance says, so that an even sky has no noise
/// behind clear glass. A weak way that is taken gets `least`, and the strong one the rest. Where both together carry
/// less than three times `least` one of them gets all; a path that carries next to nothing may end.
BranchFactors share_out(const CarriedShares& carried, double least, double chance);

}  // namespace vitrail
