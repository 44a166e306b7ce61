/* SPDX-License-Identifier: MIT */
#ifndef LIGHTCUTS_ORACLE_EXAMPLE_SHADING_H
#define LIGHTCUTS_ORACLE_EXAMPLE_SHADING_H

// How light is reflected, after lightcuts/oracle/subject_abi.h, in double: what the examples have
// in common. Relative errors are well below 2^-30, and nothing is 0 that is not.

#include <float.h>
#include <math.h>

#include <lightcuts/oracle/subject_abi.h>

static const double pi = 3.14159265358979323846;

// ---- arithmetic

/// The smallest float that is not below v >= 0: a bound may not become smaller by rounding.
static inline float round_up(double v) {
  if (v > FLT_MAX) return INFINITY;
  const float f = (float)v;
  return f < v ? nextafterf(f, INFINITY) : f;
}

static inline float to_float(double v) { return v > FLT_MAX ? INFINITY : (float)v; }

/// A sum without error: doubles that do not overlap (Shewchuk 1997, "Adaptive Precision
/// Floating-Point Arithmetic").
typedef struct exact {
  double part[24];
  int size;
} exact;

static inline void add_term(exact* sum, double term) {
  for (int k = 0; k < sum->size; ++k) { // term + part without an error
    const double total = term + sum->part[k], seen = total - term;
    sum->part[k] = (term - (total - seen)) + (sum->part[k] - seen);
    term = total;
  }
  sum->part[sum->size++] = term;
}

static inline void add_product(exact* sum, double a, double b) {
  add_term(sum, fma(a, b, -(a * b)));
  add_term(sum, a * b);
}

static inline double rounded(const exact* sum) {
  double total = 0;
  for (int k = 0; k < sum->size; ++k) total += sum->part[k];
  return total;
}

/// n.(y - x), relative error 2^-50, zero and sign exact: whether a light is above the horizon is
/// decided by nothing else. Products of two floats are exact in double.
static inline double dot_between(const float n[3], const float x[3], const float y[3]) {
  exact sum = {.size = 0};
  for (int i = 0; i < 3; ++i) {
    add_term(&sum, (double)n[i] * y[i]);
    add_term(&sum, -(double)n[i] * x[i]);
  }
  return rounded(&sum);
}

/// det(n, y - x, v), likewise.
static inline double determinant(const float n[3], const float x[3], const float y[3],
                                 const float v[3]) {
  exact sum = {.size = 0};
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double part[2] = {(double)v[j] * n[k], -(double)v[k] * n[j]};
    for (int m = 0; m < 2; ++m) {
      add_product(&sum, part[m], y[i]);
      add_product(&sum, part[m], -x[i]);
    }
  }
  return rounded(&sum);
}

static const float origin[3] = {0, 0, 0};

static inline double length(const float v[3]) {
  return sqrt((double)v[0] * v[0] + (double)v[1] * v[1] + (double)v[2] * v[2]);
}

// ---- one light

/// n.v, with the sign exact.
static inline double viewer_cosine(const lightcuts_point* p) {
  return dot_between(p->normal, origin, p->to_viewer) / (length(p->normal) * length(p->to_viewer));
}

/// |l + v|, l = q/d.
static inline double sum_length(const lightcuts_point* p, const double q[3], double d) {
  double square = 0;
  for (int i = 0; i < 3; ++i) {
    const double part = q[i] / d + p->to_viewer[i] / length(p->to_viewer);
    square += part * part;
  }
  return sqrt(square);
}

/// tan^2 of the angle between the normal and l + v: what of l + v is along the surface, over what
/// is along the normal. l = q/d; a is n.l, b is n.v. Where l and v are all but opposite their sum
/// cancels; with s the sines that belong to a and b, and phi the angle between l and v as seen
/// along the normal, the part along the surface is, squared,
///   (s_l - s_v)^2 + 2 s_l s_v (1 + cos phi) ,
///   s_l - s_v = (b - a) (a + b) / (s_l + s_v) ,
///   1 + cos phi = sin^2 phi / (1 - cos phi) ,  s_l s_v sin phi = det(n, l, v) .
static inline double half_tangent2(const lightcuts_point* p, const float from[3], const float to[3],
                                   const double q[3], double d, double a, double b) {
  const double together = sum_length(p, q, d);
  if (together < 0.25) {
    const double sl = sqrt(1 - a * a), sv = sqrt(1 - b * b);
    const double inwards = (b - a) / (sl + sv);
    const double aside = determinant(p->normal, from, to, p->to_viewer) /
                         (length(p->normal) * length(p->to_viewer) * d) / (a + b);
    const double between = 0.5 * together * together - 1; // l.v
    return inwards * inwards + 2 * aside * aside / (sl * sv - between + a * b);
  }
  double sum[3], along = 0, square = 0;
  for (int i = 0; i < 3; ++i) {
    sum[i] = q[i] / d + p->to_viewer[i] / length(p->to_viewer);
    along += sum[i] * p->normal[i] / length(p->normal);
  }
  for (int i = 0; i < 3; ++i) {
    const double part = sum[i] - along * p->normal[i] / length(p->normal);
    square += part * part;
  }
  return square / ((a + b) * (a + b));
}

/// (1 - v.h)^5, with 1 - cos = sin^2 / (1 + cos) where that would cancel; 2 v.h = |l + v|.
static inline double schlick(const lightcuts_point* p, const float from[3], const float to[3],
                             const double q[3], double d) {
  const float* v = p->to_viewer;
  const float x[3] = {0, -v[2], v[1]}, y[3] = {v[2], 0, -v[0]}, z[3] = {-v[1], v[0], 0};
  const double a = dot_between(x, from, to), b = dot_between(y, from, to),
               c = dot_between(z, from, to);
  const double scale = length(v) * d;
  const double cosine = fmin(fmax(dot_between(v, from, to) / scale, -1), 1);
  const double half = 0.5 * sum_length(p, q, d);
  const double sine2 = (a * a + b * b + c * c) / (scale * scale);
  return pow(cosine > 0 ? sine2 / (2 * (1 + cosine) * (1 + half)) : 1 - half, 5);
}

static inline double masked(double a2, double cosine) {
  return sqrt(a2 + (1 - a2) * cosine * cosine);
}

/// What the glossy part reflects, f of one colour; cosine is n.l > 0.
static inline double lobe(const lightcuts_point* p, int colour, const float from[3],
                          const float to[3], const double q[3], double d, double cosine) {
  const lightcuts_material* m = &p->material;
  const double a2 = (double)m->width * m->width;
  if (m->lobe == LIGHTCUTS_LOBE_NONE) return 0;
  if (m->lobe == LIGHTCUTS_LOBE_PHONG) {
    const double r = dot_between(p->mirror, from, to) / (length(p->mirror) * d);
    return r <= 0 ? 0 : m->reflectance[colour] * (m->width + 2.0) / (2 * pi) * pow(r, m->width);
  }
  const double viewer = viewer_cosine(p);
  if (viewer <= 0) return 0;
  const double t = half_tangent2(p, from, to, q, d, cosine, viewer);
  if (m->lobe == LIGHTCUTS_LOBE_WARD)
    return m->reflectance[colour] * exp(-t / a2) / (4 * pi * a2 * sqrt(cosine) * sqrt(viewer));
  const double ratio = (1 + t) / (a2 + t), f0 = m->reflectance[colour];
  return (f0 + (1 - f0) * schlick(p, from, to, q, d)) * (a2 / pi * ratio * ratio) * 0.5 /
         (cosine * masked(a2, viewer) + viewer * masked(a2, cosine));
}

/// c - cos_outer, c being the cosine between the light's axis and the way to x at a distance d.
/// Where that cancels, by 1 - c = |a x q|^2 / (|a|^2 d^2 (1 + c)) or, seen from behind, by 1 + c
/// likewise: all the better the narrower the cone is.
static inline double beyond_rim(const lightcuts_light* light, const float x[3], double d) {
  const float *a = light->axis, *y = light->position;
  const double scale = length(a) * d, c = dot_between(a, y, x) / scale;
  const double outer = light->cos_outer, rim = c - outer;
  if (fabs(rim) > 0x1p-10 || fabs(c) < 0.5) return rim;
  const float u[3] = {0, -a[2], a[1]}, v[3] = {a[2], 0, -a[0]}, w[3] = {-a[1], a[0], 0};
  const double i = dot_between(u, y, x), j = dot_between(v, y, x), k = dot_between(w, y, x);
  const double sine2 = (i * i + j * j + k * k) / (scale * scale);
  return c > 0 ? 1 - outer - sine2 / (1 + c) : sine2 / (1 - c) - (1 + outer);
}

/// The share of its intensity that the light sends to the point at a distance d.
static inline double emission(const lightcuts_light* light, const float x[3], double d) {
  if (light->kind == LIGHTCUTS_LIGHT_OMNI || light->kind == LIGHTCUTS_LIGHT_DIRECTIONAL) return 1;
  const double cosine = dot_between(light->axis, light->position, x) / (length(light->axis) * d);
  if (light->kind == LIGHTCUTS_LIGHT_ORIENTED) return fmax(cosine, 0);
  const double rim = beyond_rim(light, x, d);
  if (rim <= 0x1p-45 * fabs(light->cos_outer)) return 0; // nothing but rounding
  const double t = fmin(rim / ((double)light->cos_inner - light->cos_outer), 1);
  return t * t;
}

/// Radiance that a light of intensity 1 in the place of this one sends to the viewer.
static inline void transfer(const lightcuts_point* p, const lightcuts_light* light,
                            float min_distance, double out[3]) {
  const int is_far = light->kind == LIGHTCUTS_LIGHT_DIRECTIONAL;
  const float* from = is_far ? origin : p->position;
  const double n_dot_q = dot_between(p->normal, from, light->position);
  out[0] = out[1] = out[2] = 0;
  if (n_dot_q <= 0) return;
  double q[3], d2 = 0;
  for (int i = 0; i < 3; ++i) {
    q[i] = (double)light->position[i] - from[i];
    d2 += q[i] * q[i];
  }
  const double d = sqrt(d2), cosine = n_dot_q / (length(p->normal) * d);
  const double falloff = is_far ? 1 : 1 / fmax(d2, (double)min_distance * min_distance);
  const double arriving = cosine * falloff * emission(light, p->position, d);
  if (arriving == 0) return;
  for (int c = 0; c < 3; ++c)
    out[c] =
        (p->material.diffuse[c] / pi + lobe(p, c, from, light->position, q, d, cosine)) * arriving;
}

// ---- bounds of many lights

/// Along the axes, around points or directions.
typedef struct box {
  float low[3], high[3];
} box;

static inline void cover(box* b, const box* other) {
  for (int i = 0; i < 3; ++i) {
    b->low[i] = fminf(b->low[i], other->low[i]);
    b->high[i] = fmaxf(b->high[i], other->high[i]);
  }
}

/// The largest (or smallest) n.(y - x)/|n| of all y in the box, zero and sign exact.
static inline double height(const box* b, const float n[3], const float x[3], int largest) {
  float corner[3];
  for (int i = 0; i < 3; ++i) corner[i] = (n[i] > 0) == largest ? b->high[i] : b->low[i];
  return dot_between(n, x, corner) / length(n);
}

static inline double nearest2(const box* b, const float x[3]) {
  double d2 = 0;
  for (int i = 0; i < 3; ++i) {
    const double below = (double)b->low[i] - x[i], above = (double)x[i] - b->high[i];
    const double d = fmax(fmax(below, above), 0);
    d2 += d * d;
  }
  return d2;
}

/// The most that the glossy part reflects, f n.l of one colour, n.l being at most `cosine` and the
/// cosine with the mirror direction at most `mirrored`.
static inline double lobe_bound(const lightcuts_point* p, int colour, double cosine,
                                double mirrored) {
  const lightcuts_material* m = &p->material;
  const double a2 = (double)m->width * m->width, reflectance = m->reflectance[colour];
  if (m->lobe == LIGHTCUTS_LOBE_NONE) return 0;
  if (m->lobe == LIGHTCUTS_LOBE_PHONG) {
    const double power = fmax(pow(fmax(mirrored, 0), m->width), 0x1p-400); // that may be too small
    return mirrored <= 0 ? 0 : reflectance * (m->width + 2.0) / (2 * pi) * power * cosine;
  }
  const double viewer = viewer_cosine(p);
  if (viewer <= 0) return 0;
  if (m->lobe == LIGHTCUTS_LOBE_WARD)
    return reflectance * sqrt(cosine) / (4 * pi * a2 * sqrt(viewer));
  // D is largest at T = 0, n.l V where n.l is, and F is at most 1.
  return 1 / (pi * a2) * 0.5 * cosine / (cosine * masked(a2, viewer) + viewer * masked(a2, cosine));
}

/// The bound of lights of that total intensity which reach the point by `falloff` at most; the
/// roundings of a few multiplications are well within the factor 1 + 2^-40. Above 0 unless a factor
/// is 0, however small they are.
static inline float reflected_bound(const lightcuts_point* p, int colour, double cosine,
                                    double mirrored, double intensity, double falloff) {
  const double lobe_part = lobe_bound(p, colour, cosine, mirrored);
  const double reflected = p->material.diffuse[colour] / pi * cosine + lobe_part;
  if (reflected == 0 || intensity == 0 || falloff == 0) return 0; // 0 times infinity is 0 here
  return round_up(fmax(reflected * intensity * falloff * (1 + 0x1p-40), DBL_MIN));
}

/// Of a cut whose bounds sum to that: what they are, and the rounding of all estimates and sums,
/// for which 2^-23 is plenty.
static inline float certified_error(double bounds, double total) {
  if (total > FLT_MAX) return INFINITY;
  return round_up((bounds + total * 0x1p-23 + 0x1p-149) * (1 + 0x1p-30));
}

#endif
