/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Consensus by claims, with rebuild: 3 agents, 3 tasks, over links that lose, delay, repeat and
 * reorder, with a crash, a return, and burials of the living. docs/MODEL.md explains it;
 * verify.sh runs it. */
#ifndef TABLE
#define TABLE 1
#endif
#ifndef CRASHES
#define CRASHES 0 /* agents that may crash; each may return once */
#endif
#ifndef FALSE_BURIALS
#define FALSE_BURIALS 0 /* times that somebody may bury an agent that lives */
#endif
#ifndef LATE_MESSAGES
#define LATE_MESSAGES 0 /* times that everything one agent ever says at a moment may hang in the net */
#endif
#ifdef UNLUCKY /* the one agent that may crash, and whose messages may hang */
#define MAY_FAIL(i) ((i) == UNLUCKY)
#else
#define MAY_FAIL(i) 1
#endif
#ifndef MAX_VERSION
#define MAX_VERSION 31
#endif

#define N 3    /* agents */
#define T 3    /* tasks */
#define LATE N /* the row of the message that hangs in the net */

#include "tables.pml"

/* A key: incarnation, dead, version, compared in this order. 0: never heard. A life is a key
 * without its version. */
#define KEY(inc, dead, ver) ((inc) * 64 + (dead) * 32 + (ver))
#define INC(k) ((k) >> 6)
#define DEAD(k) (((k) >> 5) & 1)
#define VER(k) ((k) & 31)
#define LIFE(k) ((k) >> 5)

/* V: row k is what agent k holds; column x is the newest statement of agent x. A bundle is
 * first + 4 * second, each a task + 1 or 0. */
#define AT(k, x) ((k) * N + (x))
byte key[(N + 1) * N];
byte bundle[(N + 1) * N];
byte S[N + 1];     /* bit m: m is known to have been ready for exactly this row; 0: not ready */
bit undecided[N];  /* the view changed since the last decision */
bit up[N];         /* the process runs */
byte newest[N];    /* ghost: the newest life of each agent that was ever stated by anybody */
byte crashes = CRASHES, returns = CRASHES, false_burials = FALSE_BURIALS, late = LATE_MESSAGES;

/* ---- bids ---- */
#define C(i, n, j) score[12 * (i) + 3 * (n) + (j)]
#define FIRST(b) ((b) & 3)
#define SECOND(b) ((b) >> 2)
#ifdef MUTANT_NO_WARP
#define WARPED(i, first, gain) (gain)
#else
#define WARPED(i, first, gain) ((gain) < C(i, 0, (first) - 1) -> (gain) : C(i, 0, (first) - 1))
#endif
#define BID(x, b, j) \
  (FIRST(b) == (j) + 1 -> C(x, 0, j) : \
   (SECOND(b) == (j) + 1 -> WARPED(x, FIRST(b), C(x, FIRST(b), j)) : 0))

/* Scratch of deterministic steps: no part of the state. */
hidden byte y[T], z[T], m, n, j, gain, bid, chosen, made, taken, offer, offer_of, offered;
hidden byte plan[8 * N]; /* plan[8 agents x]: bundle of x when the members of the set share */

#define BEATS(b, i, j) ((b) > y[j] || ((b) == y[j] && (i) < z[j]))

/* Bundle::choose: among the tasks whose bid wins, the highest true gain, then the lowest id. */
inline choose(i, first) {
  chosen = 0; gain = 0; j = 0;
  do
  :: j < T ->
     bid = (first -> WARPED(i, first, C(i, first, j)) : C(i, 0, j));
     if
     :: first != j + 1 && C(i, first, j) > gain && BEATS(bid, i, j) ->
        gain = C(i, first, j); chosen = j + 1
     :: else
     fi;
     j++
  :: else -> break
  od
}

/* best_claims: for every task the best claim of the others that live; lower ids win ties. */
inline best_claims(i) {
  j = 0;
  do
  :: j < T ->
     y[j] = 0; z[j] = N; m = 0;
     do
     :: m < N ->
        bid = BID(m, bundle[AT(i, m)], j);
        if
        :: m != i && !DEAD(key[AT(i, m)]) && bid > y[j] -> y[j] = bid; z[j] = m
        :: else
        fi;
        m++
     :: else -> break
     od;
     j++
  :: else -> break
  od
}

/* ---- the oracle: sequential greedy allocation among a set of agents, no views, no messages ---- */
inline sequential_greedy(set) {
  j = 0;
  do :: j < T -> y[j] = 0; z[j] = N; j++ :: else -> break od; /* nobody is a rival */
  m = 0;
  do :: m < N -> plan[(set) * N + m] = 0; m++ :: else -> break od;
  taken = 0; n = 0;
  do
  :: n < T -> /* everybody offers what it would like best; the highest bid is accepted */
     offer = 0; m = 0;
     do
     :: m < N ->
        made = plan[(set) * N + m];
        if
        :: ((set) >> m) & 1 && !SECOND(made) ->
           gain = 0; chosen = 0; j = 0;
           do
           :: j < T ->
              if
              :: !((taken >> j) & 1) && C(m, made, j) > gain -> gain = C(m, made, j); chosen = j + 1
              :: else
              fi;
              j++
           :: else -> break
           od;
           bid = (made -> WARPED(m, made, gain) : gain);
           if :: chosen && bid > offer -> offer = bid; offer_of = m; offered = chosen :: else fi
        :: else
        fi;
        m++
     :: else -> break
     od;
     if
     :: offer ->
        made = plan[(set) * N + offer_of];
        plan[(set) * N + offer_of] = (made -> made + 4 * offered : offered);
        taken = taken | (1 << (offered - 1))
     :: else
     fi;
     n++
  :: else -> break
  od
}

#include "properties.pml"

/* ---- what an agent does ---- */
inline view_changed(i) {
  undecided[i] = 1;
#ifdef MUTANT_READY_EARLY
  S[i] = 1 << i
#else
  S[i] = 0
#endif
}

inline life_begins(x, life) { /* or ends: a tombstone */
  if :: (life) > newest[x] -> newest[x] = life :: else fi
}

hidden byte L1_minds_settle; /* no schedule makes an agent change its bundle again and again */

inline decide(i) {
  best_claims(i);
  choose(i, 0);
  made = chosen;
  if :: made -> choose(i, made); made = made + 4 * chosen :: else fi;
  if
  :: made != bundle[AT(i, i)] ->
     L1_minds_settle = VER(key[AT(i, i)]) < MAX_VERSION;
     assert(L1_minds_settle);
     key[AT(i, i)]++;
     bundle[AT(i, i)] = made;
     S[i] = 1 << i
  :: else -> S[i] = S[i] | (1 << i)
  fi;
  undecided[i] = 0
}

/* With RENUMBER (no faults), versions that everybody holds start again from 1: only their order
 * matters, and a livelock becomes a true cycle. */
inline renumber(x) {
#ifdef RENUMBER
  if
  :: key[AT(0, x)] == key[AT(1, x)] && key[AT(1, x)] == key[AT(2, x)] ->
     key[AT(0, x)] = KEY(1, 0, 1); key[AT(1, x)] = KEY(1, 0, 1); key[AT(2, x)] = KEY(1, 0, 1)
  :: else
  fi
#else
  skip
#endif
}

/* Agent i meets the statement of x that row k holds, and it is news. About itself: an old life or
 * a tombstone, which it refutes by a new life. */
inline learn(i, k, x) {
  if
  :: x == i ->
     assert(INC(key[AT(k, i)]) < 3); /* what a key has room for */
     key[AT(i, i)] = KEY(INC(key[AT(k, i)]) + 1, 0, 1);
     life_begins(i, LIFE(key[AT(i, i)]))
  :: else ->
     key[AT(i, x)] = key[AT(k, x)];
     bundle[AT(i, x)] = bundle[AT(k, x)]
  fi;
  view_changed(i);
  renumber(x)
}

inline bury(i, x) {
  key[AT(i, x)] = key[AT(i, x)] + KEY(0, 1, 0);
  bundle[AT(i, x)] = 0;
  life_begins(x, LIFE(key[AT(i, x)]));
  view_changed(i)
}

inline forget(k) {
  n = 0;
  do :: n < N -> key[AT(k, n)] = 0; bundle[AT(k, n)] = 0; n++ :: else -> break od;
  S[k] = 0
}

#ifdef MUTANT_SAME_INCARNATION
#define NEXT_INCARNATION(i) 1
#else
#define NEXT_INCARNATION(i) ((newest[i] >> 1) + 1) /* as a clock at birth would say */
#endif

inline start(i, inc) {
  assert((inc) <= 3);
  up[i] = 1;
  key[AT(i, i)] = KEY(inc, 0, 1);
  undecided[i] = 1;
  life_begins(i, LIFE(key[AT(i, i)]))
}

/* ---- processes: every step is atomic and is taken at any time that it is possible ---- */
proctype agent(byte i) {
end:
  do
  :: d_step { up[i] && undecided[i] -> decide(i); check() }
  :: d_step { up[i] && MISSED(i, (i + 1) % N) -> bury(i, (i + 1) % N); check() }
  :: d_step { up[i] && MISSED(i, (i + 2) % N) -> bury(i, (i + 2) % N); check() }
#if FALSE_BURIALS
  :: d_step { up[i] && false_burials && ALIVE_AND_WELL(i, (i + 1) % N) ->
              false_burials--; bury(i, (i + 1) % N); check() }
  :: d_step { up[i] && false_burials && ALIVE_AND_WELL(i, (i + 2) % N) ->
              false_burials--; bury(i, (i + 2) % N); check() }
#endif
#if CRASHES
  :: d_step { up[i] && crashes && MAY_FAIL(i) -> crashes--;
              up[i] = 0; undecided[i] = 0; forget(i); check() }
  :: d_step { !up[i] && returns -> returns--; start(i, NEXT_INCARNATION(i)); check() }
#endif
#if LATE_MESSAGES
  :: d_step { up[i] && late && MAY_FAIL(i) -> late--; n = 0;
              do
              :: n < N -> key[AT(LATE, n)] = key[AT(i, n)]; bundle[AT(LATE, n)] = bundle[AT(i, n)]; n++
              :: else -> break
              od;
              S[LATE] = S[i]; check() }
#endif
  od
}

/* Everything that row `from` holds may reach agent `to`, in any order, any number of times, or
 * never: bids and relays (a statement each), and status messages (S). */
proctype link(byte from, to) {
end:
  do
  :: d_step { NEWS(from, to, 0) -> learn(to, from, 0); check() }
  :: d_step { NEWS(from, to, 1) -> learn(to, from, 1); check() }
  :: d_step { NEWS(from, to, 2) -> learn(to, from, 2); check() }
  :: d_step { STATUS_IS_NEWS(from, to) -> S[to] = S[to] | S[from]; check() }
  od
}

init {
  d_step {
    sequential_greedy(1); sequential_greedy(2); sequential_greedy(3); sequential_greedy(4);
    sequential_greedy(5); sequential_greedy(6); sequential_greedy(7);
    start(0, 1); start(1, 1); start(2, 1);
#ifdef INTRODUCED /* everybody has heard everybody's first, empty statement */
    n = 0;
    do :: n < N * N -> key[n] = KEY(1, 0, 1); n++ :: else -> break od
#endif
  };
  atomic {
    run agent(0); run agent(1); run agent(2);
    run link(1, 0); run link(2, 0); run link(0, 1); run link(2, 1); run link(0, 2); run link(1, 2);
#if LATE_MESSAGES
    run link(LATE, 0); run link(LATE, 1); run link(LATE, 2)
#endif
  }
}
