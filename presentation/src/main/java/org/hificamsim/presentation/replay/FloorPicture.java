package org.hificamsim.presentation.replay;

import org.hificamsim.core.scenario.Field;

/**
 * A picture of the place, to be drawn under the field.
 *
 * @param area what it shows, metres
 * @param data the picture as a data URI, PNG or JPEG
 */
public record FloorPicture(Field area, String data) {}
