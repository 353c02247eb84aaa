/** What the detectors make of every photo: ground-truth PIP and confidences. */
package org.hificamsim.profiling.measure;
