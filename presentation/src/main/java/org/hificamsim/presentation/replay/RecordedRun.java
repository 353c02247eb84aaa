package org.hificamsim.presentation.replay;

import java.util.List;

/**
 * A recorded run.
 *
 * @param run the number of the repeat, from 0
 * @param steps the number of steps of the run
 * @param every the number of steps from one frame to the next; the last step always has a frame
 * @param estimated what the agents estimate; empty if they estimate nothing
 * @param moves the new poses of cameras, in the order of steps
 * @param frames the frames, in the order of steps
 */
public record RecordedRun(
    int run,
    long seed,
    long steps,
    long every,
    String estimated,
    List<Move> moves,
    List<Frame> frames) {}
