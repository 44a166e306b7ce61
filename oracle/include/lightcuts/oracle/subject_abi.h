/* SPDX-License-Identifier: MIT */
#ifndef LIGHTCUTS_ORACLE_SUBJECT_ABI_H
#define LIGHTCUTS_ORACLE_SUBJECT_ABI_H

/// A light tree of your own, to be judged by lightcuts-oracle. Plain C99; wants nothing but this
/// header.
///
/// Put functions into a lightcuts_subject, export lightcuts_subject_v1(), and make a shared
/// library of it:
///
///   cc -shared -fPIC -std=c99 -O2 -I oracle/include mytree.c -o libmytree.so -lm
///   lightcuts-oracle check desk --subject ./libmytree.so
///
/// `lightcuts-oracle new-subject mytree` writes one to start from, and oracle/example has more.
///
/// What holds for all functions:
/// - They run in a process of their own, one at a time. Crashing, exiting, hanging (10 s for each
///   question, unless told otherwise) is a violation of subject-answers. They are refused
///   memory beyond 4 GiB, unless told otherwise. Of what they print, the first 64 KiB go to the
///   oracle's stderr. Processes that they start end with theirs, unless they leave its group.
/// - They are called with the floating-point environment that a C program starts with: what they do
///   to rounding, traps or subnormals ends with the call, and so does what -ffast-math does where
///   the library is loaded.
/// - Several trees are built one after another in one process; the one before is destroyed first.
///   The same tree is built in several processes, one for each thread of the oracle; all have to
///   answer the same bits (threads-agree).
/// - Those that return int return 0 where they have answered. Another number says that they
///   cannot: a violation of subject-answers, whose report has the number.
/// - Pointers are never NULL, and valid during the call only.
/// - Colours are three numbers: red, green, blue. Floats are finite unless said otherwise, and
///   taken as exact real numbers.
/// - What is promised is promised in real numbers: of a contribution of 10^-388, which no double
///   holds, a bound of 0 is too small.
/// - A leaf of several lights cannot be refined. In a cut that did not end by its largest size, its
///   estimate is within what the threshold allows a cluster of what those of its lights that are
///   seen contribute; light by light, each asked for by visible(), is the plain way.
/// - Promises of lightcuts itself beyond what makes a light tree right are wastes of yours, not
///   violations: that bounds shrink on refinement, and that nothing changes where a scene is
///   scaled, turned, shifted, or its lights are listed otherwise.

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Of what has to be seen where -fvisibility=hidden hides all else.
#if defined(__GNUC__)
#define LIGHTCUTS_EXPORT __attribute__((visibility("default")))
#else
#define LIGHTCUTS_EXPORT
#endif

/// What lightcuts_subject.abi_version has to be.
#define LIGHTCUTS_SUBJECT_ABI_VERSION 1u

/// How a light spreads its power; theta is the angle between lightcuts_light.axis and the direction
/// in which light leaves, d the distance to the light, clamped from below to min_distance.
enum {
  LIGHTCUTS_LIGHT_OMNI = 0,     ///< intensity / d^2
  LIGHTCUTS_LIGHT_ORIENTED = 1, ///< intensity max(0, cos theta) / d^2
  LIGHTCUTS_LIGHT_SPOT = 2,     ///< intensity t^2 / d^2, t = (cos theta - cos_outer) / (cos_inner -
                                ///< cos_outer) clamped to [0, 1]
  LIGHTCUTS_LIGHT_DIRECTIONAL = 3 ///< intensity, whatever the distance
};

/// A light without extent.
typedef struct lightcuts_light {
  uint32_t kind;      ///< LIGHTCUTS_LIGHT_...
  float position[3];  ///< metres; of a directional light: the unit direction towards it
  float intensity[3]; ///< W/sr, each >= 0; of a directional light: irradiance, W/m^2
  float axis[3];      ///< unit, of oriented and spot lights; the length is to be divided out
  float cos_inner;    ///< of a spot: full intensity within, more than cos_outer
  float cos_outer;    ///< of a spot: nothing beyond
} lightcuts_light;

/// The glossy part of a material. l, v, n and r are unit: directions to the light and the viewer,
/// the normal, and v mirrored at it; h is the direction of l + v, T = tan^2(n,h).
enum {
  LIGHTCUTS_LOBE_NONE = 0,
  /// f = reflectance (width + 2)/(2 pi) cos(r,l)^width where cos(r,l) > 0, else 0; width in
  /// [0, 2^20]. r is lightcuts_point.mirror as it is, rounded.
  LIGHTCUTS_LOBE_PHONG = 1,
  /// f = reflectance exp(-T / width^2) / (4 pi width^2 sqrt(n.l n.v)) where n.v > 0, else 0; width
  /// in [2^-14, 1].
  LIGHTCUTS_LOBE_WARD = 2,
  /// Where n.v > 0, f = F D V, a being width in [2^-14, 1]; else 0:
  ///   D = a^2 (1 + T)^2 / (pi (a^2 + T)^2)
  ///   V = 1 / (2 (n.l sqrt(a^2 + (1 - a^2) (n.v)^2) + n.v sqrt(a^2 + (1 - a^2) (n.l)^2)))
  ///   F = reflectance + (1 - reflectance) (1 - v.h)^5
  LIGHTCUTS_LOBE_COOK_TORRANCE = 3
};

/// f(l) = diffuse/pi + lobe(l), 1/sr per colour.
typedef struct lightcuts_material {
  float diffuse[3];     ///< reflectance, each >= 0
  uint32_t lobe;        ///< LIGHTCUTS_LOBE_...
  float reflectance[3]; ///< of the lobe, each >= 0; of Cook and Torrance's: f0, each <= 1
  float width;          ///< of the lobe: Phong's exponent, or alpha
} lightcuts_material;

/// A point of a surface, seen from one direction. A light contributes to the radiance that leaves
/// it for the viewer
///   f(l) n.l intensity (as above) where n.l > 0, else 0,
/// l being the direction from position to the light.
typedef struct lightcuts_point {
  float position[3];  ///< metres
  float normal[3];    ///< unit within 1e-5; the length is to be divided out, as of all directions
  float to_viewer[3]; ///< unit within 1e-5
  float mirror[3];    ///< unit within 1e-5: 2 (n.v) n - v, rounded; what Phong's lobe is about
  lightcuts_material material;
} lightcuts_point;

/// What select() is to do.
typedef struct lightcuts_cut_config {
  float threshold;     ///< >= 0: a cluster's bound is to be at most this share of the total
  uint32_t max_size;   ///< >= 1: largest number of clusters
  float black_level;   ///< >= 0: a bound up to this radiance is always good enough
  uint32_t unoccluded; ///< not 0: nothing comes between the point and any light
} lightcuts_cut_config;

/// Why refinement ended.
enum {
  LIGHTCUTS_END_CONVERGED = 0,   ///< every bound obeys the threshold
  LIGHTCUTS_END_BLACK_LEVEL = 1, ///< or is at most black_level, and one needed that
  LIGHTCUTS_END_MAX_SIZE = 2     ///< refining another cluster would exceed the largest size
};

/// One cluster of a cut.
typedef struct lightcuts_cluster {
  uint32_t node;
  double estimate[3]; ///< radiance that it is taken to contribute, occlusion included
} lightcuts_cluster;

/// What select() finds: a partition of the lights, each cluster a node of the tree.
typedef struct lightcuts_cut {
  float radiance[3];           ///< out: the sum of the estimates; +inf above the largest float
  float certified_error[3];    ///< out: at least |radiance - exact|, rounding included; or +inf
  uint32_t end;                ///< out: LIGHTCUTS_END_...
  uint32_t size;               ///< out: number of clusters
  uint32_t capacity;           ///< in: room for so many clusters, one for each node of the tree
  lightcuts_cluster* clusters; ///< in: where to write them
} lightcuts_cut;

/// Whether lights are seen from the point: visible(context, i) is 1 or 0 for light i.
typedef struct lightcuts_visibility {
  int (*visible)(void* context, uint32_t light);
  void* context;
} lightcuts_visibility;

/// A light tree. abi_version, size, and the functions build to lights are required. All others may
/// be NULL: the oracle judges what is there and says what it could not judge. `tree` is what
/// build() returned; `node` an index below node_count(), 0 being the root. Functions are only ever
/// added at the end: `size` tells which of them a plug-in knew of, and those after it are not
/// called.
typedef struct lightcuts_subject {
  uint32_t abi_version; ///< LIGHTCUTS_SUBJECT_ABI_VERSION
  uint32_t size;        ///< sizeof(lightcuts_subject)
  const char* name;     ///< for reports; may be NULL

  /// A tree over the lights, of which there is at least one; they are not kept for you.
  /// min_distance >= 0, metres: 0 does not clamp. seed: for any random choice. NULL where it cannot
  /// be built.
  void* (*build)(const lightcuts_light* lights, uint32_t count, float min_distance, uint64_t seed);
  /// Frees a tree that build() returned.
  void (*destroy)(void* tree);
  /// Number of nodes, at most 4 for each light and 64 more.
  uint32_t (*node_count)(void* tree);
  /// Writes the indices of a node's children, capacity of them at most, and returns how many there
  /// are: any number; 0 of a leaf.
  uint32_t (*children)(void* tree, uint32_t node, uint32_t* children, uint32_t capacity);
  /// Writes the indices, as given to build(), of a leaf's lights, capacity of them at most, and
  /// returns how many there are: at least one. Every light is in one leaf.
  uint32_t (*lights)(void* tree, uint32_t node, uint32_t* lights, uint32_t capacity);

  /// The light that stands for the cluster: one of its lights, and that of one of its children.
  int (*representative)(void* tree, uint32_t node, uint32_t* light);
  /// Total of the intensities of the cluster's lights.
  int (*intensity)(void* tree, uint32_t node, double intensity[3]);

  /// At least what the cluster's lights contribute if all are seen; +inf is allowed, and a waste.
  int (*bound)(void* tree, uint32_t node, const lightcuts_point* point, float bound[3]);
  /// At most what the cluster's lights contribute if all are seen. Judged only beside bound().
  int (*lower_bound)(void* tree, uint32_t node, const lightcuts_point* point, float bound[3]);
  /// What the cluster is taken to contribute if its representative is seen; bound is what bound()
  /// gave. Judged only beside bound().
  int (*estimate)(void* tree, uint32_t node, const lightcuts_point* point, const float bound[3],
                  double estimate[3]);
  /// A cut for the point.
  int (*select)(void* tree, const lightcuts_point* point, const lightcuts_cut_config* config,
                const lightcuts_visibility* visibility, lightcuts_cut* cut);

  /// Draws one of the cluster's lights by a random number u in [0, 1), whatever is occluded, each
  /// as often as probability() says. probability: with which it is drawn, > 0; 0 where no light
  /// contributes and none is drawn. Judged only beside probability().
  int (*sample)(void* tree, uint32_t node, const lightcuts_point* point, double u, uint32_t* light,
                double* probability);
  /// The probability with which sample() draws that light of the cluster, which is one of its own;
  /// both may round, by 2^-50 of it together for each level of the tree between. Judged only beside
  /// sample().
  int (*probability)(void* tree, uint32_t node, const lightcuts_point* point, uint32_t light,
                     double* probability);

  /// Whether (1 or 0) a cluster is refined before another, by their bounds relative to the total:
  /// >= 0, +inf included.
  int (*refined_before)(double bound, double other);

  /// A random estimate: each cluster of a cut is lit by one of its lights, drawn by random numbers
  /// of your own that `query` decides; the same query, the same bits. A cluster's estimate is what
  /// that light contributes, 0 if it is not seen, divided by the probability() of the light in that
  /// cluster; or, of a leaf, what its lights contribute together. Promised in real numbers:
  /// - In the mean over queries, radiance is what all lights that are seen contribute
  ///   (stochastic-is-unbiased).
  /// - What is drawn of one cluster says nothing of what is drawn of another, nor one query of the
  ///   next (draws-are-independent).
  /// - Clusters and their order are those of all queries: whether to refine one must not depend on
  ///   what is drawn.
  /// Whether its certified_error holds and its end is true is not judged. Judged only beside
  /// sample() and probability(). A table whose size ends before it has no draw().
  int (*draw)(void* tree, const lightcuts_point* point, const lightcuts_cut_config* config,
              uint64_t query, const lightcuts_visibility* visibility, lightcuts_cut* cut);
} lightcuts_subject;

/// What a plug-in exports. The table has to stay where it is.
LIGHTCUTS_EXPORT const lightcuts_subject* lightcuts_subject_v1(void);

#ifdef __cplusplus
}
#endif

#endif
