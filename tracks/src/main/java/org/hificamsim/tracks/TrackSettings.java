package org.hificamsim.tracks;

import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.scenario.spec.Extent;

/**
 * What becomes of the samples of a recording.
 *
 * @param gap the longest time between two samples of a target that is there meanwhile, seconds;
 *     three times the usual one by default
 * @param from where the recording is cut, seconds from its first sample
 * @param to where the recording is cut, seconds from its first sample
 * @param size of targets without a box
 * @param extent of such targets, where width and height are given; comes before the size
 */
public record TrackSettings(
    OptionalDouble gap, double from, double to, double size, Optional<Extent> extent) {}
