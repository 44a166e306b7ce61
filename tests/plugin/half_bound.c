/* SPDX-License-Identifier: MIT */
// The example, but for bounds of half the size.
#define lightcuts_subject_v1 right_subject
#include "brute_tree.c"
#undef lightcuts_subject_v1

static int half_bound(void* of, uint32_t index, const lightcuts_point* p, float out[3]) {
  bound(of, index, p, out);
  for (int c = 0; c < 3; ++c) out[c] *= 0.5F;
  return 0;
}

const lightcuts_subject* lightcuts_subject_v1(void) {
  static lightcuts_subject subject;
  subject = *right_subject();
  subject.name = "half bound";
  subject.bound = half_bound;
  return &subject;
}
