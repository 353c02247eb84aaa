/** From photos of a target to a fitted detection model; the only module with computer vision. */
package org.hificamsim.profiling;
