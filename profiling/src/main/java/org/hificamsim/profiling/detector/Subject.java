package org.hificamsim.profiling.detector;

import org.hificamsim.profiling.dataset.Patch;

/**
 * What a detector is asked for in a photo.
 *
 * @param object by its name
 * @param patch where it is
 */
public record Subject(String object, Patch patch) {}
