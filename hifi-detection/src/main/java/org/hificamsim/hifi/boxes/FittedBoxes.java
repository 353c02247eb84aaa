package org.hificamsim.hifi.boxes;

import org.hificamsim.hifi.FittedOn.Span;

/**
 * The labelled boxes that a model was fitted on.
 *
 * @param height heights of the boxes, in pixels
 * @param hidden hidden shares of the boxes
 * @param recordings the number of recordings
 * @param people the number of different people
 */
public record FittedBoxes(Span height, Span hidden, int recordings, int people) {}
