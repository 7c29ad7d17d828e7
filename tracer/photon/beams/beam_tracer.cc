#include "photon/beams/beam_tracer.h"

#include <algorithm>
#include <cmath>

// Three rays of a lattice hold a beam for each signature that all of them have. Where a signature is missing at a
// corner
// - the silhouette of a lens, the critical angle - the triangle is cut in four and the midpoints are traced. Weak light
// is halved less often: until what is left is as little as of full power after all halvings. What remains then is sent
// on as photons from places of the triangle drawn by chance, less what beams hold already. So no light is lost, and
// only the light of these last triangles has noise.
//
// Where one signature ends, another has a kink: as light ceases to be transmitted, all of it is reflected. A beam
// across the kink has not quite its flux. The smaller triangles within and their photons say by how much, and the
// beam's share is corrected.
//
// What happens unseen between three corners that agree - a bead behind a ball - is estimated from rays through some of
// the triangles, and stated.

namespace vitrail {
namespace {

// One in so many triangles of the lattice is looked into, for what its corners do not see.
constexpr std::uint64_t kTrianglesPerLook = 16;

// A beam wider than the scene is too thin to be seen, and dear to paint: its light goes as photons.
constexpr double kWidestInRadii = 1;

double sum(Rgb power) { return power.r + power.g + power.b; }

}  // namespace

BeamTracer::BeamTracer(const PhotonPass& pass, const Chart& chart, const LatticeShape& shape, std::uint64_t most_rays,
                       Stream stream, BeamBlock& block)
    : pass_(pass),
      chart_(chart),
      shape_(shape),
      most_rays_(most_rays),
      stream_(stream),
      block_(block),
      rays_(pass, chart, shape.pieces(), block),
      finest_share_(0.5 / std::pow(static_cast<double>(shape.pieces()), 2)) {}

void BeamTracer::cell(std::uint32_t i, std::uint32_t j) {
  const std::uint32_t pieces = shape_.pieces_per_cell();
  const std::uint32_t a = i * pieces, b = j * pieces, c = a + pieces, d = b + pieces;
  const std::uint32_t corner[4] = {rays_.at(a, b), rays_.at(c, b), rays_.at(c, d), rays_.at(a, d)};

  // Cut the cell along the diagonal of the chart that it may lie on: there the map onto a disc has its creases.
  const bool rising = (i < shape_.cells / 2) == (j < shape_.cells / 2);
  const int k = rising ? 0 : 1;
  whole_triangle({corner[k], corner[k + 1], corner[k + 2]});
  whole_triangle({corner[k], corner[k + 2], corner[(k + 3) % 4]});
}

void BeamTracer::whole_triangle(const Triangle& t) {
  held_.clear();
  first_beam_ = static_cast<std::uint32_t>(block_.beams.size());
  corrections_.clear();
  triangle(t, shape_.halvings);
  apply_corrections();
}

void BeamTracer::triangle(const Triangle& t, int halvings) {
  const std::size_t held_around = held_.size();
  const double torn = hold(t);
  if (torn < 0) {
    enter_in_ledger(t);
  } else if (share_of(t) * torn <= finest_share_ || halvings == 0 || block_.rays >= most_rays_) {
    send_photons(t);
  } else {
    const Triangle middle{rays_.between(t[0], t[1]), rays_.between(t[1], t[2]), rays_.between(t[2], t[0])};
    triangle({t[0], middle[0], middle[2]}, halvings - 1);
    triangle({middle[0], t[1], middle[1]}, halvings - 1);
    triangle({middle[2], middle[1], t[2]}, halvings - 1);
    triangle(middle, halvings - 1);
  }
  held_.resize(held_around);
}

// Put a beam on every signature that all three rays have. Returns the power that is left without a beam and lands near
// enough to be seen, at the corner where it is most, of that of the chart; -1 if nothing at all is left.
double BeamTracer::hold(const Triangle& t) {
  double most = -1;
  for (const std::uint32_t corner : t) {
    const LatticeRay ray = rays_[corner];
    double torn = -1;
    for (std::uint32_t k = 0; k < ray.end_count; ++k) {
      const RayEnd& end = rays_.end(ray, k);
      if (held(end.signature) || put_beam(t, end.signature)) continue;
      torn = std::max(torn, 0.0);
      const bool parts = std::any_of(t.begin(), t.end(), [&](auto c) { return !rays_.end_of(c, end.signature); });
      if (parts && !end.far) torn += largest_channel(power_of(end.corner)) / largest_channel(chart_.power);
    }
    most = std::max(most, torn);
  }
  return most;
}

bool BeamTracer::put_beam(const Triangle& t, PathSignature signature) {
  Beam beam{{}, static_cast<float>(share_of(t))};
  for (int k = 0; k < 3; ++k) {
    const RayEnd* end = rays_.end_of(t[k], signature);
    if (end == nullptr) return false;
    beam.corner[k] = end->corner;
  }
  if (is_wide(beam)) return false;
  held_.push_back({signature, t, static_cast<std::uint32_t>(block_.beams.size())});
  block_.beams.push_back(beam);
  return true;
}

bool BeamTracer::is_wide(const Beam& beam) const {
  const auto place = [&](int k) { return block_.corners[beam.corner[k % 3]].position; };
  for (int k = 0; k < 3; ++k) {
    if (length(place(k) - place(k + 1)) > kWidestInRadii * pass_.radius_m) return true;
  }
  return false;
}

// Each ray stands for a third of a triangle that beams hold.
void BeamTracer::enter_in_ledger(const Triangle& t) {
  const double third = share_of(t) / 3;
  for (const std::uint32_t ray : t) {
    block_.ledger += rays_[ray].ledger.scaled(third);
    correct_beams(ray, third);
  }
  if (triangles_++ % kTrianglesPerLook == 0) look_into(t);
}

// Add up what lands within a triangle and is in none of its beams, and what a beam holds and does not land.
void BeamTracer::look_into(const Triangle& t) {
  const auto [x, y] = place_within(t);
  rays_.follow(x, y);
  Rgb unseen;
  for (const Landing& landing : rays_.landings()) {
    if (!held(landing.signature)) unseen += landing.flux;
  }
  for (const Held& each : held_) {
    const auto is_it = [&](const Landing& landing) { return landing.signature == each.signature; };
    const bool lands = std::any_of(rays_.landings().begin(), rays_.landings().end(), is_it);
    if (!lands) unseen += power_between(each, x, y);
  }
  block_.remainder.unseen += unseen * (share_of(t) * kTrianglesPerLook);
}

// Send photons from the triangle, as many as rays for its share of the chart, and keep those that no beam holds.
void BeamTracer::send_photons(const Triangle& t) {
  const double share = share_of(t);
  const auto count = std::max<std::int64_t>(1, std::llround(share * static_cast<double>(chart_.count)));
  const double each = share / static_cast<double>(count);
  for (std::int64_t k = 0; k < count; ++k) {
    const auto [x, y] = place_within(t);
    rays_.follow(x, y);
    block_.ledger += rays_.ledger().scaled(each);
    for (const Landing& landing : rays_.landings()) {
      if (held(landing.signature)) continue;
      const Rgb flux = landing.flux * each;
      block_.photons.push_back(make_photon(pass_.frame, landing.position, landing.normal, flux));
      block_.remainder.as_photons += flux;
    }
    correct_beams(x, y, each);
  }
}

// Compare what lands of a ray of the lattice with larger beams around it.
void BeamTracer::correct_beams(std::uint32_t ray, double each) {
  const LatticeRay at = rays_[ray];
  for (const Held& beam : held_) {
    if (std::find(beam.between.begin(), beam.between.end(), ray) != beam.between.end()) continue;
    const RayEnd* end = rays_.end_of(ray, beam.signature);
    correct(beam, (end ? power_of(end->corner) : Rgb{}) - power_between(beam, at.x, at.y), each);
  }
}

// Compare the ray that was followed last, from a place of the chart, with the beams around it.
void BeamTracer::correct_beams(double x, double y, double each) {
  for (const Held& beam : held_) {
    Rgb landed;
    for (const Landing& landing : rays_.landings()) {
      if (landing.signature == beam.signature) landed += landing.flux;
    }
    correct(beam, landed - power_between(beam, x, y), each);
  }
}

void BeamTracer::correct(const Held& beam, Rgb missing, double each) {
  corrections_.resize(block_.beams.size() - first_beam_);
  corrections_[beam.beam - first_beam_] += each * sum(missing);
}

void BeamTracer::apply_corrections() {
  for (std::size_t k = 0; k < corrections_.size(); ++k) {
    Beam& beam = block_.beams[first_beam_ + k];
    const double power =
        beam.share / 3 * sum(power_of(beam.corner[0]) + power_of(beam.corner[1]) + power_of(beam.corner[2]));
    if (power > 0) beam.share *= static_cast<float>(std::max(0.0, 1 + corrections_[k] / power));
  }
}

// A place drawn by chance, evenly over the triangle.
std::array<double, 2> BeamTracer::place_within(const Triangle& t) {
  const std::uint32_t index = drawn_++;
  const double across = std::sqrt(uniform(stream_, index, 0)), along = uniform(stream_, index, 1);
  const LatticeRay &p = rays_[t[0]], &q = rays_[t[1]], &r = rays_[t[2]];
  const auto between = [&](double a, double b, double c) { return a + across * ((b - a) + along * (c - b)); };
  return {between(p.x, q.x, r.x), between(p.y, q.y, r.y)};
}

const BeamTracer::Held* BeamTracer::held(PathSignature signature) const {
  const auto found =
      std::find_if(held_.begin(), held_.end(), [&](const Held& each) { return each.signature == signature; });
  return found != held_.end() ? &*found : nullptr;
}

double BeamTracer::share_of(const Triangle& t) const {
  const LatticeRay &p = rays_[t[0]], &q = rays_[t[1]], &r = rays_[t[2]];
  return std::abs((q.x - p.x) * (r.y - p.y) - (r.x - p.x) * (q.y - p.y)) / 2;
}

Rgb BeamTracer::power_of(std::uint32_t corner) const {
  const auto& power = block_.corners[corner].power;
  return {power[0], power[1], power[2]};
}

// What a beam would bring to the chart from a place between its rays: its corners' powers interpolated.
Rgb BeamTracer::power_between(const Held& held, double x, double y) const {
  const Triangle& t = held.between;
  const LatticeRay &p = rays_[t[0]], &q = rays_[t[1]], &r = rays_[t[2]];
  const double twice = (q.x - p.x) * (r.y - p.y) - (r.x - p.x) * (q.y - p.y);
  const double v = ((x - p.x) * (r.y - p.y) - (r.x - p.x) * (y - p.y)) / twice;
  const double w = ((q.x - p.x) * (y - p.y) - (x - p.x) * (q.y - p.y)) / twice;
  const Beam& beam = block_.beams[held.beam];
  return power_of(beam.corner[0]) * (1 - v - w) + power_of(beam.corner[1]) * v + power_of(beam.corner[2]) * w;
}

}  // namespace vitrail
