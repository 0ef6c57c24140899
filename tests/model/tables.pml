/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Score tables: c[12 i + 3 n + j] is the marginal score of task j for agent i whose bundle holds
 * nothing (n = 0) or task n - 1 (n = 1 .. 3). Higher is better; 0 where the task is held already. */
hidden byte score[36] = {
#if TABLE == 1 /* diminishing: everybody wants task 0, then 1; every win makes a loser move on */
  9, 8, 3,   0, 6, 2,   7, 0, 2,   6, 5, 0,
  8, 7, 5,   0, 7, 4,   6, 0, 3,   5, 4, 0,
  7, 6, 6,   0, 5, 5,   4, 0, 5,   3, 2, 0
#elif TABLE == 2 /* diminishing, all ties: only the agent id and the task id decide */
  4, 4, 4,   0, 3, 3,   3, 0, 3,   3, 3, 0,
  4, 4, 4,   0, 3, 3,   3, 0, 3,   3, 3, 0,
  4, 4, 4,   0, 3, 3,   3, 0, 3,   3, 3, 0
#elif TABLE == 3 /* not diminishing: agents 0 and 1 would outbid each other for ever without warp */
  6, 6, 1,   0, 7, 1,   4, 0, 1,   1, 1, 0,
  2, 2, 1,   0, 9, 1,   7, 0, 1,   1, 1, 0,
  1, 1, 1,   0, 1, 1,   1, 0, 1,   1, 1, 0
#elif TABLE == 4 /* diminishing: the agents' wishes form a ring */
  9, 7, 5,   0, 7, 1,   5, 0, 5,   6, 4, 0,
  5, 8, 7,   0, 6, 5,   4, 0, 7,   3, 6, 0,
  8, 5, 6,   0, 4, 6,   6, 0, 4,   7, 3, 0
#else
#error "TABLE must be 1 to 4"
#endif
};
