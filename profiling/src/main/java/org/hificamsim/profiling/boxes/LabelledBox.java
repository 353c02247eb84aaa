package org.hificamsim.profiling.boxes;

/**
 * A labelled person, or a labelled thing that does not count.
 *
 * @param person the person's id in the recording; null if the labels have no ids
 * @param visibility the visible share by the labels, in [0, 1]; NaN if they have none
 * @param counted whether the detector has to find it; a box that finds another one is no false
 *     alarm
 */
record LabelledBox(String person, Box box, double visibility, boolean counted) {}
