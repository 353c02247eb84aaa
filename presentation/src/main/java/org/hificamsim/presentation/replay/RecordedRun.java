package org.hificamsim.presentation.replay;

import java.util.List;

/**
 * One run as it was recorded.
 *
 * @param run the repeat, from 0
 * @param steps how many there were
 * @param every how many steps lie between two frames; the last step has a frame in any case
 * @param estimated what the agents' estimates are; empty where they have none
 * @param moves by step
 * @param frames by step
 */
public record RecordedRun(
    int run,
    long seed,
    long steps,
    long every,
    String estimated,
    List<Move> moves,
    List<Frame> frames) {}
