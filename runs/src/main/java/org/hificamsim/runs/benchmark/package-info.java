/**
 * The benchmark: frozen tasks, entries with their actions, the check of entries, the leaderboard.
 */
package org.hificamsim.runs.benchmark;
