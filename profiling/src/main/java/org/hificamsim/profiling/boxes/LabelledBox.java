package org.hificamsim.profiling.boxes;

/**
 * A person, or something that is not to be found, as somebody labelled it.
 *
 * @param person the person's id in the recording; null if the labels have no ids
 * @param visibility the visible share by the labels, in [0, 1]; NaN if they have none
 * @param counted whether the detector has to find it; a box that finds another one is no false
 *     alarm
 */
record LabelledBox(String person, Box box, double visibility, boolean counted) {}
