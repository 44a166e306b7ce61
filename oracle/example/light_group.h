/* SPDX-License-Identifier: MIT */
#ifndef LIGHTCUTS_ORACLE_EXAMPLE_LIGHT_GROUP_H
#define LIGHTCUTS_ORACLE_EXAMPLE_LIGHT_GROUP_H

// Lights in a box whose axes lie in a cone, and bounds of where they shine (Conty Estevez and Kulla
// 2018, "Importance Sampling of Many Lights with Adaptive Tree Splitting").

#include "shading.h"

/// More than angles and their cosines round: some 2^-50.
static const double slack = 1e-14;

// ---- directions

static inline double dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void cross(const double a[3], const double b[3], double out[3]) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    out[i] = a[j] * b[k] - a[k] * b[j];
  }
}

static inline double angle_between(const double a[3], const double b[3]) {
  double c[3];
  cross(a, b, c);
  return atan2(sqrt(dot(c, c)), dot(a, b));
}

/// Directions off an axis by an angle at most.
typedef struct cone {
  double axis[3];
  double angle;
} cone;

/// Widens the cone to one that has the other in it, too, but for rounding.
static inline void unite(cone* c, const cone* other) {
  const cone wide = c->angle < other->angle ? *other : *c;
  const cone narrow = c->angle < other->angle ? *c : *other;
  const double between = angle_between(wide.axis, narrow.axis);
  *c = wide;
  if (fmin(between + narrow.angle, pi) <= wide.angle) return;
  double side[3], turned[3];
  cross(wide.axis, narrow.axis, side);
  c->angle = (wide.angle + between + narrow.angle) / 2;
  const double size = sqrt(dot(side, side));
  if (c->angle >= pi || size == 0) {
    c->angle = pi;
    return;
  }
  cross(side, wide.axis, turned); // at right angles to the axis, towards the other one
  const double by = c->angle - wide.angle;
  for (int i = 0; i < 3; ++i) c->axis[i] = cos(by) * wide.axis[i] + sin(by) * turned[i] / size;
}

// ---- groups of lights

enum { mixed = 4 }; ///< in place of a kind

/// What holds of all lights of a group.
typedef struct group {
  uint32_t kind;       ///< or mixed, where no more than box and intensity holds
  box box;             ///< of directional lights: around their directions
  cone axes;           ///< of oriented and spot lights
  double cos_outer;    ///< the smallest
  double rim;          ///< the smallest cos_inner - cos_outer
  double intensity[3]; ///< total
} group;

static inline int has_axis(uint32_t kind) {
  return kind == LIGHTCUTS_LIGHT_ORIENTED || kind == LIGHTCUTS_LIGHT_SPOT;
}

static inline group group_of(const lightcuts_light* light) {
  group g = {.kind = light->kind,
             .axes = {.angle = has_axis(light->kind) ? 0 : pi},
             .cos_outer = light->cos_outer,
             .rim = (double)light->cos_inner - light->cos_outer};
  for (int i = 0; i < 3; ++i) {
    g.box.low[i] = g.box.high[i] = light->position[i];
    g.intensity[i] = light->intensity[i];
    if (has_axis(light->kind)) g.axes.axis[i] = light->axis[i] / length(light->axis);
  }
  return g;
}

static inline void join(group* g, const group* other) {
  if (g->kind != other->kind) g->kind = mixed;
  cover(&g->box, &other->box);
  if (has_axis(g->kind)) unite(&g->axes, &other->axes);
  g->cos_outer = fmin(g->cos_outer, other->cos_outer);
  g->rim = fmin(g->rim, other->rim);
  for (int i = 0; i < 3; ++i) g->intensity[i] += other->intensity[i];
}

/// Joins groups one after another; *count is how many there are already.
static inline void add(group* sum, int* count, const group* other) {
  if ((*count)++ == 0)
    *sum = *other;
  else
    join(sum, other);
}

static inline double power(const group* g) {
  return g->intensity[0] + g->intensity[1] + g->intensity[2];
}

/// Of all directions in which the lights shine, each weighted by the cosine with the nearest axis.
static inline double measure(const group* g) {
  const double o = g->axes.angle;
  const double e = g->kind == LIGHTCUTS_LIGHT_SPOT ? acos(g->cos_outer) : pi / 2;
  const double w = fmin(o + e, pi);
  return 2 * pi * (1 - cos(o)) +
         pi / 2 * (2 * w * sin(o) - cos(o - 2 * w) - 2 * o * sin(o) + cos(o));
}

static inline double extent(const group* g, int axis) {
  return (double)g->box.high[axis] - g->box.low[axis];
}

/// The diagonal's square stands for the surface, which is 0 of lights in a line.
static inline double cost(const group* g) {
  double diagonal2 = 0;
  for (int i = 0; i < 3; ++i) diagonal2 += extent(g, i) * extent(g, i);
  return power(g) * measure(g) * diagonal2;
}

// ---- groups seen from a point

/// A group seen from a point: within a sphere, from whose centre no direction is off by more than
/// `spread`.
typedef struct sight {
  double to[3], distance, radius, spread;
} sight;

static inline sight seen(const group* g, const float x[3]) {
  sight s = {{0}, 0, 0, pi};
  for (int i = 0; i < 3; ++i) {
    s.to[i] = ((double)g->box.low[i] + g->box.high[i]) / 2 - x[i];
    s.radius += extent(g, i) * extent(g, i) / 4;
  }
  s.distance = sqrt(dot(s.to, s.to));
  s.radius = sqrt(s.radius) * (1 + 0x1p-40);
  if (s.radius < s.distance) s.spread = asin(s.radius / s.distance);
  return s;
}

/// The largest cosine between a direction to the group and one of the cone.
static inline double largest_cosine(const sight* s, const double axis[3], double angle) {
  const double off = angle_between(axis, s->to) - s->spread - angle;
  return off <= 0 ? 1 : fmin(cos(off) + slack, 1);
}

static inline double cosine_with(const sight* s, const float direction[3]) {
  const double axis[3] = {direction[0], direction[1], direction[2]};
  return largest_cosine(s, axis, 0);
}

/// The largest share of its intensity that a light of the group sends to the point.
static inline double largest_emission(const group* g, const sight* s) {
  if (!has_axis(g->kind)) return 1;
  const double back[3] = {-g->axes.axis[0], -g->axes.axis[1], -g->axes.axis[2]};
  const double cosine = largest_cosine(s, back, g->axes.angle);
  if (g->kind == LIGHTCUTS_LIGHT_ORIENTED) return fmax(cosine, 0);
  const double t = fmin(fmax((cosine - g->cos_outer) / g->rim, 0), 1);
  return t * t;
}

/// Writes a bound of what the lights, all of one kind, contribute: total intensity x largest
/// reflection x largest emission / nearest distance^2.
static inline void bound_group(const group* g, float min_distance, const lightcuts_point* p,
                               float out[3]) {
  const int is_far = g->kind == LIGHTCUTS_LIGHT_DIRECTIONAL;
  const float* from = is_far ? origin : p->position;
  const double highest = height(&g->box, p->normal, from, 1), d2 = nearest2(&g->box, from);
  out[0] = out[1] = out[2] = 0;
  if (highest <= 0) return; // all of them are below the horizon
  const sight s = seen(g, from);
  const double cosine = fmin(cosine_with(&s, p->normal), highest / sqrt(d2));
  if (cosine <= 0) return;
  const double falloff = is_far ? 1 : 1 / fmax(d2, (double)min_distance * min_distance);
  const double mirrored = cosine_with(&s, p->mirror), emitted = largest_emission(g, &s);
  for (int c = 0; c < 3; ++c)
    out[c] = reflected_bound(p, c, cosine, mirrored, g->intensity[c] * emitted, falloff);
}

/// Power x largest cosine x largest emission / distance^2; 0 only of what does not contribute.
static inline double importance(const group* g, float min_distance, const lightcuts_point* p) {
  const int is_far = g->kind == LIGHTCUTS_LIGHT_DIRECTIONAL;
  const sight s = seen(g, is_far ? origin : p->position);
  const double d = fmax(fmax(s.distance, s.radius), min_distance);
  if (d == 0) return 0; // at the point itself
  const double cosine = fmax(cosine_with(&s, p->normal), 0);
  return power(g) * cosine * largest_emission(g, &s) / (is_far ? 1 : d * d);
}

#endif
