package org.hificamsim.runs.benchmark;

/**
 * The most that a policy may take to play an episode.
 *
 * @param seconds the limit of time by the clock, in seconds, 1 or more
 * @param megabytes the limit of memory, in megabytes, a quarter of which is Java's heap, 512 or
 *     more
 */
public record EpisodeLimits(int seconds, int megabytes) {}
