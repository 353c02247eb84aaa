/** OpenCV: its native library and the memory of its images. */
package org.hificamsim.profiling.opencv;
