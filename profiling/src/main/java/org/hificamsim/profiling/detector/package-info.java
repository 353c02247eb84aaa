/** Feature detectors, and the confidence with which they find an object (chapter 5). */
package org.hificamsim.profiling.detector;
