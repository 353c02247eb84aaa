/** Detector models g: the confidence of a detector from the patch's share of the image. */
package org.hificamsim.hifi.detector;
