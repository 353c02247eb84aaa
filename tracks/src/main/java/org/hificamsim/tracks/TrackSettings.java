package org.hificamsim.tracks;

import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.scenario.spec.Extent;

/**
 * The settings by which samples of a recording become tracks.
 *
 * @param gap the longest time between two samples of a target that is present meanwhile, in
 *     seconds; three times the usual time by default
 * @param from the start of the part that is kept, in seconds from the first sample
 * @param to the end of the part that is kept, in seconds from the first sample
 * @param size size of targets without a box, in metres
 * @param extent extent of targets without a box; if present, it replaces the size
 */
public record TrackSettings(
    OptionalDouble gap, double from, double to, double size, Optional<Extent> extent) {}
