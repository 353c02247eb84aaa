package org.hificamsim.runs.benchmark;

/**
 * The most that a policy may take to play an episode.
 *
 * @param seconds by the clock, 1 or more
 * @param megabytes of memory, a quarter of which is Java's heap, 512 or more
 */
public record EpisodeLimits(int seconds, int megabytes) {}
