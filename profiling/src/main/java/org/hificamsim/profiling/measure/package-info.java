/** Measures every photo: ground-truth PIP, and the detectors' confidences. */
package org.hificamsim.profiling.measure;
