/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What can happen next, and what must hold. Expressions only. */

/* Two rows are the same V. The code hashes keys and contents. */
#ifdef MUTANT_HASH_OF_KEYS
#define EQUAL_BUNDLES(i, k) 1
#else
#define EQUAL_BUNDLES(i, k) \
  (bundle[AT(i, 0)] == bundle[AT(k, 0)] && bundle[AT(i, 1)] == bundle[AT(k, 1)] && \
   bundle[AT(i, 2)] == bundle[AT(k, 2)])
#endif
#define SAME_VIEW(i, k) \
  (key[AT(i, 0)] == key[AT(k, 0)] && key[AT(i, 1)] == key[AT(k, 1)] && \
   key[AT(i, 2)] == key[AT(k, 2)] && EQUAL_BUNDLES(i, k))

/* Guards. */
#define SPEAKS(k) ((k) == LATE || up[k])
#define NEWS(k, i, x) (up[i] && SPEAKS(k) && key[AT(k, x)] > key[AT(i, x)])
#define STATUS_IS_NEWS(k, i) (up[i] && S[i] && SPEAKS(k) && SAME_VIEW(i, k) && (S[k] & ~S[i]))
/* The life of x that i knows of, if any, has ended: its lease will run out, or just did. */
#define MISSED(i, x) \
  (!DEAD(key[AT(i, x)]) && \
   (!up[x] || (key[AT(i, x)] && INC(key[AT(i, x)]) < INC(key[AT(x, x)]))))
#define ALIVE_AND_WELL(i, x) (!DEAD(key[AT(i, x)]) && up[x] && !MISSED(i, x))

/* Proof: S covers all members of V that are not dead. */
#define LIVING(i) \
  ((1 - DEAD(key[AT(i, 0)])) + 2 * (1 - DEAD(key[AT(i, 1)])) + 4 * (1 - DEAD(key[AT(i, 2)])))
#define PROOF(i) (up[i] && S[i] && (S[i] & LIVING(i)) == LIVING(i))

/* No membership event that this view does not know of. */
#define UP_TO_DATE(i) \
  (LIFE(key[AT(i, 0)]) == newest[0] && LIFE(key[AT(i, 1)]) == newest[1] && \
   LIFE(key[AT(i, 2)]) == newest[2])

/* S1: the allocation of a proven V is the sequential greedy one of its living. */
#define GREEDY1(i, x) (DEAD(key[AT(i, x)]) || bundle[AT(i, x)] == plan[LIVING(i) * N + (x)])
#define GREEDY(i) (GREEDY1(i, 0) && GREEDY1(i, 1) && GREEDY1(i, 2))

/* S1: what the living members of a proven V themselves hold does not overlap, and nothing is left
 * while one of them has room (every agent can fly every task). */
#define IN(b, f) ((f) && (FIRST(b) == (f) || SECOND(b) == (f)))
#define OWN(m) bundle[AT(m, m)]
#define MEMBER(i, m) (up[m] && !DEAD(key[AT(i, m)]))
#define SHARED(i, a, b) \
  (MEMBER(i, a) && MEMBER(i, b) && (IN(OWN(a), FIRST(OWN(b))) || IN(OWN(a), SECOND(OWN(b)))))
#define OWNED_TWICE(i) (SHARED(i, 0, 1) || SHARED(i, 0, 2) || SHARED(i, 1, 2))
#define HELD(i, x, j) (!DEAD(key[AT(i, x)]) && IN(bundle[AT(i, x)], (j) + 1))
#define FREE(i, j) (!HELD(i, 0, j) && !HELD(i, 1, j) && !HELD(i, 2, j))
#define ROOM(i, x) (!DEAD(key[AT(i, x)]) && !SECOND(bundle[AT(i, x)]))
#define LEFT_OUT(i) \
  ((FREE(i, 0) || FREE(i, 1) || FREE(i, 2)) && (ROOM(i, 0) || ROOM(i, 1) || ROOM(i, 2)))

/* S2: no living member of a proven V has said anything beyond it. */
#define KEEPS1(i, m) \
  (!MEMBER(i, m) || (key[AT(m, m)] == key[AT(i, m)] && bundle[AT(m, m)] == bundle[AT(i, m)]))
#define FINAL(i) (KEEPS1(i, 0) && KEEPS1(i, 1) && KEEPS1(i, 2))

/* Nothing left to do but faults. What hangs in the net may be lost. */
#define NOTHING_NEW(k, i) \
  (!up[k] || (!NEWS(k, i, 0) && !NEWS(k, i, 1) && !NEWS(k, i, 2) && !STATUS_IS_NEWS(k, i)))
#define CALM1(i) \
  (!up[i] || (!undecided[i] && NOTHING_NEW((i + 1) % N, i) && NOTHING_NEW((i + 2) % N, i) && \
              (up[(i + 1) % N] || DEAD(key[AT(i, (i + 1) % N)])) && \
              (up[(i + 2) % N] || DEAD(key[AT(i, (i + 2) % N)]))))
#define QUIET (CALM1(0) && CALM1(1) && CALM1(2))
#define RUNNING (up[0] + 2 * up[1] + 4 * up[2])
#define AGREES(i) (!up[i] || (PROOF(i) && LIVING(i) == RUNNING))

#define MEANS_THE_SAME(i, k, x) \
  (key[AT(i, x)] != key[AT(k, x)] || bundle[AT(i, x)] == bundle[AT(k, x)])
#define SAME_MEANING(i, k) \
  (MEANS_THE_SAME(i, k, 0) && MEANS_THE_SAME(i, k, 1) && MEANS_THE_SAME(i, k, 2))

/* Named, so that the checker's message says which one was broken. */
hidden byte S1_no_task_is_owned_twice, S1_no_task_is_left_out, S1_allocation_is_greedy;
hidden byte S2_proof_stands, S3_equal_keys_mean_the_same, L1_rest_is_agreement,
  W_no_agreement_after_return;

inline check1(i) {
  if
  :: PROOF(i) ->
     S1_no_task_is_owned_twice = !(UP_TO_DATE(i) && OWNED_TWICE(i));
     assert(S1_no_task_is_owned_twice);
     S2_proof_stands = !UP_TO_DATE(i) || FINAL(i);
     assert(S2_proof_stands);
     S1_no_task_is_left_out = !LEFT_OUT(i);
     assert(S1_no_task_is_left_out);
     S1_allocation_is_greedy = GREEDY(i);
     assert(S1_allocation_is_greedy)
  :: else
  fi
}

inline check() {
  check1(0);
  check1(1);
  check1(2);
#ifndef MUTANT_SAME_INCARNATION
  S3_equal_keys_mean_the_same = SAME_MEANING(0, 1) && SAME_MEANING(0, 2) && SAME_MEANING(1, 2);
  assert(S3_equal_keys_mean_the_same);
#endif
  L1_rest_is_agreement = !QUIET || (AGREES(0) && AGREES(1) && AGREES(2));
  assert(L1_rest_is_agreement);
#ifdef WITNESS /* must be found: otherwise the properties would say little */
  W_no_agreement_after_return = !(QUIET && crashes == 0 && returns == 0 && RUNNING == 7);
  assert(W_no_agreement_after_return)
#endif
}
