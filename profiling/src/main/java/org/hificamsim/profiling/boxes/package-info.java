/** Labelled recordings and the boxes of a detector, measured and fitted. */
package org.hificamsim.profiling.boxes;
