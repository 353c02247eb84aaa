/** Predicted sizes of targets in a picture, checked against boxes of a real camera. */
package org.hificamsim.profiling.check;
