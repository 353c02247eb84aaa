package org.hificamsim.profiling.lab;

import org.opencv.core.Rect;

/** A picture's row in the data set. */
record LabRow(Shot shot, String image, String mask, Rect patch, Conditions conditions) {}
