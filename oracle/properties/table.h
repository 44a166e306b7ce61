// SPDX-License-Identifier: MIT
#pragma once

/// The properties, in the order of reports: what is nearer to a cause of faults comes first. Each
/// is described in a file of its name.
#define LIGHTCUTS_PROPERTIES(X)                                                                    \
  X(tree_partitions_lights)                                                                        \
  X(tree_conserves_intensity)                                                                      \
  X(representative_belongs)                                                                        \
  X(tree_equals_naive)                                                                             \
  X(bound_dominates_contribution)                                                                  \
  X(bound_dominates_error)                                                                         \
  X(bounds_are_ordered)                                                                            \
  X(block_bound_dominates)                                                                         \
  X(bound_shrinks_on_refinement)                                                                   \
  X(bound_is_finite)                                                                               \
  X(estimates_match_clusters)                                                                      \
  X(cut_partitions_lights)                                                                         \
  X(total_does_not_drift)                                                                          \
  X(cut_obeys_threshold)                                                                           \
  X(certified_error_holds)                                                                         \
  X(zero_threshold_is_exact)                                                                       \
  X(tighter_threshold_refines)                                                                     \
  X(visibility_only_darkens)                                                                       \
  X(refinement_order_is_strict)                                                                    \
  X(results_are_finite)                                                                            \
  X(threads_agree)                                                                                 \
  X(history_is_immaterial)                                                                         \
  X(probabilities_sum_to_one)                                                                      \
  X(contributing_lights_are_drawn)                                                                 \
  X(draws_state_their_probability)                                                                 \
  X(draws_are_repeatable)                                                                          \
  X(draws_follow_probabilities)                                                                    \
  X(draws_are_independent)                                                                         \
  X(stochastic_is_unbiased)                                                                        \
  X(intensity_scales_exactly)                                                                      \
  X(length_scales_exactly)                                                                         \
  X(rotation_is_immaterial)                                                                        \
  X(translation_is_immaterial)                                                                     \
  X(light_order_is_immaterial)                                                                     \
  X(split_light_is_immaterial)                                                                     \
  X(black_light_is_immaterial)                                                                     \
  X(brdf_is_reciprocal)                                                                            \
  X(brdf_conserves_energy)                                                                         \
  X(occlusion_equals_brute_force)                                                                  \
  X(proven_visibility_holds)                                                                       \
  X(pixels_equal_points)                                                                           \
  X(subject_answers)
